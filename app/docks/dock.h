#pragma once

#include <QDockWidget>

namespace chiaro::app {

/// A dock whose content scrolls when there is no room for it, and which the window's state remembers by name.
class Dock : public QDockWidget {
    Q_OBJECT

public:
    Dock(const QString& name, const QString& title, QWidget* content);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace chiaro::app
