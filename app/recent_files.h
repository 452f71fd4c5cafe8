#pragma once

#include <QMenu>

namespace chiaro::app {

/// The projects opened and saved last, with their pictures, remembered between sessions.
class RecentFiles : public QMenu {
    Q_OBJECT

public:
    explicit RecentFiles(QWidget* parent = nullptr);

    /// To the top of the list.
    void add(const QString& path);

Q_SIGNALS:
    void chosen(const QString& path);

private:
    void rebuild();
};

}  // namespace chiaro::app
