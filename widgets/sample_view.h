#pragma once

#include "core/sample/strip.h"

#include <QWidget>

class QToolButton;

namespace chiaro::widgets {

class CropCanvas;
class ParameterForm;

/// The scan and how it becomes the strip (§3): crop by dragging, quarter turns, mirror, scale.
///
/// Shows what it was given; emits what the artist wants, one editFinished() a drag or click.
class SampleView : public QWidget {
    Q_OBJECT

public:
    explicit SampleView(QWidget* parent = nullptr);

    /// The scan, or a smaller copy of it, and the scan's own size in pixels. A null picture empties the view.
    void setScan(const QImage& picture, QSize scanSize);
    void setParams(const sample::StripParams& params);
    CropCanvas* canvas() const { return m_canvas; }

public Q_SLOTS:
    /// Quarter turns clockwise; negative ones turn back.
    void turn(int quarters);
    void mirror();
    void resetCrop();

Q_SIGNALS:
    void paramsEdited(const chiaro::sample::StripParams& params);
    void editFinished();

private:
    void edit(const sample::StripParams& params);
    void showParams();

    sample::StripParams m_params;
    CropCanvas* m_canvas = nullptr;
    QToolButton* m_mirror = nullptr;
    QToolButton* m_resetCrop = nullptr;
    ParameterForm* m_scale = nullptr;
};

}  // namespace chiaro::widgets
