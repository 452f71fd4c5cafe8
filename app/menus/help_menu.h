#pragma once

#include <QMenu>

namespace chiaro::app {

class HelpWindow;

/// The help's pages, and what the studio is.
class HelpMenu : public QMenu {
    Q_OBJECT

public:
    explicit HelpMenu(QWidget& window);

private:
    void open(const QString& page);

    QWidget& m_window;
    HelpWindow* m_help = nullptr;  ///< none until it is asked for
};

}  // namespace chiaro::app
