#include "app/main_window.h"

#include "app/camera_moves.h"
#include "app/compare_tools.h"
#include "app/docks/gradient_dock.h"
#include "app/docks/history_dock.h"
#include "app/docks/jobs_dock.h"
#include "app/docks/metric_graph_dock.h"
#include "app/docks/parameters_dock.h"
#include "app/docks/sample_dock.h"
#include "app/docks/scene_dock.h"
#include "app/docks/timeline_dock.h"
#include "app/docks/view_planning_dock.h"
#include "app/dropped_files.h"
#include "app/empty_hint.h"
#include "app/exporter.h"
#include "app/job_status.h"
#include "app/menus/edit_menu.h"
#include "app/menus/file_menu.h"
#include "app/menus/help_menu.h"
#include "app/menus/render_menu.h"
#include "app/menus/sample_menu.h"
#include "app/menus/scene_menu.h"
#include "app/menus/view_menu.h"
#include "app/method_switch.h"
#include "app/metric_tools.h"
#include "app/project_collector.h"
#include "app/project_files.h"
#include "app/project_pictures.h"
#include "app/safekeeping.h"
#include "app/theme.h"
#include "app/theme_colors.h"
#include "app/view_overlays.h"
#include "app/viewport_link.h"
#include "widgets/message_bar.h"
#include "widgets/picture.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr std::size_t memoBytes = std::size_t(1) << 30;
constexpr int layoutVersion = 4;  ///< of the saved arrangement of docks

}  // namespace

MainWindow::MainWindow()
    : m_memo(memoBytes),
      m_paints(m_document, m_jobs, m_memo),
      m_meshes(m_document, m_jobs, m_memo),
      m_playback(m_document, m_meshes),
      m_frameTextures(m_document, m_jobs, m_memo, m_paints, m_meshes),
      m_viewPlans(m_document, m_jobs, m_memo, m_meshes),
      m_objectTextures(m_document, m_jobs, m_memo, m_paints, m_meshes, m_viewPlans),
      m_opener(m_document, m_jobs, m_paints, m_meshes) {
    m_objectTextures.setCache(
        std::make_shared<const project::TextureCache>(project::TextureCache::standardFolder()));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    makeCentralView();
    makeDocks();
    makeBottomDocks();
    placeDocks();
    makeToolBar();
    makeStatusBar();
    m_files = new ProjectFiles(m_document, m_opener, *this);
    m_collector = new ProjectCollector(m_document, m_jobs, *this);
    auto* pictures = new ProjectPictures(m_document, m_jobs, *m_viewport, this);
    connect(m_files, &ProjectFiles::saved, pictures, &ProjectPictures::keepShown);
    m_exporter =
        new Exporter(m_document, m_jobs, m_paints, m_meshes, m_objectTextures, m_playback, *m_viewport, this);
    makeMenus();
    connectParts();
    resize(1400, 900);
    showTitle();
}

MainWindow::~MainWindow() {
    // The views refer to the document and what is derived from it, which are members: they go first.
    delete m_safekeeping;
    delete takeCentralWidget();
    qDeleteAll(findChildren<QDockWidget*>());
}

void MainWindow::makeCentralView() {
    auto* center = new QWidget;
    m_messages = new widgets::MessageBar;
    m_viewport = new widgets::Viewport;
    followTheme();
    auto* layout = new QVBoxLayout(center);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(m_viewport, 1);
    setCentralWidget(center);
    new EmptyHint(m_document, m_viewport);
    new ViewportLink(m_document, m_playback, m_paints, m_meshes, m_frameTextures, m_objectTextures,
                     *m_viewport, center);
}

void MainWindow::makeDocks() {
    m_sampleDock = new SampleDock(m_document, m_paints);
    m_gradientDock = new GradientDock(m_document, m_paints);
    m_parametersDock = new ParametersDock(m_document);
    m_sceneDock = new SceneDock(m_document, m_meshes);
    m_gradientDock->setSample(m_sampleDock->currentSample());
    m_viewsDock = new ViewPlanningDock(m_document, m_jobs, m_memo, m_meshes, m_viewPlans);
    m_dockPlaces.push_back({Qt::LeftDockWidgetArea, {m_sampleDock, m_sceneDock}});
    m_dockPlaces.push_back({Qt::LeftDockWidgetArea, {m_parametersDock}});
    m_dockPlaces.push_back({Qt::RightDockWidgetArea, {m_gradientDock, m_viewsDock}});
    connect(m_viewport, &widgets::Viewport::viewChanged, m_viewsDock,
            [this] { m_viewsDock->setCamera(m_viewport->camera()); });
    m_viewOverlays = new ViewOverlays(*m_viewsDock, m_jobs, m_viewPlans, m_meshes, *m_viewport, m_viewport);
    m_viewsDock->addSwitches(m_viewOverlays->actions());
    makeMetrics();
}

