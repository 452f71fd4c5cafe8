#pragma once

#include <QMenu>

namespace chiaro::app {

/// What the studio is.
class HelpMenu : public QMenu {
    Q_OBJECT

public:
    explicit HelpMenu(QWidget& window);
};

}  // namespace chiaro::app
