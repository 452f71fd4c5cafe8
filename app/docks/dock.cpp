#include "app/docks/dock.h"

#include "app/dropped_files.h"

#include <QtWidgets>

namespace chiaro::app {

Dock::Dock(const QString& name, const QString& title, QWidget* content) : QDockWidget(title) {
    setObjectName(name);
    auto* scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);  // it follows the focus of what it holds
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    setWidget(scroll);
    content->installEventFilter(this);
}

bool Dock::eventFilter(QObject* watched, QEvent* event) {
    // It scrolls up and down only, so it is never narrower than its content.
    if (event->type() == QEvent::LayoutRequest) {
        const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
        widget()->setMinimumWidth(static_cast<QWidget*>(watched)->minimumSizeHint().width() + bar);
    }
    return QDockWidget::eventFilter(watched, event);
}

void Dock::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void Dock::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    Q_EMIT filesDropped(localFiles(*event->mimeData()));
}

}  // namespace chiaro::app