void MainWindow::makeMetrics() {
    m_metrics = std::make_unique<MetricTools>(m_document, m_jobs, m_paints, m_meshes, *m_viewport);
    m_metrics->comparison().setCache(m_objectTextures.cache());
    MetricGraphDock& dock = m_metrics->dock();
    connect(m_sampleDock, &SampleDock::currentSampleChanged, m_metrics.get(), &MetricTools::setSample);
    m_metrics->setSample(m_sampleDock->currentSample());
    connect(&dock, &MetricGraphDock::frameWanted, this, [this](int frame) {
        const Comparison& comparison = *m_metrics->comparison().result();
        if (comparison.settings.movement == ComparisonSettings::Movement::Timeline)
            m_playback.setCurrentFrame(frame);
    });
    connect(&dock, &MetricGraphDock::exported, this,
            [this](const QString& path) { showNote(tr("The figures are at %1").arg(path)); });
}

void MainWindow::makeBottomDocks() {
    m_timelineDock = new TimelineDock(m_document, m_playback);
    m_jobsDock = new JobsDock(m_jobs);
    auto* history = new HistoryDock(m_document.undoStack());
    m_dockPlaces.push_back(
        {Qt::BottomDockWidgetArea, {m_timelineDock, &m_metrics->dock(), m_jobsDock, history}});
    // Curves want more room than keys do: the first look at them makes it.
    auto* firstLook = new QObject(this);
    connect(&m_metrics->dock(), &QDockWidget::visibilityChanged, firstLook, [this, firstLook](bool isSeen) {
        if (!isSeen || !isVisible()) return;
        firstLook->deleteLater();
        QSettings settings;
        if (settings.value("metric-graph/seen").toBool()) return;
        settings.setValue("metric-graph/seen", true);
        QDockWidget* dock = &m_metrics->dock();
        resizeDocks({dock}, {std::max(dock->height(), height() * 2 / 5)}, Qt::Vertical);
    });
}

void MainWindow::placeDocks() {
    for (const DockPlace& place : m_dockPlaces)
        for (QDockWidget* dock : place.tabs) {
            dock->setFloating(false);
            removeDockWidget(dock);
        }
    for (const DockPlace& place : m_dockPlaces) {
        QDockWidget* before = nullptr;
        for (QDockWidget* dock : place.tabs) {
            addDockWidget(place.area, dock);
            if (before) tabifyDockWidget(before, dock);
            dock->show();
            before = dock;
        }
        place.tabs.front()->raise();
    }
}

void MainWindow::arrangeDocks() {
    resizeDocks({m_sampleDock, m_gradientDock}, {340, 340}, Qt::Horizontal);
    resizeDocks({m_sampleDock, m_parametersDock}, {515, 335}, Qt::Vertical);
    resizeDocks({m_timelineDock}, {m_timelineDock->minimumSizeHint().height()}, Qt::Vertical);
}

void MainWindow::makeToolBar() {
    m_methods = new MethodSwitch(m_document, this);
    QToolBar* bar = addToolBar(tr("Method"));
    bar->setObjectName("method-bar");
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->setIconSize({16, 16});
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_methods->addTo(*bar);
    m_compare = new CompareTools(m_document, *m_viewport, m_metrics->viewMeasures(), m_viewport);
    m_compare->addTo(*bar);
}

void MainWindow::makeStatusBar() {
    m_frameTime = new QLabel;
    m_frameTime->setToolTip(tr("The method shown, and how long its last frame took"));
    statusBar()->addWidget(new JobStatus(m_jobs));
    m_metrics->addTo(*statusBar());
    statusBar()->addPermanentWidget(m_frameTime);
    statusBar()->setContentsMargins(8, 0, 10, 0);
    statusBar()->setSizeGripEnabled(false);
}

void MainWindow::makeMenus() {
    m_viewMenu = new ViewMenu(*m_viewport, *m_compare, *new CameraMoves(m_document, *m_viewport, this),
                              *m_viewOverlays, *m_metrics, *this);
    connect(m_viewMenu, &ViewMenu::resetLayoutWanted, this, [this] {
        placeDocks();
        arrangeDocks();
    });
    auto* sample = new SampleMenu(m_document, *m_sampleDock, *this);
    connect(sample, &SampleMenu::synthesisWanted, this, [this] {
        m_paints.retry();
        m_frameTextures.retry();
        m_viewPlans.retry();
        m_objectTextures.retry();
    });
    const std::initializer_list<QMenu*> menus{
        new FileMenu(m_document, *m_files, *m_collector, *m_exporter, *this),
        new EditMenu(m_document.undoStack(), *this),
        m_viewMenu,
        sample,
        new SceneMenu(*m_files, *m_sceneDock, *this),
        new RenderMenu(*m_methods, *m_files, *m_exporter, *m_timelineDock, *this),
        new HelpMenu(*this)};
    for (QMenu* menu : menus) menuBar()->addMenu(menu);
}

