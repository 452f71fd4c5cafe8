#pragma once

#include <QIcon>
#include <QString>

class QToolButton;

namespace chiaro::widgets {

/// One of the studio's icons, ":/icons/NAME.svg"; none in a program that doesn't bring them.
QIcon icon(const char* name);

/// A flat button with one of the studio's icons, named for screen readers and, by the icon, for tests.
QToolButton* makeToolButton(const char* iconName, const QString& name, const QString& tooltip);

}  // namespace chiaro::widgets
