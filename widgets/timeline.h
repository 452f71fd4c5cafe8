#pragma once

#include <QWidget>

#include <optional>
#include <vector>

namespace chiaro::widgets {

/// Frames from left to right: a ruler with the current frame and the range that is rendered, and below it a
/// lane of keys for each thing that moves.
///
/// It shows what the setters gave last and changes nothing by itself: whoever owns the frames and keys hears
/// what the artist wants. Dragging the ruler goes through the frames; dragging a key moves it; dragging an
/// end of the range moves that. Keys: left and right step, with Shift by ten, Home and End go to the ends, up
/// and down from key to key, Delete removes the selected key.
class Timeline : public QWidget {
    Q_OBJECT

public:
    struct Lane {
        QString name;
        std::vector<int> keys;  ///< frames, rising
        friend bool operator==(const Lane&, const Lane&) = default;
    };
    struct Key {
        int lane = 0;
        int frame = 1;
        friend bool operator==(const Key&, const Key&) = default;
    };

    explicit Timeline(QWidget* parent = nullptr);

    /// Frames 1 to `frames`, of which `first` to `last` are rendered.
    void setFrames(int frames, int first, int last);
    void setLanes(std::vector<Lane> lanes);
    void setCurrentFrame(int frame);
    int currentFrame() const { return m_current; }
    const std::vector<Lane>& lanes() const { return m_lanes; }

    std::optional<Key> selectedKey() const { return m_selected; }
    /// The nearest key of any lane before or after the current frame.
    std::optional<int> keyBefore() const;
    std::optional<int> keyAfter() const;

    /// Where a frame lies; widget pixels.
    double positionOf(int frame) const;
    QPointF positionOf(const Key& key) const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void currentFrameEdited(int frame);
    void rangeEdited(int first, int last);
    void keyMoved(int lane, int from, int to);  ///< many in a row while a key is dragged
    void keyRemoveWanted(int lane, int frame);
    void selectionChanged();
    /// What was edited since the last time is one step for the artist.
    void editFinished();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Drag { None, Frame, Key, First, Last };

    int frameAt(double x) const;
    std::optional<Key> keyAt(QPointF position) const;
    Drag rangeEndAt(QPointF position) const;
    void select(std::optional<Key> key);
    void dragTo(double x);
    void paintRuler(QPainter& painter) const;
    void paintLanes(QPainter& painter) const;
    double left() const;
    double right() const;

    int m_frames = 1;
    int m_first = 1;
    int m_last = 1;
    int m_current = 1;
    std::vector<Lane> m_lanes;
    std::optional<Key> m_selected;
    Drag m_drag = Drag::None;
};

}  // namespace chiaro::widgets
