#include "app/menus/help_menu.h"

#include "app/help_window.h"
#include "app/menus/menu_entry.h"

#include <QtWidgets>

namespace chiaro::app {

HelpMenu::HelpMenu(QWidget& window) : QMenu(tr("&Help"), &window), m_window(window) {
    addEntry(*this, nullptr, tr("&First Steps"), {}, [this] { open("start"); });
    addEntry(*this, nullptr, tr("Help for This &Dock"), QKeySequence("F1"),
             [this] { open(HelpWindow::pageOf(QApplication::focusWidget())); });
    addSeparator();
    addEntry(*this, "note", tr("&About Chiaro"), {}, [&window] {
        QMessageBox::about(&window, tr("About Chiaro"),
                           tr("<h3>Chiaro %1</h3><p>Shades 3D meshes with an artist's own paint.</p>"
                              "<p>After Kulla, Tucek, Bailey and Grimm, <i>Using Texture Synthesis for "
                              "Non-Photorealistic Shading from Paint Samples</i>, WUCSE-2003-54.</p>"
                              "<p>GPL-3.0-or-later</p>")
                               .arg(CHIARO_VERSION));
    });
}

void HelpMenu::open(const QString& page) {
    if (!m_help) m_help = new HelpWindow(&m_window);
    m_help->open(page);
}

}  // namespace chiaro::app
