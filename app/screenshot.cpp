#include "app/screenshot.h"

#include "app/main_window.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

#include <cstdio>

namespace chiaro::app {

namespace {

constexpr int lookMilliseconds = 50;
constexpr int quietLooksNeeded = 16;  ///< time for the last results to reach the picture
constexpr int maximumLooks = 300'000 / lookMilliseconds;

}  // namespace

Screenshot::Screenshot(MainWindow& window, const QString& path, const QString& dock)
    : QObject(&window), m_window(window), m_path(path), m_shown(&window) {
    if (auto* wanted = window.findChild<QDockWidget*>(dock + "-dock")) {
        m_shown = wanted;
        wanted->show();
        wanted->raise();
    }
    // Queued: an error before the event loop runs must end it too.
    const auto fail = [](const QString& message) {
        std::fprintf(stderr, "chiaro-studio: %s\n", qPrintable(message));
        QCoreApplication::exit(1);
    };
    connect(&window, &MainWindow::errorShown, this, fail, Qt::QueuedConnection);
    connect(&m_timer, &QTimer::timeout, this, &Screenshot::look);
    m_timer.start(lookMilliseconds);
}

void Screenshot::look() {
    m_quietLooks = m_window.jobs().isIdle() ? m_quietLooks + 1 : 0;
    if (m_quietLooks >= quietLooksNeeded) return take();
    if (++m_looks < maximumLooks) return;
    std::fprintf(stderr, "chiaro-studio: the window never settled\n");
    QCoreApplication::exit(1);
}

void Screenshot::take() {
    m_timer.stop();
    m_window.viewport().picture();  // waits for the texels of what is new
    const bool written = m_shown->grab().save(m_path);
    if (!written) std::fprintf(stderr, "chiaro-studio: %s: can't be written\n", qPrintable(m_path));
    QCoreApplication::exit(written ? 0 : 1);
}

}  // namespace chiaro::app
