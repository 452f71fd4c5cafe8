#pragma once

#include "app/main_window.h"
#include "tests/support/support.h"

namespace chiaro::test {

/// Keeps the settings and documents of a test's windows in this folder, away from the user's own. To be
/// called before the first window.
void prepareWindows(const TemporaryFolder& folder);

/// Waits until nothing runs and what the method shows is final. False when that takes too long.
bool settle(app::MainWindow& window, int milliseconds = 120'000);
/// Opens files, and waits as settle().
bool openAndSettle(app::MainWindow& window, const std::vector<std::filesystem::path>& paths,
                   int milliseconds = 120'000);

/// The first action of a window by its text, without the mark of its key; null when there is none.
QAction* menuAction(const QWidget& window, const QString& text);

}  // namespace chiaro::test
