#include "app/docks/view_planning_dock.h"

#include "app/document.h"
#include "app/jobs/job_runner.h"
#include "app/meshes.h"
#include "app/preset_menu.h"
#include "core/project/pipeline.h"
#include "widgets/coverage_bar.h"
#include "widgets/parameter_form.h"
#include "widgets/tool_button.h"
#include "widgets/view_sphere.h"
#include "widgets/wheel_guard.h"

#include <QtWidgets>

namespace chiaro::app {

using widgets::ParameterForm;
using widgets::ViewSphere;

namespace {

constexpr int thumbnailSide = 68;
constexpr int thumbnailRows = 3;
constexpr int thumbnailGap = 4;

}  // namespace

ViewPlanningDock::ViewPlanningDock(Document& document, JobRunner& jobs, Memo& memo, Meshes& meshes,
                                   ViewPlans& plans)
    : Dock("view-planning-dock", tr("View Planning"), new QWidget),
      m_document(document),
      m_jobs(jobs),
      m_meshes(meshes),
      m_plans(plans),
      m_pictures(jobs, memo),
      m_objects(new QComboBox),
      m_sphere(new ViewSphere),
      m_details(new QLabel),
      m_coverage(new widgets::CoverageBar),
      m_form(widgets::makeParameterForm<views::ViewParams>()) {
    m_objects->setObjectName("object");
    m_objects->setAccessibleName(tr("Object"));
    m_objects->setToolTip(tr("Whose views these are"));
    widgets::WheelGuard::protect(m_objects);
    m_details->setProperty("note", true);
    m_details->setWordWrap(true);
    m_details->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_details->setMinimumHeight(4 * m_details->fontMetrics().lineSpacing());
    auto* layout = new QVBoxLayout(static_cast<QScrollArea*>(widget())->widget());
    layout->setContentsMargins(10, 8, 10, 10);
    layout->setSpacing(6);
    layout->addWidget(m_objects);
    layout->addWidget(m_sphere);
    layout->addWidget(makeTools());
    layout->addWidget(m_coverage);
    layout->addWidget(makeThumbnails());
    layout->addWidget(m_details);
    layout->addWidget(m_form);
    layout->addStretch(1);
    connectParts();
    applyChange({});
    showObjects();
}

QWidget* ViewPlanningDock::makeTools() {
    auto* tools = new QWidget;
    m_add = widgets::makeToolButton("view-add", tr("Add from camera"),
                                    tr("Place a view where the viewport looks from (the cross)"));
    m_lock = widgets::makeToolButton("lock", tr("Lock"), tr("Keep the selected view as it is (Return)"));
    m_remove = widgets::makeToolButton("remove", tr("Remove view"), tr("Remove the placed view (Delete)"));
    m_replan = widgets::makeToolButton("reset", tr("Plan again"),
                                       tr("Plan again what was cancelled; placed views stay"));
    m_status = new QLabel;
    m_status->setProperty("note", true);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    for (QToolButton* button : {m_add, m_lock, m_remove, m_replan}) row->addWidget(button);
    m_switches = new QHBoxLayout;
    m_switches->setSpacing(2);
    row->addSpacing(8);
    row->addLayout(m_switches);
    row->addStretch(1);
    row->addWidget(m_status);
    row->addWidget(makePresets());
    return tools;
}

QToolButton* ViewPlanningDock::makePresets() {
    using project::PresetKind;
    m_presets = new PresetMenu(
        PresetKind::ViewPlan, PresetMenu::standardFolder(PresetKind::ViewPlan),
        [this]() -> std::optional<project::Preset> {
            if (m_object < 0) return std::nullopt;
            return project::ViewPlanPreset{m_document.project().views, m_document.placedViews(m_object)};
        });
    connect(m_presets, &PresetMenu::failed, this, &ViewPlanningDock::failed);
    connect(m_presets, &PresetMenu::chosen, this, [this](const project::Preset& preset) {
        if (m_object < 0) return;
        m_sphere->setSelected(-1);
        m_document.applyPreset(m_object, std::get<project::ViewPlanPreset>(preset));
    });
    return m_presets->makeButton();
}

void ViewPlanningDock::addSwitches(const QList<QAction*>& actions) {
    QWidget* before = m_replan;
    for (QAction* action : actions) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setAccessibleName(action->toolTip());
        m_switches->addWidget(button);
        setTabOrder(std::exchange(before, button), button);
    }
}

