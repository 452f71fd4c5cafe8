#pragma once

#include "app/theme.h"

#include <QSize>
#include <QStringList>

#include <optional>

namespace chiaro::app {

/// What the studio was asked for on its command line.
struct StudioOptions {
    QStringList files;
    QString screenshot;          ///< the picture to write; empty for a studio that somebody sits at
    QString dock;                ///< of the screenshot: one dock alone, by its name; empty for the window
    QSize size;                  ///< of the window, px; invalid for the usual one
    std::optional<Theme> theme;  ///< else the remembered one
    QString language;            ///< else the remembered one
    bool timesStart = false;     ///< tell how long it took until the window was there, and end
    bool isSafe = false;         ///< no OpenGL, nothing of what was remembered
};

/// The names that --dock takes.
QStringList dockNames();

/// Reads the arguments of the running application. --help and --version print and end the program here, with 0;
/// what makes no sense prints one sentence and ends it with 2.
StudioOptions parseStudioOptions(const QStringList& arguments);

}  // namespace chiaro::app
