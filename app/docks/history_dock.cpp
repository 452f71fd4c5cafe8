#include "app/docks/history_dock.h"

#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::app {

HistoryDock::HistoryDock(QUndoStack& stack) : QDockWidget(tr("History")) {
    setObjectName("history-dock");
    auto* view = new QUndoView(&stack);
    view->setObjectName("history");
    view->setAccessibleName(tr("History"));
    view->setEmptyLabel(tr("As it was opened"));
    view->setCleanIcon(widgets::icon("save"));
    view->setToolTip(tr("A click goes back or forth to an edit; the disk marks what is saved"));
    view->setIconSize({16, 16});
    view->setMinimumHeight(72);
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(10, 8, 10, 8);
    layout->addWidget(view);
    setWidget(content);
}

}  // namespace chiaro::app