QWidget* ViewPlanningDock::makeThumbnails() {
    m_thumbnails = new QListWidget;
    m_thumbnails->setObjectName("thumbnails");
    m_thumbnails->setAccessibleName(tr("Views"));
    m_thumbnails->setViewMode(QListView::IconMode);
    m_thumbnails->setMovement(QListView::Static);
    m_thumbnails->setResizeMode(QListView::Adjust);
    m_thumbnails->setUniformItemSizes(true);
    m_thumbnails->setIconSize({thumbnailSide, thumbnailSide});
    constexpr int cell = thumbnailSide + thumbnailGap;
    m_thumbnails->setGridSize({cell, cell});
    m_thumbnails->setFixedHeight(thumbnailRows * cell + 2 * m_thumbnails->frameWidth());
    m_thumbnails->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return m_thumbnails;
}

void ViewPlanningDock::connectParts() {
    connect(m_objects, &QComboBox::activated, this, &ViewPlanningDock::selectObject);
    connect(m_sphere, &ViewSphere::selectionChanged, this, &ViewPlanningDock::selectView);
    connect(m_sphere, &ViewSphere::viewMoved, this, &ViewPlanningDock::moveView);
    connect(m_sphere, &ViewSphere::editFinished, &m_document, &Document::finishEdit);
    connect(m_sphere, &ViewSphere::lockWanted, this, &ViewPlanningDock::lock);
    connect(m_sphere, &ViewSphere::removeWanted, this, &ViewPlanningDock::remove);
    connect(m_thumbnails, &QListWidget::currentRowChanged, this, [this](int view) {
        selectView(view);
        if (view >= 0) m_sphere->face(m_list.at(view).view.direction);
    });
    connect(m_add, &QToolButton::clicked, this, &ViewPlanningDock::addFromCamera);
    connect(m_lock, &QToolButton::clicked, this, &ViewPlanningDock::lockSelected);
    connect(m_remove, &QToolButton::clicked, this, &ViewPlanningDock::removeSelected);
    connect(m_replan, &QToolButton::clicked, &m_plans, &ViewPlans::retry);
    connect(m_form, &ParameterForm::valueEdited, this, [this] {
        views::ViewParams params = m_document.project().views;
        views::ViewParams::table().assign(params, m_form->values());
        m_document.editViews(params);
    });
    connect(m_form, &ParameterForm::editFinished, &m_document, &Document::finishEdit);
    connect(&m_document, &Document::changed, this, &ViewPlanningDock::applyChange);
    connect(&m_plans, &ViewPlans::objectsChanged, this, &ViewPlanningDock::showObjects);
    connect(&m_plans, &ViewPlans::planChanged, this, [this](int object) {
        if (object == m_object) showViews();
    });
    connect(&m_pictures, &ViewThumbnails::picturesChanged, this, &ViewPlanningDock::showThumbnails);
    connect(&m_jobs, &JobRunner::jobsChanged, this, &ViewPlanningDock::showStatus);
    connect(this, &QDockWidget::visibilityChanged, this,
            [this](bool visible) { m_plans.setWanted(this, visible); });
}

void ViewPlanningDock::applyChange(Change change) {
    using Kind = Change::Kind;
    if (change.kind == Kind::Everything || change.kind == Kind::Views)
        m_form->setValues(views::ViewParams::table().values(m_document.project().views));
    if (change.kind == Kind::PlacedViews && change.index == m_object) showViews();
    if (change.kind == Kind::Objects && m_objects->count() == int(m_document.project().objects.size()))
        for (int object = 0; object < m_objects->count(); ++object)
            m_objects->setItemText(
                object, QString::fromStdString(m_document.project().objects[std::size_t(object)].name));
}

