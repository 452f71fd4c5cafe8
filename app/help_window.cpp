#include "app/help_window.h"

#include "app/language.h"
#include "core/base/resources.h"

#include <QtWidgets>

#include <array>

namespace chiaro::app {

namespace {

struct Page {
    const char* name;  ///< of its file, and of its dock
    const char* title;
};

constexpr std::array pages{
    Page{"start", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "First Steps")},
    Page{"navigation", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "Viewport")},
    Page{"sample", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "Sample")},
    Page{"scene", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "Scene")},
    Page{"parameters", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "Parameters")},
    Page{"gradient", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "Gradient Curve")},
    Page{"view-planning", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "View Planning")},
    Page{"compare", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "Comparing Methods")},
    Page{"timeline", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "Timeline")},
    Page{"metric-graph", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "Metric Graph")},
    Page{"jobs", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "Jobs")},
    Page{"history", QT_TRANSLATE_NOOP("chiaro::app::HelpWindow", "History")},
};

/// The folder of help/, empty where the program was installed without it.
QString helpFolder() {
    try {
        return QString::fromStdString((resourceFolder() / "help").string());
    } catch (const std::exception&) {
        return {};
    }
}

QString fileOf(const QString& page) {
    const QString folder = helpFolder();
    const QString translated = QString("%1/%2/%3.md").arg(folder, shownLanguage(), page);
    return QFileInfo::exists(translated) ? translated : QString("%1/en/%2.md").arg(folder, page);
}

/// Markdown's tables come with thick borders and no room around their text.
void quietTables(const QTextDocument& document, const QColor& line) {
    for (QTextFrame* frame : document.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table) continue;
        QTextTableFormat format = table->format();
        format.setBorderBrush(line);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderCollapse(true);
        format.setBorder(1);
        format.setCellSpacing(0);
        format.setCellPadding(5);
        format.setBottomMargin(10);
        table->setFormat(format);
    }
}

}  // namespace

QStringList HelpWindow::pageNames() {
    QStringList names;
    for (const Page& page : pages) names << page.name;
    return names;
}

QString HelpWindow::pageOf(const QWidget* focus) {
    for (const QWidget* widget = focus; widget; widget = widget->parentWidget()) {
        const QString name = widget->objectName();
        if (name.endsWith("-dock") && pageNames().contains(name.chopped(5))) return name.chopped(5);
    }
    return "navigation";
}

HelpWindow::HelpWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), m_contents(new QListWidget), m_browser(new QTextBrowser) {
    setWindowTitle(tr("Chiaro Help"));
    m_contents->setAccessibleName(tr("Contents"));
    m_browser->setAccessibleName(tr("Page"));
    m_browser->setObjectName("help-page");
    m_browser->setOpenExternalLinks(true);
    for (const Page& page : pages) m_contents->addItem(tr(page.title));
    m_contents->setFixedWidth(m_contents->sizeHintForColumn(0) + 40);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 8, 8, 8);
    row->setSpacing(8);
    row->addWidget(m_contents);
    row->addWidget(m_browser, 1);
    resize(820, 640);
    connect(m_contents, &QListWidget::currentRowChanged, this,
            [this](int chosen) { showPage(pages[std::size_t(chosen)].name); });
    connect(m_browser, &QTextBrowser::sourceChanged, this, [this](const QUrl& url) {
        quietTables(*m_browser->document(), palette().color(QPalette::Midlight));
        const QSignalBlocker quiet(m_contents);
        m_contents->setCurrentRow(int(pageNames().indexOf(QFileInfo(url.path()).baseName())));
    });
    auto* close = new QShortcut(QKeySequence(Qt::Key_Escape), this);
    connect(close, &QShortcut::activated, this, &QWidget::close);
}

void HelpWindow::open(const QString& page) {
    showPage(page);
    show();
    raise();
    activateWindow();
}

QString HelpWindow::page() const {
    return QFileInfo(m_browser->source().path()).baseName();
}

void HelpWindow::showPage(const QString& page) {
    m_browser->setSource(QUrl::fromLocalFile(fileOf(page)), QTextDocument::MarkdownResource);
}

void HelpWindow::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    // Links take their colour when a page is read.
    if (event->type() != QEvent::PaletteChange || m_browser->source().isEmpty()) return;
    m_browser->reload();
    quietTables(*m_browser->document(), palette().color(QPalette::Midlight));
}

}  // namespace chiaro::app
