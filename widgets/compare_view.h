#pragma once

#include "widgets/pane_label.h"
#include "widgets/viewport/composition.h"

#include <QWidget>

namespace chiaro::widgets {

class Viewport;

/// Lies over a viewport that compares methods: names each picture's method with its figures, and draws the
/// line of a wipe. The line is dragged by itself or its middle, and turned by its two outer handles, with
/// Shift in steps of 15 degrees; with the focus arrows move it, Page Up and Page Down turn it, Home puts it
/// back. Whatever else the pointer does goes to the viewport.
class CompareView : public QWidget {
    Q_OBJECT

public:
    /// Belongs to the viewport. `methods` are those that there are.
    CompareView(Viewport& viewport, const std::vector<NamedMethod>& methods);

    /// What the viewport shows.
    void setComposition(const Composition& composition);
    /// The method whose parameters are edited; its label is marked.
    void setActiveMethod(const std::string& key);
    /// What the label of a picture tells beside the name: one an entry.
    void setFigures(std::size_t picture, const QStringList& figures);
    const PaneLabel& label(std::size_t picture) const { return *m_labels[picture]; }

    enum class Handle { None, Line, Start, End };
    /// What of the line a press there would take.
    Handle handleAt(QPointF position) const;
    /// Where the line's handles are: its middle for Line.
    QPointF handlePosition(Handle handle) const;

Q_SIGNALS:
    void compositionEdited(const chiaro::widgets::Composition& composition);
    void methodChosen(int picture, const QString& key);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    bool isWiping() const { return m_composition.mode == Composition::Mode::Wipe; }
    glm::dvec2 along() const;
    void drag(QPointF position, Qt::KeyboardModifiers modifiers);
    void edit(const Composition& composition);
    void showCursor(QPointF position);
    void placeLabels();
    void drawLine(QPainter& painter) const;

    Viewport& m_viewport;
    Composition m_composition;
    std::string m_active;
    std::vector<PaneLabel*> m_labels;
    Handle m_dragged = Handle::None;
    QPointF m_grip;  ///< from the line's middle to where it was taken
};

}  // namespace chiaro::widgets
