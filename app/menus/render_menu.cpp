#include "app/menus/render_menu.h"

#include "app/docks/timeline_dock.h"
#include "app/exporter.h"
#include "app/menus/menu_entry.h"
#include "app/method_switch.h"
#include "app/project_files.h"

#include <QtWidgets>

namespace chiaro::app {

RenderMenu::RenderMenu(const MethodSwitch& methods, ProjectFiles& files, Exporter& exporter,
                       TimelineDock& timeline, QWidget& window)
    : QMenu(tr("&Render"), &window) {
    methods.addTo(*this);
    addSeparator();
    addEntry(*this, "export", tr("Render &Animation…"), QKeySequence("Ctrl+F12"),
             [&] { exporter.renderAnimation(files.folder()); });
    timeline.addTo(*this);
}

}  // namespace chiaro::app
