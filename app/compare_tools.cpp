#include "app/compare_tools.h"

#include "app/document.h"
#include "app/heat_maps.h"
#include "core/project/render_method.h"
#include "widgets/compare_bar.h"
#include "widgets/compare_view.h"
#include "widgets/core_text.h"
#include "widgets/tool_button.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

using widgets::Composition;

namespace {

constexpr double step = 0.05;            ///< of a wipe's position and a blend, by keys
constexpr double turn = 5;               ///< of a wipe's angle, degrees
constexpr int figureMilliseconds = 200;  ///< numbers that change faster can't be read

/// What an artist is told of a mode.
struct ModeHint {
    Composition::Mode mode;
    const char* key;  ///< in settings, and of its icon after "compare-"
    const char* label;
    const char* tooltip;
};
using Mode = Composition::Mode;
constexpr std::array modeHints{
    ModeHint{Mode::Single, "single", QT_TRANSLATE_NOOP("chiaro::app::CompareTools", "Single"),
             QT_TRANSLATE_NOOP("chiaro::app::CompareTools", "One method fills the viewport")},
    ModeHint{Mode::SideBySide, "side-by-side", QT_TRANSLATE_NOOP("chiaro::app::CompareTools", "Side by Side"),
             QT_TRANSLATE_NOOP("chiaro::app::CompareTools", "Two or three methods beside each other")},
    ModeHint{Mode::Wipe, "wipe", QT_TRANSLATE_NOOP("chiaro::app::CompareTools", "Wipe"),
             QT_TRANSLATE_NOOP("chiaro::app::CompareTools",
                               "One method on each side of a line, which is dragged and turned")},
    ModeHint{Mode::Blend, "blend", QT_TRANSLATE_NOOP("chiaro::app::CompareTools", "Blend"),
             QT_TRANSLATE_NOOP("chiaro::app::CompareTools", "One method laid over the other")},
    ModeHint{Mode::Difference, "difference", QT_TRANSLATE_NOOP("chiaro::app::CompareTools", "Difference"),
             QT_TRANSLATE_NOOP("chiaro::app::CompareTools",
                               "How far two methods are apart; black where they are equal")},
};

/// The methods that the viewport can draw, as the project names them.
std::vector<widgets::NamedMethod> namedMethods() {
    std::vector<widgets::NamedMethod> named;
    for (const project::RenderMethod& method : project::renderMethods())
        if (std::ranges::find(widgets::drawnMethods(), method.key) != widgets::drawnMethods().end())
            named.push_back({method.key, widgets::coreText(method.label)});
    return named;
}

}  // namespace

CompareTools::CompareTools(Document& document, widgets::Viewport& viewport, ViewMeasures& measures,
                           QObject* parent)
    : QObject(parent),
      m_document(document),
      m_viewport(viewport),
      m_measures(measures),
      m_view(new widgets::CompareView(viewport, namedMethods())),
      m_bar(new widgets::CompareBar) {
    makeModes();
    makeSteps();
    restore();
    connect(m_view, &widgets::CompareView::compositionEdited, this, &CompareTools::edit);
    connect(m_bar, &widgets::CompareBar::compositionEdited, this, &CompareTools::edit);
    connect(m_view, &widgets::CompareView::methodChosen, this,
            [this](int picture, const QString& key) { setMethod(picture, key.toStdString()); });
    connect(m_bar, &widgets::CompareBar::paneCountEdited, this, &CompareTools::setPaneCount);
    connect(&document, &Document::changed, this, &CompareTools::applyChange);
    connect(&viewport, &widgets::Viewport::panesChanged, m_bar,
            [this] { m_bar->setComposition(m_composition, m_viewport.size()); });
    connect(&measures, &ViewMeasures::measureChanged, this, &CompareTools::showFigures);
    auto* soon = new QTimer(this);
    soon->setSingleShot(true);
    soon->setInterval(figureMilliseconds);
    connect(soon, &QTimer::timeout, this, &CompareTools::showFigures);
    connect(&viewport, &widgets::Viewport::frameDrawn, soon, [this, soon] {
        if (m_composition.mode != Mode::Single && !soon->isActive()) soon->start();
    });
    keepDocumentsMethod();
}

void CompareTools::makeModes() {
    m_modes = new QActionGroup(this);
    int number = 0;
    for (const ModeHint& hint : modeHints) {
        const QString name = QString("compare-%1").arg(hint.key);
        const QKeySequence keys(QString("Ctrl+%1").arg(++number));
        auto* action = new QAction(widgets::icon(qPrintable(name)), tr(hint.label), m_modes);
        action->setObjectName(name);
        action->setShortcut(keys);
        action->setCheckable(true);
        action->setToolTip(tr("%1 (%2)\n%3").arg(action->text(), keys.toString(), tr(hint.tooltip)));
        connect(action, &QAction::triggered, this, [this, mode = hint.mode] { setMode(mode); });
    }
}

