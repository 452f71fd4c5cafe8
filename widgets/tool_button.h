#pragma once

#include <QString>

class QToolButton;

namespace chiaro::widgets {

/// A flat button with one of the studio's icons (":/icons/NAME.svg"), named for screen readers and tests.
QToolButton* makeToolButton(const char* icon, const QString& name, const QString& tooltip);

}  // namespace chiaro::widgets
