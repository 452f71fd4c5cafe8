#pragma once

#include <QDockWidget>

class QUndoStack;

namespace chiaro::app {

/// Every edit of the document; a click goes back or forth to it.
class HistoryDock : public QDockWidget {
    Q_OBJECT

public:
    explicit HistoryDock(QUndoStack& stack);
};

}  // namespace chiaro::app
