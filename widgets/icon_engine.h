#pragma once

#include <QColor>
#include <QIcon>

namespace chiaro::widgets {

/// The inks that icons are drawn in.
struct IconColors {
    QColor plain;
    QColor note;
    QColor error;
};

/// For every icon from now on, those that were made before too; widgets that hold pixmaps of icons draw them anew
/// when their palette changes.
void setIconColors(const IconColors& colors);
const IconColors& iconColors();

/// An icon from an SVG file whose inks #d4d4d4 (plain), #d8b27a (note) and #f0a08c (error) stand for
/// iconColors(); sharp in every size and on every screen, and pale where it is disabled.
QIcon themedIcon(const QString& path);

}  // namespace chiaro::widgets
