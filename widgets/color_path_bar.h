#pragma once

#include "core/gradient/color_path.h"

#include <QWidget>

namespace chiaro::widgets {

/// A colour path as a bar with a handle under each stop. Ctrl+click or Insert adds a stop, a drag moves it
/// (past others, if need be; Escape takes it back), a double click asks for its colour, Delete removes it;
/// Page Up and Page Down select, Left and Right nudge; the keys to copy and paste ask for that.
///
/// Stops are kept in order of position; the last one can't be removed.
class ColorPathBar : public QWidget {
    Q_OBJECT

public:
    explicit ColorPathBar(QWidget* parent = nullptr);

    void setPath(const gradient::ColorPath& path);
    const gradient::ColorPath& path() const { return m_path; }
    /// Shown in place of the stops' colours while the bar is disabled.
    void setOwnColors(const std::vector<glm::vec3>& colors);

    /// An index into the path's stops; -1 when there is none.
    int selected() const { return m_selected; }
    void select(int stop);
    void moveSelected(float position);
    void recolorSelected(glm::vec3 color);
    void removeSelected();
    /// A stop of the colour that the path has there.
    void add(float position);
    /// Halfway between the selected stop and the next, or the one before.
    void addBesideSelected();

    double toWidget(float position) const;
    float toPosition(double x) const;
    /// Where the handle of a stop is held.
    QPointF handle(int stop) const;

    QSize sizeHint() const override { return {280, 62}; }
    QSize minimumSizeHint() const override { return {160, 62}; }

Q_SIGNALS:
    void pathEdited(const chiaro::gradient::ColorPath& path);
    void editFinished();
    void selectionChanged(int stop);
    void colorWanted(int stop);
    void copyWanted();
    void pasteWanted();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    QRectF barArea() const;
    int stopAt(QPointF position) const;
    void insert(gradient::ColorPath path, gradient::ColorStop stop);
    void edit(const gradient::ColorPath& path);
    void finishNudge();
    void paintHandle(QPainter& painter, int stop) const;

    gradient::ColorPath m_path;
    std::vector<glm::vec3> m_ownColors;
    int m_selected = -1;
    bool m_dragging = false;
    gradient::ColorPath m_pressedPath;  ///< before the drag
    int m_pressedStop = -1;
    bool m_nudged = false;
    double m_grip = 0;  ///< from the pointer to the handle it holds, px
};

}  // namespace chiaro::widgets
