#pragma once

#include <QKeySequence>

#include <functional>

class QAction;
class QMenu;

namespace chiaro::app {

/// An entry at the end of a menu. `icon` is a name under resources/icons, or null. The action belongs to the
/// menu.
QAction* addEntry(QMenu& menu, const char* icon, const QString& text, const QKeySequence& keys,
                  const std::function<void()>& triggered);

}  // namespace chiaro::app
