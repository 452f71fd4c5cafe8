#pragma once

#include <QMenu>

class QUndoStack;

namespace chiaro::app {

/// Undo and redo of the document's edits.
class EditMenu : public QMenu {
    Q_OBJECT

public:
    EditMenu(QUndoStack& stack, QWidget& window);
};

}  // namespace chiaro::app
