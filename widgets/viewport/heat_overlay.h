#pragma once

#include "core/base/image.h"
#include "widgets/viewport/composition.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace chiaro::widgets {

/// A strip small enough to draw beside the pointer.
struct HeatStrip {
    QImage picture;
    QSize size;  ///< of the strip itself, pixels
};

/// How well the pixels of a viewport's picture resemble their strips. Immutable, to share.
struct HeatMap {
    QString title;                    ///< "Similarity error"
    ScalarImage values;               ///< one a device pixel; negative: nothing was measured there
    float most = 0.01F;               ///< the value at the bright end of the colours; the dark end is 0
    Image<glm::i16vec2> best;         ///< pixel of the strip that resembles it most; (-1, -1): none
    IdImage objects;                  ///< 0 outside, 1.. the object
    std::vector<HeatStrip> strips{};  ///< [k - 1] is what object k wears
    QImage picture;                   ///< the values as colours, clear where there is none

    /// Makes the picture of the values.
    void paint();
};

/// Lies over a viewport's picture: a map of errors, a bar that tells which value a colour stands for, and
/// beside the pointer the value there and where in the strip its best match lies. What the pointer does goes
/// on to the viewport.
class HeatOverlay : public QWidget {
    Q_OBJECT

public:
    explicit HeatOverlay(QWidget* parent = nullptr);

    /// Null while there is none.
    void setMap(std::shared_ptr<const HeatMap> map) { setMaps({std::move(map)}); }
    /// One a pane; their colours mean the same values. None of them is null, or all are.
    void setMaps(std::vector<std::shared_ptr<const HeatMap>> maps);
    /// Where the pictures are that the maps are of; all of the widget at first.
    void setPanes(std::vector<Pane> panes);
    /// What is being measured, and how far that is, in [0, 1]; none: nothing is.
    void setProgress(const QString& text, std::optional<double> progress);

    struct Reading {
        float value = 0;
        std::uint16_t object = 0;
        glm::ivec2 best{0};
        std::size_t pane = 0;
    };
    /// At a place of the widget; none where nothing was measured.
    std::optional<Reading> reading(QPointF position) const;

protected:
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    const HeatMap* map() const { return m_maps.empty() ? nullptr : m_maps.front().get(); }
    std::vector<Pane> panes() const;
    /// Of the pane that is seen there.
    std::optional<std::size_t> mapAt(QPointF position) const;
    QRectF panel() const;
    void drawPanel(QPainter& painter) const;
    void drawBar(QPainter& painter, const QRectF& bar) const;
    void drawReading(QPainter& painter, const Reading& reading) const;

    std::vector<std::shared_ptr<const HeatMap>> m_maps;
    std::vector<Pane> m_panes;
    QString m_text;
    std::optional<double> m_progress;
    std::optional<QPointF> m_pointer;
};

}  // namespace chiaro::widgets
