#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include <span>

namespace chiaro::app {

/// A colour of the studio by its name, which the style sheet calls "@name", in each of its themes.
struct ThemeColor {
    const char* name;
    QRgb dark;
    QRgb light;
};

/// Every colour of both themes: neutral greys, so that no colour around the paint tints what the artist sees, and
/// one accent.
std::span<const ThemeColor> themeColors();

/// Throws std::out_of_range for a name that is not in the table.
QColor themeColor(const char* name, bool isDark);

/// What custom painting goes by.
QPalette themePalette(bool isDark);

/// `sheet` with every "@name" replaced by that colour, "#rrggbb". Throws std::out_of_range as themeColor does.
QString inked(const QString& sheet, bool isDark);

}  // namespace chiaro::app
