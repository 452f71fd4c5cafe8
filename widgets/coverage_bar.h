#pragma once

#include <QWidget>

#include <optional>

namespace chiaro::views {
struct CoverageReport;
}

namespace chiaro::widgets {

/// How well a plan covers its object, in faces: those of the first pass solid, those of further ones
/// striped, those that no view can show hollow; the same in words below.
class CoverageBar : public QWidget {
    Q_OBJECT

public:
    explicit CoverageBar(QWidget* parent = nullptr);

    /// Null while nothing is known.
    void setReport(const views::CoverageReport* report);
    const QString& text() const { return m_text; }

    QSize sizeHint() const override { return {280, 10 + 4 + fontMetrics().height()}; }
    QSize minimumSizeHint() const override { return {160, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Shares of the object's faces, in [0, 1].
    struct Shares {
        double first = 0;
        double further = 0;
    };
    std::optional<Shares> m_shares;
    QString m_text;
};

}  // namespace chiaro::widgets
