#include "app/menus/scene_menu.h"

#include "app/docks/scene_dock.h"
#include "app/menus/menu_entry.h"
#include "app/project_files.h"

#include <QtWidgets>

namespace chiaro::app {

SceneMenu::SceneMenu(ProjectFiles& files, SceneDock& dock, QWidget& window) : QMenu(tr("S&cene"), &window) {
    addEntry(*this, "mesh", tr("&Add Mesh…"), QKeySequence("Ctrl+Shift+M"), [&] { files.addMesh(); });
    dock.addTo(*this);
}

}  // namespace chiaro::app
