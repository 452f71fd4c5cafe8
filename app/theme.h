#pragma once

class QApplication;

namespace chiaro::app {

/// The studio's look: dark and neutral, so that no colour around the paint tints what the artist sees.
void applyTheme(QApplication& application);

}  // namespace chiaro::app
