#pragma once

#include <QObject>
#include <QTimer>

namespace chiaro::app {

class MainWindow;

/// Writes a picture of the whole window once everything has settled, and ends the program: with 0 when the
/// picture is there, with 1 when something went wrong or never settles.
class Screenshot : public QObject {
    Q_OBJECT

public:
    Screenshot(MainWindow& window, const QString& path);

private:
    void look();
    void take();

    MainWindow& m_window;
    QString m_path;
    QTimer m_timer;
    int m_quietLooks = 0;
    int m_looks = 0;
};

}  // namespace chiaro::app