void MainWindow::connectParts() {
    connect(m_files, &ProjectFiles::failed, this, &MainWindow::showError);
    connect(m_collector, &ProjectCollector::collected, this, &MainWindow::showNote);
    connect(m_files, &ProjectFiles::noted, this, &MainWindow::showNote);
    for (Dock* dock : findChildren<Dock*>()) connect(dock, &Dock::failed, this, &MainWindow::showError);
    connect(m_exporter, &Exporter::exported, this, &MainWindow::showNote);
    connect(&m_document, &Document::modifiedChanged, this, &MainWindow::showTitle);
    connect(&m_document, &Document::pathChanged, this, &MainWindow::showTitle);
    connect(&m_jobs, &JobRunner::failed, this, &MainWindow::showError);
    connect(&m_opener, &Opener::failed, this, &MainWindow::showError);
    connect(&m_opener, &Opener::noted, this, &MainWindow::showNote);
    connect(&m_opener, &Opener::projectOpened, m_messages, &QWidget::hide);
    connect(&m_opener, &Opener::sampleOpened, m_sampleDock, &SampleDock::selectSample);
    connect(&m_opener, &Opener::meshOpened, m_sceneDock, &SceneDock::selectRow);
    connect(m_sceneDock, &SceneDock::addMeshWanted, m_files, &ProjectFiles::addMesh);
    connect(m_sceneDock, &SceneDock::filesDropped, &m_opener, &Opener::add);
    connect(m_sceneDock, &SceneDock::lightSelected, m_viewport, &widgets::Viewport::setTurnedLight);
    connect(m_sampleDock, &SampleDock::currentSampleChanged, m_gradientDock, &GradientDock::setSample);
    connect(m_sampleDock, &SampleDock::currentSampleChanged, &m_opener, &Opener::setCurrentSample);
    connect(m_sampleDock, &SampleDock::filesDropped, this, &MainWindow::open);
    connect(m_sampleDock, &SampleDock::addWanted, m_files, &ProjectFiles::openStrip);
    connect(m_viewport, &widgets::Viewport::filesDropped, this, &MainWindow::open);
    connect(m_viewport, &widgets::Viewport::frameDrawn, this, [this](double milliseconds) {
        const QString compared = m_compare->shownLabel();
        const QString shown = compared.isEmpty() ? m_methods->shownLabel() : compared;
        m_frameTime->setText(tr("%1 · %2 ms").arg(shown).arg(milliseconds, 0, 'f', 1));
    });
}

QString MainWindow::frameText() const {
    return m_frameTime->text();
}

void MainWindow::showError(const QString& message) {
    m_messages->showMessage(message, widgets::MessageBar::Kind::Error);
    Q_EMIT errorShown(message);
}

void MainWindow::showNote(const QString& message) {
    m_messages->showMessage(message, widgets::MessageBar::Kind::Note);
}

void MainWindow::showTitle() {
    const QString name =
        m_document.isReadOnly() ? tr("%1 (read-only)").arg(m_document.name()) : m_document.name();
    setWindowTitle(tr("%1[*] — Chiaro").arg(name));
    setWindowModified(m_document.isModified());
}

void MainWindow::addAppearance(ThemeSwitch& theme) {
    m_viewMenu->addAppearance(theme);
}

void MainWindow::followTheme() {
    m_viewport->setBackground(widgets::fromColor(themeColor("viewport", showsDarkTheme())));
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) followTheme();
}

void MainWindow::restoreLayout() {
    const QSettings settings;
    restoreGeometry(settings.value("window/geometry").toByteArray());
    m_isArranged = restoreState(settings.value("window/state").toByteArray(), layoutVersion);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    // Docks have sizes once they are shown: before that Qt gives room away by its own lights.
    if (!std::exchange(m_isArranged, true)) QTimer::singleShot(0, this, &MainWindow::arrangeDocks);
}

bool MainWindow::keepWorkSafe() {
    m_safekeeping = new Safekeeping(m_document, m_opener, Autosave::standardFolder(), *this);
    statusBar()->insertPermanentWidget(1,
                                       m_safekeeping->label());  // behind the jobs, before the frame's time
    return m_safekeeping->offerRecovery();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_files->mayDiscard()) return event->ignore();
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    settings.setValue("window/state", saveState(layoutVersion));
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    open(localFiles(*event->mimeData()));
}

}  // namespace chiaro::app
