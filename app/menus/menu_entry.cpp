#include "app/menus/menu_entry.h"

#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::app {

QAction* addEntry(QMenu& menu, const char* icon, const QString& text, const QKeySequence& keys,
                  const std::function<void()>& triggered) {
    QAction* action = menu.addAction(text);
    if (icon != nullptr) action->setIcon(widgets::icon(icon));
    action->setShortcut(keys);
    QObject::connect(action, &QAction::triggered, &menu, triggered);
    return action;
}

}  // namespace chiaro::app
