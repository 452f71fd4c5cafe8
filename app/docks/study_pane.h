#pragma once

#include "app/metric_sheet.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace chiaro::widgets {
class MetricLegend;
class MetricRow;
}  // namespace chiaro::widgets

namespace chiaro::app {

class DistortionStudy;

/// How the metric answers to distortions (§5.1, figures 4 to 6): a chart a block size, a curve a texture.
class StudyPane : public QWidget {
    Q_OBJECT

public:
    explicit StudyPane(DistortionStudy& study, QWidget* parent = nullptr);

    MetricSheet sheet() const;
    widgets::MetricRow* row() const { return m_row; }
    /// The name of the distortion that is shown, for files.
    QString distortionName() const;

private:
    QWidget* makeTools();
    metrics::Distortion distortion() const;
    void show();
    void showProgress();

    DistortionStudy& m_study;
    QPushButton* m_measure = nullptr;
    QComboBox* m_distortions = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_note = nullptr;
    widgets::MetricLegend* m_legend = nullptr;
    widgets::MetricRow* m_row = nullptr;
    QLabel* m_hint = nullptr;
};

}  // namespace chiaro::app
