#include "app/menus/sample_menu.h"

#include "app/docks/sample_dock.h"
#include "app/document.h"
#include "app/menus/menu_entry.h"
#include "widgets/sample_view.h"

#include <QtWidgets>

namespace chiaro::app {

SampleMenu::SampleMenu(Document& document, SampleDock& dock, QWidget& window)
    : QMenu(tr("&Sample"), &window) {
    widgets::SampleView* view = dock.sampleView();
    QList<QAction*> edits{
        addEntry(*this, "turn-left", tr("Turn &Left"), QKeySequence("Ctrl+["), [view] { view->turn(-1); }),
        addEntry(*this, "turn-right", tr("Turn &Right"), QKeySequence("Ctrl+]"), [view] { view->turn(1); }),
        addEntry(*this, "mirror", tr("&Mirror"), {}, [view] { view->mirror(); }),
        addEntry(*this, "crop-reset", tr("&Whole Scan"), {}, [view] { view->resetCrop(); })};
    addSeparator();
    edits << addEntry(*this, "paint", tr("&Paint Everything"), {},
                      [&] { document.wearEverywhere(dock.currentSample()); });
    addEntry(*this, nullptr, tr("&Synthesise Again"), QKeySequence("F5"),
             [this] { Q_EMIT synthesisWanted(); });
    connect(this, &QMenu::aboutToShow, this, [&dock, edits] {
        for (QAction* action : edits) action->setEnabled(dock.currentSample() >= 0);
    });
}

}  // namespace chiaro::app
