#include "widgets/eyedropper.h"

#include "widgets/picture.h"
#include "widgets/strip_view.h"

#include <QtWidgets>

namespace chiaro::widgets {

Eyedropper::Eyedropper(QWidget* owner) : QObject(owner), m_owner(owner) {}

void Eyedropper::start() {
    if (m_active) return;
    m_active = true;
    m_owner->installEventFilter(this);
    m_owner->grabMouse(Qt::CrossCursor);
    m_owner->grabKeyboard();
    m_owner->setMouseTracking(true);
    hover(QCursor::pos());
}

void Eyedropper::end() {
    m_active = false;
    m_owner->removeEventFilter(this);
    m_owner->releaseKeyboard();
    m_owner->releaseMouse();
}

void Eyedropper::cancel() {
    if (!m_active) return;
    end();
    Q_EMIT cancelled();
}

std::optional<glm::vec3> Eyedropper::colorAt(QPoint global) {
    QWidget* under = QApplication::widgetAt(global);
    if (const auto* strip = qobject_cast<StripView*>(under))
        if (const auto color = strip->colorAt(strip->mapFromGlobal(QPointF(global)))) return color;
    if (QScreen* screen = QGuiApplication::screenAt(global)) {
        const QPoint inside = global - screen->geometry().topLeft();
        const QImage pixel = screen->grabWindow(0, inside.x(), inside.y(), 1, 1).toImage();
        if (!pixel.isNull()) return fromColor(pixel.pixelColor(0, 0));
    }
    // Some systems tell nobody what is on the screen; the studio's own windows can still be asked.
    if (under == nullptr) return std::nullopt;
    const QImage pixel = under->grab(QRect(under->mapFromGlobal(global), QSize(1, 1))).toImage();
    return pixel.isNull() ? std::nullopt : std::optional(fromColor(pixel.pixelColor(0, 0)));
}

void Eyedropper::hover(QPoint global) {
    if (const auto color = colorAt(global)) Q_EMIT hovered(*color);
}

void Eyedropper::pick(QPoint global) {
    const auto color = colorAt(global);
    if (!color) return cancel();
    end();
    Q_EMIT picked(*color);
}

bool Eyedropper::takeKey(int key, Qt::KeyboardModifiers modifiers) {
    const int step = modifiers & Qt::ShiftModifier ? 10 : 1;
    QPoint by;
    switch (key) {
        case Qt::Key_Escape:
            cancel();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            pick(QCursor::pos());
            return true;
        case Qt::Key_Left:
            by.setX(-step);
            break;
        case Qt::Key_Right:
            by.setX(step);
            break;
        case Qt::Key_Up:
            by.setY(-step);
            break;
        case Qt::Key_Down:
            by.setY(step);
            break;
        default:
            return true;  // no key does anything else meanwhile
    }
    QCursor::setPos(QCursor::pos() + by);
    hover(QCursor::pos());
    return true;
}

bool Eyedropper::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseMove:
            hover(static_cast<QMouseEvent*>(event)->globalPosition().toPoint());
            return true;
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
            return true;
        case QEvent::MouseButtonRelease: {
            const auto* mouse = static_cast<QMouseEvent*>(event);
            if (mouse->button() == Qt::LeftButton)
                pick(mouse->globalPosition().toPoint());
            else
                cancel();
            return true;
        }
        case QEvent::ShortcutOverride:
            event->accept();
            return true;
        case QEvent::KeyPress: {
            const auto* key = static_cast<QKeyEvent*>(event);
            return takeKey(key->key(), key->modifiers());
        }
        case QEvent::KeyRelease:
            return true;
        case QEvent::Hide:
            cancel();
            break;
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace chiaro::widgets