void ViewPlanningDock::showObjects() {
    const QSignalBlocker quiet(m_objects);
    m_objects->clear();
    for (const scene::Object& object : m_meshes.scene().objects)
        m_objects->addItem(QString::fromStdString(object.name));
    m_objects->setVisible(m_objects->count() > 1);
    m_object = -2;  // whatever is selected now is another object than before
    selectObject(0);
}

void ViewPlanningDock::selectObject(int object) {
    object = std::min(object, m_objects->count() - 1);
    if (object == m_object) return;
    m_object = object;
    m_objects->setCurrentIndex(object);
    m_sphere->setSelected(-1);
    setCamera(camera());
    showViews();
}

scene::Camera ViewPlanningDock::camera() const {
    return m_camera ? *m_camera : project::cameraFor(m_document.project(), m_meshes.scene());
}

void ViewPlanningDock::setCamera(const scene::Camera& camera) {
    m_camera = camera;
    const std::vector<scene::Object> objects = m_meshes.scene().objects;
    const bool isKnown = m_object >= 0 && m_object < int(objects.size());
    m_sphere->setCameraDirection(
        isKnown
            ? std::optional(views::viewFromCamera(camera, objects[std::size_t(m_object)].transform).direction)
            : std::nullopt);
}

int ViewPlanningDock::selectedView() const {
    return m_sphere->selected();
}

void ViewPlanningDock::selectView(int view) {
    m_sphere->setSelected(view);
    showSelection();
}

void ViewPlanningDock::showViews() {
    std::optional<ListedView> selected;
    if (selectedView() >= 0 && selectedView() < m_list.count()) selected = m_list.at(selectedView());
    const auto current = m_plans.plan(m_object);
    m_list.update(m_document.placedViews(m_object), m_plans.lastPlan(m_object), current != nullptr);
    std::vector<widgets::ViewMarker> markers;
    for (int view = 0; view < m_list.count(); ++view) {
        const ListedView& listed = m_list.at(view);
        markers.push_back(
            {listed.view.direction, view + 1, listed.pass, listed.placed >= 0, m_list.description(view)});
    }
    m_sphere->setViews(std::move(markers));
    // Amid a drag the selected view is the one that is held, wherever it is by now.
    m_sphere->setSelected(selected ? m_list.find(*selected) : -1);
    m_coverage->setReport(m_list.plan() ? &m_list.plan()->coverage : nullptr);
    const int pixels = int(std::ceil(thumbnailSide * devicePixelRatioF()));
    m_pictures.show(current ? current : m_list.plan(), pixels, palette().color(QPalette::Base));
    showThumbnails();
    showSelection();
    showStatus();
}

void ViewPlanningDock::showThumbnails() {
    const QSignalBlocker quiet(m_thumbnails);
    while (m_thumbnails->count() > m_list.count()) delete m_thumbnails->takeItem(m_thumbnails->count() - 1);
    while (m_thumbnails->count() < m_list.count()) m_thumbnails->addItem(QString());
    for (int view = 0; view < m_list.count(); ++view) {
        QListWidgetItem* item = m_thumbnails->item(view);
        QIcon icon(thumbnail(view, false));
        icon.addPixmap(thumbnail(view, true), QIcon::Selected);
        item->setIcon(icon);
        item->setToolTip(m_list.description(view));
        item->setData(Qt::AccessibleTextRole, m_list.description(view));
    }
    m_thumbnails->setCurrentRow(selectedView());
}

