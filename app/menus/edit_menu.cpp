#include "app/menus/edit_menu.h"

#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::app {

EditMenu::EditMenu(QUndoStack& stack, QWidget& window) : QMenu(tr("&Edit"), &window) {
    QAction* undo = stack.createUndoAction(this, tr("&Undo"));
    undo->setIcon(widgets::icon("undo"));
    undo->setShortcuts(QKeySequence::Undo);
    QAction* redo = stack.createRedoAction(this, tr("&Redo"));
    redo->setIcon(widgets::icon("redo"));
    redo->setShortcuts(QKeySequence::Redo);
    addActions({undo, redo});
}

}  // namespace chiaro::app
