#include "app/main_window.h"

#include "app/docks/gradient_dock.h"
#include "app/docks/history_dock.h"
#include "app/docks/jobs_dock.h"
#include "app/docks/metric_graph_dock.h"
#include "app/docks/parameters_dock.h"
#include "app/docks/sample_dock.h"
#include "app/docks/scene_dock.h"
#include "app/docks/timeline_dock.h"
#include "app/docks/view_planning_dock.h"
#include "app/empty_hint.h"
#include "app/exporter.h"
#include "app/job_status.h"
#include "app/method_switch.h"
#include "app/metric_tools.h"
#include "app/recent_files.h"
#include "app/safekeeping.h"
#include "app/view_overlays.h"
#include "app/viewport_link.h"
#include "core/base/error.h"
#include "widgets/message_bar.h"
#include "widgets/sample_view.h"
#include "widgets/tool_button.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr std::size_t memoBytes = std::size_t(1) << 30;
constexpr int layoutVersion = 4;  ///< of the saved arrangement of docks
constexpr glm::vec3 viewportBackground(0.165F);

const char* const projectFilter = QT_TRANSLATE_NOOP("MainWindow", "Chiaro projects (*.chiaro)");
const char* const stripFilter =
    QT_TRANSLATE_NOOP("MainWindow", "Strips (*.png *.tif *.tiff *.jpg *.jpeg *.exr *.webp)");
const char* const meshFilter =
    QT_TRANSLATE_NOOP("MainWindow", "Meshes (*.obj *.ply *.off *.stl *.glb *.gltf)");

QStringList localFiles(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    return paths;
}

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
    makeToolBar();
    makeStatusBar();
    makeMenus();
    connectParts();
    resize(1400, 900);
    m_standardState = saveState(layoutVersion);
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
    m_viewport->setBackground(viewportBackground);
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
    addDockWidget(Qt::LeftDockWidgetArea, m_sampleDock);
    addDockWidget(Qt::LeftDockWidgetArea, m_sceneDock);
    tabifyDockWidget(m_sampleDock, m_sceneDock);
    m_sampleDock->raise();
    addDockWidget(Qt::RightDockWidgetArea, m_gradientDock);
    m_viewsDock = new ViewPlanningDock(m_document, m_jobs, m_memo, m_meshes, m_viewPlans);
    addDockWidget(Qt::LeftDockWidgetArea, m_parametersDock);
    addDockWidget(Qt::RightDockWidgetArea, m_viewsDock);
    tabifyDockWidget(m_gradientDock, m_viewsDock);
    m_gradientDock->raise();
    connect(m_viewport, &widgets::Viewport::viewChanged, m_viewsDock,
            [this] { m_viewsDock->setCamera(m_viewport->camera()); });
    m_viewOverlays = new ViewOverlays(*m_viewsDock, m_viewPlans, m_meshes, *m_viewport, m_viewport);
    m_viewsDock->addSwitches({m_viewOverlays->framesAction(), m_viewOverlays->facesAction()});
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
    m_historyDock = new HistoryDock(m_document.undoStack());
    addDockWidget(Qt::BottomDockWidgetArea, m_timelineDock);
    addDockWidget(Qt::BottomDockWidgetArea, m_jobsDock);
    addDockWidget(Qt::BottomDockWidgetArea, m_historyDock);
    addDockWidget(Qt::BottomDockWidgetArea, &m_metrics->dock());
    tabifyDockWidget(m_timelineDock, &m_metrics->dock());
    tabifyDockWidget(&m_metrics->dock(), m_jobsDock);
    tabifyDockWidget(m_jobsDock, m_historyDock);
    m_timelineDock->raise();
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

QAction* MainWindow::addAction(QMenu& menu, const char* icon, const QString& text, const QKeySequence& keys,
                               const std::function<void()>& triggered) {
    QAction* action = menu.addAction(text);
    if (icon != nullptr) action->setIcon(widgets::icon(icon));
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, triggered);
    return action;
}

void MainWindow::makeMenus() {
    makeFileMenu();
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    QAction* undo = m_document.undoStack().createUndoAction(this, tr("&Undo"));
    undo->setIcon(widgets::icon("undo"));
    undo->setShortcuts(QKeySequence::Undo);
    QAction* redo = m_document.undoStack().createRedoAction(this, tr("&Redo"));
    redo->setIcon(widgets::icon("redo"));
    redo->setShortcuts(QKeySequence::Redo);
    edit->addActions({undo, redo});
    makeViewMenu();
    makeSampleMenu();
    makeSceneMenu();
    makeRenderMenu();
    makeHelpMenu();
}