QAction* CompareTools::addStep(const char* name, const QString& text, const QKeySequence& keys,
                               const QString& tooltip, std::function<Composition(Composition)> step) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setShortcut(keys);
    action->setToolTip(tooltip);
    connect(action, &QAction::triggered, this, [this, step = std::move(step)] { edit(step(m_composition)); });
    m_steps.push_back(action);
    return action;
}

/// What the numbers do, by keys.
void CompareTools::makeSteps() {
    const auto moved = [this](Composition composition, int way) {
        composition.blend = std::clamp(composition.blend + way * step, 0.0, 1.0);
        composition.gain =
            std::clamp(way > 0 ? composition.gain * 2 : composition.gain / 2, 1.0, Composition::largestGain);
        if (composition.mode != Mode::Blend) composition.blend = m_composition.blend;
        if (composition.mode != Mode::Difference) composition.gain = m_composition.gain;
        if (composition.mode != Mode::Wipe) return composition;
        const QSizeF size = m_viewport.size();
        return widgets::wipedTo(composition, size, widgets::wipePosition(composition, size) + way * step);
    };
    const auto turned = [](Composition composition, double by) {
        composition.wipeAngle = std::remainder(composition.wipeAngle + by, 360.0);
        return composition;
    };
    const QString less = tr("Move the wipe, or lessen the blend or the gain");
    const QString more = tr("Move the wipe, or raise the blend or the gain");
    addStep("compare-less", tr("&Less"), QKeySequence("["), less, [moved](auto c) { return moved(c, -1); });
    addStep("compare-more", tr("&More"), QKeySequence("]"), more, [moved](auto c) { return moved(c, 1); });
    addStep("compare-turn-left", tr("Turn Wipe &Left"), QKeySequence("Alt+["),
            tr("Turn the wipe's line by 5° counter-clockwise"),
            [turned](auto c) { return turned(c, -turn); });
    addStep("compare-turn-right", tr("Turn Wipe &Right"), QKeySequence("Alt+]"),
            tr("Turn the wipe's line by 5° clockwise"), [turned](auto c) { return turned(c, turn); });
    m_swap = new QAction(tr("S&wap Methods"), this);
    m_swap->setObjectName("compare-swap");
    m_swap->setShortcut(QKeySequence("X"));
    m_swap->setToolTip(tr("Let the first and the second method change places"));
    connect(m_swap, &QAction::triggered, this, [this] { setMethod(0, m_methods[1]); });
}

void CompareTools::addTo(QMenu& menu) {
    QMenu* compare = menu.addMenu(tr("&Compare"));
    compare->addActions(m_modes->actions());
    compare->addSeparator();
    addMethods(*compare);
    compare->addAction(m_swap);
    compare->addSeparator();
    for (QAction* action : m_steps) compare->addAction(action);
    show();
}

void CompareTools::addMethods(QMenu& menu) {
    const std::array names{tr("&First Method"), tr("Se&cond Method"), tr("&Third Method")};
    for (int place = 0; place < int(names.size()); ++place) {
        QMenu* choice = menu.addMenu(names[std::size_t(place)]);
        auto* group = new QActionGroup(choice);
        for (const widgets::NamedMethod& method : namedMethods()) {
            QAction* action = group->addAction(choice->addAction(method.label));
            action->setCheckable(true);
            action->setData(QString::fromStdString(method.key));
        }
        connect(group, &QActionGroup::triggered, this, [this, place](const QAction* action) {
            setMethod(place, action->data().toString().toStdString());
        });
        m_choices.push_back(group);
    }
}

void CompareTools::addTo(QToolBar& bar) {
    auto* label = new QLabel(tr("Compare"));
    label->setProperty("note", true);
    label->setContentsMargins(10, 0, 2, 0);
    bar.addWidget(label);
    for (QAction* action : m_modes->actions()) {
        bar.addAction(action);
        QWidget* button = bar.widgetForAction(action);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAccessibleName(tr("Compare: %1").arg(action->text()));
        button->setObjectName(action->objectName());
    }
    bar.addWidget(m_bar);
    show();
}

void CompareTools::restore() {
    const QSettings settings;
    const QString mode = settings.value("compare/mode").toString();
    for (const ModeHint& hint : modeHints)
        if (mode == hint.key) m_composition.mode = hint.mode;
    std::vector<std::string> methods;
    const auto take = [&](const std::string& key) {
        const bool isNew = std::ranges::find(methods, key) == methods.end();
        if (isNew && methods.size() < m_methods.size()) methods.push_back(key);
    };
    const std::vector<widgets::NamedMethod> known = namedMethods();
    for (const QString& key : settings.value("compare/methods").toStringList())
        if (std::ranges::any_of(known, [&](const auto& one) { return one.key == key.toStdString(); }))
            take(key.toStdString());
    for (const widgets::NamedMethod& method : known) take(method.key);
    std::ranges::copy(methods, m_methods.begin());
    m_paneCount = std::clamp(settings.value("compare/panes", 2).toInt(), 2, int(m_methods.size()));
    const Composition initial;
    const auto number = [&](const char* key, double standard, double least, double most) {
        return std::clamp(settings.value(key, standard).toDouble(), least, most);
    };
    m_composition.wipeCenter = {number("compare/wipe-x", 0.5, 0, 1), number("compare/wipe-y", 0.5, 0, 1)};
    m_composition.wipeAngle = number("compare/wipe-angle", initial.wipeAngle, -180, 180);
    m_composition.blend = number("compare/blend", initial.blend, 0, 1);
    m_composition.gain = number("compare/gain", initial.gain, 1, Composition::largestGain);
}

