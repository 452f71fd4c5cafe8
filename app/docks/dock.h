#pragma once

#include <QDockWidget>

namespace chiaro::app {

/// A dock whose content scrolls when there is no room for it, and which the window's state remembers by name.
class Dock : public QDockWidget {
    Q_OBJECT

public:
    Dock(const QString& name, const QString& title, QWidget* content);

Q_SIGNALS:
    /// Something that the artist asked for could not be done: a sentence.
    void failed(const QString& message);
    /// Of a dock that takes files.
    void filesDropped(const QStringList& paths);

protected:
    /// Files may be dropped on it, floating or not.
    void takeFiles() { setAcceptDrops(true); }
    bool eventFilter(QObject* watched, QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
};

}  // namespace chiaro::app