void MainWindow::makeFileMenu() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    addAction(*file, nullptr, tr("&New Project"), QKeySequence::New, [this] { newProject(); });
    addAction(*file, "open", tr("&Open Project…"), QKeySequence::Open,
              [this] { openByDialog(tr("Open Project"), tr(projectFilter)); });
    m_recent = new RecentFiles(this);
    file->addMenu(m_recent);
    addAction(*file, "strip", tr("Open &Strip…"), QKeySequence("Ctrl+Shift+O"),
              [this] { openByDialog(tr("Open Strip"), tr(stripFilter)); });
    addAction(*file, "mesh", tr("Open &Mesh…"), QKeySequence("Ctrl+M"),
              [this] { openByDialog(tr("Open Mesh"), tr(meshFilter)); });
    file->addSeparator();
    addAction(*file, "save", tr("&Save"), QKeySequence::Save, [this] { save(); });
    addAction(*file, nullptr, tr("Save &As…"), QKeySequence::SaveAs, [this] { saveAs(); });
    addAction(*file, "export", tr("&Export Picture…"), QKeySequence("Ctrl+E"),
              [this] { m_exporter->exportPicture(folder()); });
    addAction(*file, nullptr, tr("Export M&esh…"), QKeySequence("Ctrl+Shift+E"),
              [this] { m_exporter->exportMesh(folder()); });
    file->addSeparator();
    addAction(*file, nullptr, tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::makeViewMenu() {
    QMenu* view = menuBar()->addMenu(tr("&View"));
    addAction(*view, "frame", tr("&Frame All"), QKeySequence("Home"), [this] { m_viewport->frameAll(); });
    QMenu* navigation = view->addMenu(tr("&Navigation"));
    auto* group = new QActionGroup(this);
    const int chosen = QSettings().value("navigation", 0).toInt();
    int number = 0;
    for (const QString& name : {tr("&Blender"), tr("&Maya, Painter"), tr("&Trackpad")}) {
        QAction* action =
            addAction(*navigation, nullptr, name, {}, [this, number] { setNavigation(number); });
        action->setCheckable(true);
        action->setChecked(number == chosen);
        group->addAction(action);
        ++number;
    }
    m_viewport->setNavigation(widgets::Viewport::Navigation(chosen));
    view->addActions({m_viewOverlays->framesAction(), m_viewOverlays->facesAction()});
    view->addSeparator();
    m_metrics->addTo(*view);
    view->addSeparator();
    for (QDockWidget* dock : findChildren<QDockWidget*>()) view->addAction(dock->toggleViewAction());
    addAction(*view, nullptr, tr("&Reset Layout"), {}, [this] {
        restoreState(m_standardState, layoutVersion);
        arrangeDocks();
    });
}

void MainWindow::makeSampleMenu() {
    QMenu* sample = menuBar()->addMenu(tr("&Sample"));
    widgets::SampleView* view = m_sampleDock->sampleView();
    QList<QAction*> edits{
        addAction(*sample, "turn-left", tr("Turn &Left"), QKeySequence("Ctrl+["), [view] { view->turn(-1); }),
        addAction(*sample, "turn-right", tr("Turn &Right"), QKeySequence("Ctrl+]"),
                  [view] { view->turn(1); }),
        addAction(*sample, "mirror", tr("&Mirror"), {}, [view] { view->mirror(); }),
        addAction(*sample, "crop-reset", tr("&Whole Scan"), {}, [view] { view->resetCrop(); })};
    sample->addSeparator();
    edits << addAction(*sample, "paint", tr("&Paint Everything"), {},
                       [this] { m_document.wearEverywhere(m_sampleDock->currentSample()); });
    addAction(*sample, nullptr, tr("&Synthesise Again"), QKeySequence("F5"), [this] {
        m_paints.retry();
        m_frameTextures.retry();
        m_viewPlans.retry();
        m_objectTextures.retry();
    });
    connect(sample, &QMenu::aboutToShow, this, [this, edits] {
        for (QAction* action : edits) action->setEnabled(m_sampleDock->currentSample() >= 0);
    });
}

void MainWindow::makeSceneMenu() {
    QMenu* scene = menuBar()->addMenu(tr("S&cene"));
    addAction(*scene, "mesh", tr("&Add Mesh…"), QKeySequence("Ctrl+Shift+M"), [this] { addMeshByDialog(); });
    m_sceneDock->addTo(*scene);
}

void MainWindow::makeRenderMenu() {
    QMenu* render = menuBar()->addMenu(tr("&Render"));
    m_methods->addTo(*render);
    render->addSeparator();
    addAction(*render, "export", tr("Render &Animation…"), QKeySequence("Ctrl+F12"),
              [this] { m_exporter->renderAnimation(folder()); });
    m_timelineDock->addTo(*render);
}

void MainWindow::makeHelpMenu() {
    QMenu* help = menuBar()->addMenu(tr("&Help"));
    addAction(*help, "note", tr("&About Chiaro"), {}, [this] {
        QMessageBox::about(this, tr("About Chiaro"),
                           tr("<h3>Chiaro %1</h3><p>Shades 3D meshes with an artist's own paint.</p>"
                              "<p>After Kulla, Tucek, Bailey and Grimm, <i>Using Texture Synthesis for "
                              "Non-Photorealistic Shading from Paint Samples</i>, WUCSE-2003-54.</p>"
                              "<p>GPL-3.0-or-later</p>")
                               .arg(CHIARO_VERSION));
    });
}

void MainWindow::connectParts() {
    m_exporter =
        new Exporter(m_document, m_jobs, m_paints, m_meshes, m_objectTextures, m_playback, *m_viewport, this);
    connect(m_exporter, &Exporter::exported, this, &MainWindow::showNote);
    connect(&m_document, &Document::modifiedChanged, this, &MainWindow::showTitle);
    connect(&m_document, &Document::pathChanged, this, &MainWindow::showTitle);
    connect(&m_jobs, &JobRunner::failed, this, &MainWindow::showError);
    connect(&m_opener, &Opener::failed, this, &MainWindow::showError);
    connect(&m_opener, &Opener::noted, this, &MainWindow::showNote);
    connect(&m_opener, &Opener::projectOpened, this, [this](const QString& path) {
        m_messages->hide();
        if (!m_document.path().empty()) m_recent->add(path);
    });
    connect(&m_opener, &Opener::sampleOpened, m_sampleDock, &SampleDock::selectSample);
    m_opener.setReplaceQuestion([this] { return mayDiscard(); });
    connect(&m_opener, &Opener::meshOpened, m_sceneDock, &SceneDock::selectRow);
    connect(m_sceneDock, &SceneDock::addMeshWanted, this, &MainWindow::addMeshByDialog);
    connect(m_sceneDock, &SceneDock::filesDropped, &m_opener, &Opener::add);
    connect(m_sceneDock, &SceneDock::lightSelected, m_viewport, &widgets::Viewport::setTurnedLight);
    connect(m_recent, &RecentFiles::chosen, this, [this](const QString& path) { open({path}); });
    connect(m_sampleDock, &SampleDock::currentSampleChanged, m_gradientDock, &GradientDock::setSample);
    connect(m_sampleDock, &SampleDock::currentSampleChanged, &m_opener, &Opener::setCurrentSample);
    connect(m_sampleDock, &SampleDock::addWanted, this,
            [this] { openByDialog(tr("Open Strip"), tr(stripFilter)); });
    connect(m_viewport, &widgets::Viewport::filesDropped, this, &MainWindow::open);
    connect(m_viewport, &widgets::Viewport::frameDrawn, this, [this](double milliseconds) {
        m_frameTime->setText(tr("%1 · %2 ms").arg(m_methods->shownLabel()).arg(milliseconds, 0, 'f', 1));
    });
}

QString MainWindow::frameText() const {
    return m_frameTime->text();
}

void MainWindow::setNavigation(int navigation) {
    m_viewport->setNavigation(widgets::Viewport::Navigation(navigation));
    QSettings().setValue("navigation", navigation);
}

QString MainWindow::folder() const {
    if (m_document.path().empty()) return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QString::fromStdString(m_document.path().parent_path().string());
}

void MainWindow::newProject() {
    if (mayDiscard()) m_document.replace({}, {}, {});
}

QStringList MainWindow::chooseFiles(const QString& title, const QString& filter) {
    QSettings settings;
    const QString folder = settings.value("folder/" + title).toString();
    const QStringList paths = QFileDialog::getOpenFileNames(this, title, folder, filter);
    if (!paths.isEmpty()) settings.setValue("folder/" + title, QFileInfo(paths.front()).path());
    return paths;
}

void MainWindow::openByDialog(const QString& title, const QString& filter) {
    if (const QStringList paths = chooseFiles(title, filter); !paths.isEmpty()) open(paths);
}

void MainWindow::addMeshByDialog() {
    m_opener.add(chooseFiles(tr("Add Mesh"), tr(meshFilter)));
}

bool MainWindow::save() {
    if (m_document.path().empty()) return saveAs();
    return saveTo(QString::fromStdString(m_document.path().string()));
}

bool MainWindow::saveAs() {
    const QString suggestion = folder() + "/" + m_document.name() + ".chiaro";
    QString path = QFileDialog::getSaveFileName(this, tr("Save Project"), suggestion, tr(projectFilter));
    if (path.isEmpty()) return false;
    if (!path.endsWith(".chiaro")) path += ".chiaro";
    return saveTo(path);
}

bool MainWindow::saveTo(const QString& path) {
    try {
        m_document.save(std::filesystem::absolute(path.toStdString()));
    } catch (const std::exception& problem) {
        showError(QString::fromStdString(problem.what()));
        return false;
    }
    m_recent->add(path);
    return true;
}

bool MainWindow::mayDiscard() {
    if (!m_document.isModified()) return true;
    const auto answer = QMessageBox::question(
        this, tr("Unsaved Changes"), tr("%1 has changes that are not saved.").arg(m_document.name()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

void MainWindow::showError(const QString& message) {
    m_messages->showMessage(message, widgets::MessageBar::Kind::Error);
    Q_EMIT errorShown(message);
}

void MainWindow::showNote(const QString& message) {
    m_messages->showMessage(message, widgets::MessageBar::Kind::Note);
}

void MainWindow::showTitle() {
    setWindowTitle(tr("%1[*] — Chiaro").arg(m_document.name()));
    setWindowModified(m_document.isModified());
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
    if (!mayDiscard()) return event->ignore();
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
