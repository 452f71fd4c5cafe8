#include "app/menus/view_menu.h"

#include "app/camera_moves.h"
#include "app/compare_tools.h"
#include "app/language.h"
#include "app/menus/menu_entry.h"
#include "app/metric_tools.h"
#include "app/theme.h"
#include "app/view_overlays.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

ViewMenu::ViewMenu(widgets::Viewport& viewport, CompareTools& compare, const CameraMoves& moves,
                   const ViewOverlays& overlays, const MetricTools& metrics, QWidget& window)
    : QMenu(tr("&View"), &window), m_viewport(viewport) {
    addEntry(*this, "frame", tr("&Frame All"), QKeySequence("Home"), [this] { m_viewport.frameAll(); });
    addActions({moves.previousAction(), moves.nextAction()});
    addNavigation();
    compare.addTo(*this);
    addSeparator();
    addActions(overlays.actions());
    addSeparator();
    metrics.addTo(*this);
    addSeparator();
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) addAction(dock->toggleViewAction());
    addEntry(*this, nullptr, tr("&Reset Layout"), {}, [this] { Q_EMIT resetLayoutWanted(); });
}

void ViewMenu::addAppearance(ThemeSwitch& theme) {
    addSeparator();
    theme.addTo(*addMenu(tr("&Theme")));
    addLanguagesTo(*addMenu(tr("&Language")), parentWidget());
}

void ViewMenu::addNavigation() {
    QMenu* navigation = addMenu(tr("&Navigation"));
    auto* group = new QActionGroup(this);
    const int chosen = QSettings().value("navigation", 0).toInt();
    int number = 0;
    for (const QString& name : {tr("&Blender"), tr("&Maya, Painter"), tr("&Trackpad")}) {
        QAction* action = addEntry(*navigation, nullptr, name, {}, [this, number] { setNavigation(number); });
        action->setCheckable(true);
        action->setChecked(number == chosen);
        group->addAction(action);
        ++number;
    }
    m_viewport.setNavigation(widgets::Navigation(chosen));
}

void ViewMenu::setNavigation(int navigation) {
    m_viewport.setNavigation(widgets::Navigation(navigation));
    QSettings().setValue("navigation", navigation);
}

}  // namespace chiaro::app
