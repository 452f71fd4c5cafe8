#include "app/menus/file_menu.h"

#include "app/document.h"
#include "app/exporter.h"
#include "app/menus/menu_entry.h"
#include "app/project_collector.h"
#include "app/project_files.h"
#include "app/recent_files.h"

#include <QtWidgets>

namespace chiaro::app {

FileMenu::FileMenu(Document& document, ProjectFiles& files, ProjectCollector& collector, Exporter& exporter,
                   QWidget& window)
    : QMenu(tr("&File"), &window) {
    addEntry(*this, nullptr, tr("&New Project"), QKeySequence::New, [&] { files.newProject(); });
    addEntry(*this, "open", tr("&Open Project…"), QKeySequence::Open, [&] { files.openProject(); });
    addMenu(&files.recent());
    addEntry(*this, "strip", tr("Open &Strip…"), QKeySequence("Ctrl+Shift+O"), [&] { files.openStrip(); });
    addEntry(*this, "mesh", tr("Open &Mesh…"), QKeySequence("Ctrl+M"), [&] { files.openMesh(); });
    addSeparator();
    QAction* save = addEntry(*this, "save", tr("&Save"), QKeySequence::Save, [&] { files.save(); });
    connect(&document, &Document::pathChanged, save,
            [&document, save] { save->setEnabled(!document.isReadOnly()); });
    addEntry(*this, nullptr, tr("Save &As…"), QKeySequence::SaveAs, [&] { files.saveAs(); });
    addEntry(*this, nullptr, tr("&Collect Files…"), {}, [&] {
        collector.collect(files.folder());
    })->setToolTip(tr("Copies the project with all its scans and meshes into one folder"));
    addSeparator();
    addEntry(*this, "export", tr("&Export Picture…"), QKeySequence("Ctrl+E"),
             [&] { exporter.exportPicture(files.folder()); });
    addEntry(*this, nullptr, tr("Export M&esh…"), QKeySequence("Ctrl+Shift+E"),
             [&] { exporter.exportMesh(files.folder()); });
    addEntry(*this, nullptr, tr("Export &Relightable Page…"), {},
             [&] { exporter.exportPage(files.folder()); });
    addSeparator();
    addEntry(*this, nullptr, tr("&Quit"), QKeySequence::Quit, [&] { window.close(); });
}

}  // namespace chiaro::app
