#pragma once

#include <QObject>
#include <QTimer>

namespace chiaro::app {

class MainWindow;

/// Writes a picture of the whole window, or of one of its docks, once everything has settled, and ends the program:
/// with 0 when the picture is there, with 1 when something went wrong or never settles.
class Screenshot : public QObject {
    Q_OBJECT

public:
    /// `dock` is one of dockNames(), or empty for the window. The dock is raised at once, so that it settles too.
    Screenshot(MainWindow& window, const QString& path, const QString& dock);

private:
    void look();
    void take();

    MainWindow& m_window;
    QString m_path;
    QWidget* m_shown;
    QTimer m_timer;
    int m_quietLooks = 0;
    int m_looks = 0;
};

}  // namespace chiaro::app
