#pragma once

#include <glm/glm.hpp>

#include <QObject>
#include <QPoint>

#include <optional>

class QWidget;

namespace chiaro::widgets {

/// Takes a colour from anywhere on the screen; from a strip's picture as it is, not as the screen shows it.
///
/// While it is active the pointer is a cross: a click picks what is under it, the arrow keys move it by a
/// pixel (Shift: ten) and Enter picks; Escape or the right button ends it without a colour.
class Eyedropper : public QObject {
    Q_OBJECT

public:
    /// `owner` is shown while it is active and hears the pointer and the keys meanwhile.
    explicit Eyedropper(QWidget* owner);

    void start();
    bool isActive() const { return m_active; }
    void cancel();

    /// RGB in [0, 1] at a place on the screen; nothing where the system doesn't tell.
    static std::optional<glm::vec3> colorAt(QPoint global);

Q_SIGNALS:
    /// What would be picked here.
    void hovered(glm::vec3 color);
    void picked(glm::vec3 color);
    void cancelled();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void hover(QPoint global);
    void pick(QPoint global);
    bool takeKey(int key, Qt::KeyboardModifiers modifiers);
    void end();

    QWidget* m_owner;
    bool m_active = false;
};

}  // namespace chiaro::widgets