void CompareTools::keep() const {
    QSettings settings;
    for (const ModeHint& hint : modeHints)
        if (m_composition.mode == hint.mode) settings.setValue("compare/mode", hint.key);
    QStringList methods;
    for (const std::string& key : m_methods) methods << QString::fromStdString(key);
    settings.setValue("compare/methods", methods);
    settings.setValue("compare/panes", m_paneCount);
    settings.setValue("compare/wipe-x", m_composition.wipeCenter.x);
    settings.setValue("compare/wipe-y", m_composition.wipeCenter.y);
    settings.setValue("compare/wipe-angle", m_composition.wipeAngle);
    settings.setValue("compare/blend", m_composition.blend);
    settings.setValue("compare/gain", m_composition.gain);
}

void CompareTools::setMode(Mode mode) {
    Composition composition = m_composition;
    composition.mode = mode;
    edit(composition);
}

void CompareTools::setMethod(int picture, const std::string& key) {
    std::string& replaced = m_methods[std::size_t(picture)];
    const auto before = std::ranges::find(m_methods, key);
    if (before != m_methods.end())
        std::swap(*before, replaced);
    else
        replaced = key;
    edit(m_composition);
}

void CompareTools::setPaneCount(int count) {
    m_paneCount = count;
    edit(m_composition);
}

void CompareTools::edit(const Composition& composition) {
    m_composition = composition;
    keep();
    show();
}

void CompareTools::applyChange(Change change) {
    if (change.kind == Change::Kind::Everything || change.kind == Change::Kind::Method) keepDocumentsMethod();
}

/// Choosing a method shows it: one that is not seen takes the first place.
void CompareTools::keepDocumentsMethod() {
    const std::string& method = m_document.project().method;
    const bool isNew = std::exchange(m_documentsMethod, method) != method;
    const bool isKnown = std::ranges::find(widgets::drawnMethods(), method) != widgets::drawnMethods().end();
    const auto end = m_methods.begin() + (m_composition.mode == Mode::SideBySide ? m_paneCount : 2);
    if (isNew && isKnown && std::find(m_methods.begin(), end, method) == end) setMethod(0, method);
    show();
}

void CompareTools::show() {
    const int count = m_composition.mode == Mode::SideBySide ? m_paneCount : 2;
    m_composition.methods.assign(m_methods.begin(), m_methods.begin() + count);
    const bool isComparing = m_composition.mode != Mode::Single;
    m_viewport.setComposition(m_composition);  // first: what is made now is made as large as it is shown
    m_document.setComparedMethods(isComparing ? m_composition.methods : std::vector<std::string>());
    m_view->setActiveMethod(m_document.project().method);
    m_view->setComposition(m_composition);
    m_bar->setComposition(m_composition, m_viewport.size());
    m_modes->actions()[int(m_composition.mode)]->setChecked(true);
    for (std::size_t place = 0; place < m_choices.size(); ++place) {
        for (QAction* action : m_choices[place]->actions())
            action->setChecked(action->data().toString().toStdString() == m_methods[place]);
        m_choices[place]->setEnabled(isComparing && int(place) < count);
    }
    m_swap->setEnabled(isComparing);
    const bool hasAmount = isComparing && m_composition.mode != Mode::SideBySide;
    for (QAction* action : m_steps) {
        const bool turns = action->objectName().startsWith("compare-turn");
        action->setEnabled(turns ? m_composition.mode == Mode::Wipe : hasAmount);
    }
    showFigures();
}

void CompareTools::showFigures() {
    const std::vector<double>& times = m_viewport.methodTimes();
    const std::size_t count = m_composition.shownCount();
    if (count == 1) return;
    for (std::size_t picture = 0; picture < count; ++picture) {
        QStringList figures;
        if (times.size() == count) figures << tr("%1 ms").arg(times[picture], 0, 'f', 1);
        m_view->setFigures(picture, figures + measureTexts(m_measures, picture));
    }
}

QString CompareTools::shownLabel() const {
    if (m_composition.shownCount() == 1) return {};
    QStringList labels;
    for (const std::string& key : m_composition.methods)
        labels << widgets::coreText(project::renderMethod(key).label);
    return labels.join(" / ");
}

}  // namespace chiaro::app
