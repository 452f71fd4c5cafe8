#pragma once

#include "core/base/image.h"
#include "core/gradient/gradient.h"

#include <QImage>
#include <QWidget>

#include <optional>

namespace chiaro::widgets {

/// A strip taken apart, in pictures small enough to redraw while the artist drags.
struct StripPictures {
    ColorImage strip;             ///< at most 1024 x 192 px
    ColorImage texture;           ///< as large, in [-1, 1]
    gradient::Gradient averages;  ///< one a column of the strip itself
    gradient::Gradient gradient;  ///< G(u(x)), as many

    /// Reduces the strip and its separation; worth a thread for large strips.
    static StripPictures of(const ColorImage& strip, const gradient::Separation& separation);
};

/// The stages of §3 one below the other: strip, column averages, gradient, texture (+0.5), recoloured strip.
class StripView : public QWidget {
    Q_OBJECT

public:
    explicit StripView(QWidget* parent = nullptr);

    /// Null empties the view.
    void setPictures(std::shared_ptr<const StripPictures> pictures);
    /// The gradient to recolour with, of any length; empty for the strip's own.
    void setRecoloring(const gradient::Gradient& gradient);

    /// The colour, RGB in [0, 1], of the picture that is shown at a place on this widget; nothing beside
    /// them.
    std::optional<glm::vec3> colorAt(QPointF position) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {160, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Row {
        QString caption;
        QString tooltip;
        QImage picture;
        int height = 0;
    };
    bool event(QEvent* event) override;
    int rowHeight(int row) const;
    QRect pictureArea(const Row& row, int top) const;
    void paintRow(QPainter& painter, const Row& row, int top) const;

    std::shared_ptr<const StripPictures> m_pictures;
    std::array<Row, 5> m_rows;
};

}  // namespace chiaro::widgets