/// The view's picture with its number, on the shape that it has on the sphere.
QPixmap ViewPlanningDock::thumbnail(int view, bool isSelected) const {
    const double ratio = devicePixelRatioF();
    QPixmap pixmap(QSize(thumbnailSide, thumbnailSide) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(palette().color(QPalette::Base));
    QPainter painter(&pixmap);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const ListedView& listed = m_list.at(view);
    const QImage picture = m_pictures.picture(m_list.plan() ? m_list.plan()->key : 0, listed.group);
    const QRectF all(0, 0, thumbnailSide, thumbnailSide);
    if (!picture.isNull()) painter.drawImage(all.adjusted(3, 3, -3, -3), picture);
    if (isSelected) {
        painter.setPen(QPen(palette().color(QPalette::Text), 2));
        painter.drawRoundedRect(all.adjusted(1, 1, -1, -1), 3, 3);
    }
    const QRectF badge(5, 5, 16, 16);
    painter.setPen(QPen(palette().color(QPalette::Dark), 1));
    const bool isPlaced = listed.placed >= 0;
    painter.setBrush(palette().color(isPlaced ? QPalette::Highlight : QPalette::Text));
    if (isPlaced)
        painter.drawRoundedRect(badge, 2, 2);
    else
        painter.drawEllipse(badge);
    QFont small = font();
    small.setPixelSize(10);
    small.setBold(true);
    painter.setFont(small);
    painter.setPen(palette().color(isPlaced ? QPalette::HighlightedText : QPalette::Base));
    painter.drawText(badge, Qt::AlignCenter, QString::number(view + 1));
    return pixmap;
}

void ViewPlanningDock::changeEvent(QEvent* event) {
    Dock::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_coverage)
        showViews();  // pictures are drawn on its colours
}

void ViewPlanningDock::showSelection() {
    const int view = selectedView();
    {
        const QSignalBlocker quiet(m_thumbnails);
        m_thumbnails->setCurrentRow(view);
    }
    const bool isPlaced = view >= 0 && m_list.at(view).placed >= 0;
    m_add->setEnabled(m_object >= 0);
    m_lock->setEnabled(view >= 0 && !isPlaced);
    m_remove->setEnabled(isPlaced);
    QString text = tr("Select a view to read about it.");
    if (m_list.count() == 0) text.clear();
    if (view >= 0) text = m_list.description(view) + "\n" + m_list.overlaps(view);
    m_details->setText(text);
    Q_EMIT shownViewsChanged();
}

void ViewPlanningDock::showStatus() {
    const bool isCurrent = m_plans.plan(m_object) != nullptr;
    const bool isPlanning = m_jobs.isRunning(ViewPlans::slot);
    m_replan->setEnabled(m_object >= 0 && !isCurrent && !isPlanning);
    m_sphere->setEnabled(m_object >= 0);
    m_form->setEnabled(m_object >= 0);
    if (m_object < 0)
        m_status->setText(tr("No mesh"));
    else if (isCurrent)
        m_status->setText(m_list.count() == 1 ? tr("1 view") : tr("%1 views").arg(m_list.count()));
    else
        m_status->setText(isPlanning ? tr("Planning…") : tr("Not planned"));
}

void ViewPlanningDock::addFromCamera() {
    if (m_object < 0) return;
    const scene::Object object = m_meshes.scene().objects[std::size_t(m_object)];
    const views::View view = views::viewFromCamera(camera(), object.transform);
    const int added = m_document.addView(m_object, {glm::vec3(view.direction), glm::vec3(view.up)});
    m_document.finishEdit();
    selectView(added);
    m_sphere->face(view.direction);
}

void ViewPlanningDock::moveView(int view, const glm::dvec3& direction) {
    const ListedView listed = m_list.at(view);
    const project::PlacedView moved{glm::vec3(direction), glm::vec3(listed.view.up)};
    if (listed.placed >= 0) {
        m_document.moveView(m_object, listed.placed, moved);
        return selectView(listed.placed);
    }
    m_list.take(view);
    selectView(m_document.lockView(m_object, moved));
}

void ViewPlanningDock::lock(int view) {
    const ListedView listed = m_list.at(view);
    if (listed.placed >= 0) return;
    m_list.take(view);
    const int placed =
        m_document.lockView(m_object, {glm::vec3(listed.view.direction), glm::vec3(listed.view.up)});
    m_document.finishEdit();
    selectView(placed);
}

void ViewPlanningDock::remove(int view) {
    const int placed = m_list.at(view).placed;
    if (placed < 0) return;
    m_sphere->setSelected(-1);
    m_document.removeView(m_object, placed);
    m_document.finishEdit();
}

void ViewPlanningDock::lockSelected() {
    if (selectedView() >= 0) lock(selectedView());
}

void ViewPlanningDock::removeSelected() {
    if (selectedView() >= 0) remove(selectedView());
}

}  // namespace chiaro::app
