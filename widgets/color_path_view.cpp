#include "widgets/color_path_view.h"

#include "core/base/error.h"
#include "core/gradient/color_presets.h"
#include "widgets/color_path_bar.h"
#include "widgets/eyedropper.h"
#include "widgets/path_through.h"
#include "widgets/picture.h"
#include "widgets/tool_button.h"
#include "widgets/wheel_guard.h"

#include <QtWidgets>

namespace chiaro::widgets {

namespace {

constexpr int longestText = 20'000;

QPixmap swatch(const QImage& colors, QSize size, double ratio) {
    QPixmap pixmap(size * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    QPainterPath outline;
    outline.addRoundedRect(QRectF(QPointF(0, 0), QSizeF(size)), 2, 2);
    painter.setClipPath(outline);
    painter.drawImage(QRectF(QPointF(0, 0), QSizeF(size)), colors);
    painter.end();
    return pixmap;
}

}  // namespace

ColorPathView::ColorPathView(QWidget* parent)
    : QWidget(parent), m_recolor(new QCheckBox(tr("Recolour"))), m_bar(new ColorPathBar) {
    m_recolor->setObjectName("recolour");
    m_recolor->setToolTip(tr("Off: the sample's own colours"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(makeHeader());
    layout->addWidget(m_bar);
    layout->addWidget(m_note);
    m_tools = makeTools();
    layout->addWidget(m_tools);
    layout->addWidget(makePresets());

    connect(m_recolor, &QCheckBox::toggled, this, [this](bool on) {
        if (m_last.stops.empty()) m_last = pathThrough(m_own);
        editOnce(on ? std::optional(m_last) : std::nullopt);
    });
    connect(m_bar, &ColorPathBar::pathEdited, this, &ColorPathView::edit);
    connect(m_bar, &ColorPathBar::editFinished, this, &ColorPathView::editFinished);
    connect(m_bar, &ColorPathBar::selectionChanged, this, &ColorPathView::showStop);
    connect(m_bar, &ColorPathBar::colorWanted, this, &ColorPathView::chooseColor);
    connect(m_bar, &ColorPathBar::copyWanted, this, &ColorPathView::copy);
    connect(m_bar, &ColorPathBar::pasteWanted, this, &ColorPathView::paste);
    setOwnColors({});
}

QWidget* ColorPathView::makeHeader() {
    auto* header = new QWidget;
    auto* copyButton =
        makeToolButton("duplicate", tr("Copy colours"), tr("Copy the stops as text (Ctrl+C on the bar)"));
    auto* pasteButton = makeToolButton(
        "paste", tr("Paste colours"),
        tr("Show the stops that were copied, here or from any text such as 0 #201040, 1 #fff0b0 (Ctrl+V on "
           "the bar)"));
    m_note = new QLabel;
    m_note->setObjectName("paste-note");
    m_note->setProperty("note", true);
    m_note->setWordWrap(true);
    m_note->hide();
    m_header = new QHBoxLayout(header);
    m_header->setContentsMargins(0, 0, 0, 0);
    m_header->setSpacing(2);
    m_header->addWidget(m_recolor, 1);
    m_header->addWidget(copyButton);
    m_header->addWidget(pasteButton);
    connect(copyButton, &QToolButton::clicked, this, &ColorPathView::copy);
    connect(pasteButton, &QToolButton::clicked, this, &ColorPathView::paste);
    return header;
}

void ColorPathView::addTool(QWidget* tool) {
    QWidget* before = m_header->itemAt(m_header->count() - 1)->widget();
    m_header->addWidget(tool);
    setTabOrder(before, tool);
}

QWidget* ColorPathView::makeTools() {
    auto* tools = new QWidget;
    m_color = makeToolButton("color", tr("Colour"), tr("Change the selected stop's colour (Enter)"));
    m_position = new QDoubleSpinBox;
    m_position->setObjectName("stop-position");
    m_position->setAccessibleName(tr("Position"));
    m_position->setToolTip(tr("The selected stop's place, 0 dark to 1 light"));
    m_position->setRange(0, 1);
    m_position->setDecimals(3);
    m_position->setSingleStep(0.01);
    m_position->setKeyboardTracking(false);
    WheelGuard::protect(m_position);
    auto* add = makeToolButton("add", tr("Add stop"), tr("Add a stop (Ctrl+click on the bar, or Insert)"));
    m_remove = makeToolButton("remove", tr("Remove stop"), tr("Remove the selected stop (Delete)"));
    auto* turn = makeToolButton("flip", tr("Flip"), tr("Swap the dark and the light end"));
    m_distribute = makeToolButton("distribute", tr("Distribute"), tr("Space the stops evenly"));
    m_space = new QComboBox;
    m_space->setObjectName("space");
    m_space->setAccessibleName(tr("Interpolation"));
    m_space->setToolTip(tr("How colours between stops are mixed: as the report does, or evenly to the eye"));
    m_space->addItems({tr("RGB"), tr("Oklab")});
    WheelGuard::protect(m_space);

    auto* pick = makeToolButton(
        "eyedropper", tr("Pick colour"),
        tr("Take the selected stop's colour from the strip's pictures or anywhere on the screen: click or "
           "Enter picks, Escape doesn't"));
    m_eyedropper = new Eyedropper(pick);

    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    row->addWidget(m_color);
    row->addWidget(pick);
    row->addWidget(m_position, 1);
    row->addSpacing(4);
    for (QToolButton* button : {add, m_remove, turn, m_distribute}) row->addWidget(button);
    row->addSpacing(4);
    row->addWidget(m_space, 1);

    connect(m_color, &QToolButton::clicked, this, &ColorPathView::chooseColor);
    connect(pick, &QToolButton::clicked, m_eyedropper, &Eyedropper::start);
    connect(m_eyedropper, &Eyedropper::hovered, this, &ColorPathView::showPatch);
    connect(m_eyedropper, &Eyedropper::cancelled, this, &ColorPathView::showStop);
    connect(m_eyedropper, &Eyedropper::picked, this, [this](glm::vec3 color) {
        m_bar->recolorSelected(color);
        showStop();
        Q_EMIT editFinished();
    });
    connect(m_position, &QDoubleSpinBox::valueChanged, this,
            [this](double position) { m_bar->moveSelected(float(position)); });
    connect(m_position, &QDoubleSpinBox::editingFinished, this, &ColorPathView::editFinished);
    connect(add, &QToolButton::clicked, m_bar, &ColorPathBar::addBesideSelected);
    connect(m_remove, &QToolButton::clicked, m_bar, &ColorPathBar::removeSelected);
    connect(turn, &QToolButton::clicked, this, &ColorPathView::flip);
    connect(m_distribute, &QToolButton::clicked, this, &ColorPathView::distribute);
    connect(m_space, &QComboBox::activated, this, [this](int space) {
        gradient::ColorPath path = *m_path;
        path.space = gradient::ColorPath::Space(space);
        editOnce(path);
    });
    return tools;
}

QWidget* ColorPathView::makePresets() {
    auto* presets = new QWidget;
    auto* grid = new QGridLayout(presets);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    constexpr int columns = 4;
    const QSize size(60, 16);
    int number = 0;
    for (const gradient::ColorPreset& preset : gradient::colorPresets()) {
        const QString name = QCoreApplication::translate("ColorPreset", preset.name);
        auto* button = new QToolButton;
        button->setObjectName(QString("preset-%1").arg(number));
        button->setAccessibleName(name);
        button->setToolTip(name);
        button->setIcon(swatch(toImage(preset.path.sampled(64)), size, devicePixelRatioF()));
        button->setIconSize(size);
        button->setAutoRaise(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this, [this, path = preset.path] { editOnce(path); });
        grid->addWidget(button, number / columns, number % columns);
        ++number;
    }
    return presets;
}

void ColorPathView::setRecoloring(const std::optional<gradient::ColorPath>& path) {
    m_path = path;
    if (path) m_last = *path;
    showPath();
}

void ColorPathView::setOwnColors(const gradient::Gradient& colors) {
    m_own = colors;
    setEnabled(!colors.empty());
    m_bar->setOwnColors(colors);
    showPath();
}

void ColorPathView::startAfresh() {
    m_eyedropper->cancel();
    say({});
    m_last = {};
    m_bar->select(-1);
    setRecoloring(std::nullopt);
}

void ColorPathView::flip() {
    gradient::ColorPath path = *m_path;
    std::reverse(path.stops.begin(), path.stops.end());
    for (gradient::ColorStop& stop : path.stops) stop.position = 1 - stop.position;
    const int mirrored = int(path.stops.size()) - 1 - m_bar->selected();
    editOnce(path);
    m_bar->select(mirrored);
}

void ColorPathView::distribute() {
    gradient::ColorPath path = *m_path;
    if (path.stops.size() < 2) return;
    for (std::size_t i = 0; i < path.stops.size(); ++i)
        path.stops[i].position = float(i) / float(path.stops.size() - 1);
    editOnce(path);
}

gradient::ColorPath ColorPathView::shownPath() const {
    if (m_path) return *m_path;
    return m_own.empty() ? gradient::ColorPath{} : pathThrough(m_own);
}

void ColorPathView::copy() const {
    const gradient::ColorPath path = shownPath();
    if (path.stops.empty()) return;
    QGuiApplication::clipboard()->setText(QString::fromStdString(gradient::colorPathText(path)));
}

void ColorPathView::paste() {
    const QString text = QGuiApplication::clipboard()->text().simplified();
    try {
        if (text.isEmpty())
            throw Error("the clipboard", "has no text", "copy stops such as 0 #201040, 1 #fff0b0 first");
        const auto space = m_path ? m_path->space : gradient::ColorPath::Space::Rgb;
        editOnce(gradient::parseColorPath(text.left(longestText).toStdString(), space));
        say({});
    } catch (const Error& error) {
        say(QString::fromStdString(error.what()));
    }
}

void ColorPathView::say(const QString& note) {
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
}

void ColorPathView::edit(const std::optional<gradient::ColorPath>& path) {
    if (path == m_path) return;
    m_path = path;
    if (path) m_last = *path;
    say({});
    showPath();
    Q_EMIT recoloringEdited(path);
}

void ColorPathView::editOnce(const std::optional<gradient::ColorPath>& path) {
    edit(path);
    Q_EMIT editFinished();
}

void ColorPathView::chooseColor() {
    if (!m_path || m_bar->selected() < 0) return;
    const int stop = m_bar->selected();
    const QColor before = toColor(m_path->stops[std::size_t(stop)].color);
    auto* dialog = new QColorDialog(before, window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Colour of Stop %1").arg(stop + 1));
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    // The whole session with the dialog is one step; cancelling it brings the colour back.
    connect(dialog, &QColorDialog::currentColorChanged, m_bar,
            [this](const QColor& color) { m_bar->recolorSelected(fromColor(color)); });
    connect(dialog, &QColorDialog::rejected, m_bar,
            [this, original = m_path->stops[std::size_t(stop)].color] { m_bar->recolorSelected(original); });
    connect(dialog, &QColorDialog::finished, this, &ColorPathView::editFinished);
    dialog->open();
}

void ColorPathView::showPath() {
    const QSignalBlocker quietRecolor(m_recolor);
    m_recolor->setChecked(m_path.has_value());
    m_bar->setEnabled(m_path.has_value());
    m_tools->setEnabled(m_path.has_value());
    m_bar->setPath(m_path.value_or(gradient::ColorPath{}));
    const QSignalBlocker quietSpace(m_space);
    m_space->setCurrentIndex(m_path ? int(m_path->space) : 0);
    m_distribute->setEnabled(m_path && m_path->stops.size() > 2);
    if (m_path && m_bar->selected() < 0) m_bar->select(0);
    showStop();
}

void ColorPathView::showStop() {
    const int stop = m_bar->selected();
    const bool chosen = m_path && stop >= 0 && stop < int(m_path->stops.size());
    m_color->setEnabled(chosen);
    m_position->setEnabled(chosen);
    m_remove->setEnabled(chosen && m_path->stops.size() > 1);
    const QSignalBlocker quiet(m_position);
    m_position->setValue(chosen ? double(m_path->stops[std::size_t(stop)].position) : 0);
    if (chosen)
        showPatch(m_path->stops[std::size_t(stop)].color);
    else
        m_color->setIcon(icon("color"));
}

void ColorPathView::showPatch(glm::vec3 color) {
    QPixmap patch(16, 16);
    patch.fill(toColor(color));
    m_color->setIcon(patch);
}

}  // namespace chiaro::widgets
