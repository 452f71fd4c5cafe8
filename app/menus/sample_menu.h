#pragma once

#include <QMenu>

namespace chiaro::app {

class Document;
class SampleDock;

/// What can be done to the current sample; greyed while there is none.
class SampleMenu : public QMenu {
    Q_OBJECT

public:
    SampleMenu(Document& document, SampleDock& dock, QWidget& window);

Q_SIGNALS:
    /// Whatever was cancelled or failed is to be made after all.
    void synthesisWanted();
};

}  // namespace chiaro::app
