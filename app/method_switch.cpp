#include "app/method_switch.h"

#include "app/document.h"
#include "core/project/render_method.h"
#include "widgets/core_text.h"
#include "widgets/tool_button.h"

#include <QtWidgets>

#include <array>

namespace chiaro::app {

namespace {

/// What an artist is told of a method, by its key; the core's label is all that is known of others.
struct Hint {
    const char* key;
    const char* icon;
    const char* text;
};
constexpr std::array hints{
    Hint{"image-based", "method-image-based",
         QT_TRANSLATE_NOOP("chiaro::app::MethodSwitch",
                           "The paint is laid right into the picture, each piece where it is as light as the "
                           "object: the best-looking single pictures")},
    Hint{"view-aligned", "method-view-aligned",
         QT_TRANSLATE_NOOP("chiaro::app::MethodSwitch",
                           "Strokes that face the viewer, from a 3D texture: every frame in real time")},
    Hint{"view-dependent", "method-view-dependent",
         QT_TRANSLATE_NOOP("chiaro::app::MethodSwitch",
                           "Strokes that stay on the object, painted from many sides: made once, then every "
                           "frame in real time")},
};

const Hint* hintOf(const std::string& key) {
    const auto found = std::ranges::find_if(hints, [&](const Hint& hint) { return key == hint.key; });
    return found == hints.end() ? nullptr : &*found;
}

}  // namespace

MethodSwitch::MethodSwitch(Document& document, QObject* parent)
    : QObject(parent), m_document(document), m_actions(new QActionGroup(this)) {
    m_actions->setExclusionPolicy(QActionGroup::ExclusionPolicy::Exclusive);
    int number = 0;
    for (const project::RenderMethod& method : project::renderMethods()) {
        auto* action = new QAction(widgets::coreText(method.label), m_actions);
        const QString key = QString::number(++number);
        action->setObjectName("method-" + QString::fromStdString(method.key));
        action->setData(QString::fromStdString(method.key));
        action->setShortcut(QKeySequence(key));
        action->setCheckable(true);
        if (const Hint* hint = hintOf(method.key)) {
            action->setIcon(widgets::icon(hint->icon));
            action->setToolTip(tr("%1 (%2)\n%3").arg(action->text(), key, tr(hint->text)));
        }
    }
    connect(m_actions, &QActionGroup::triggered, this, [this](const QAction* action) {
        m_document.finishEdit();
        m_document.editMethod(action->data().toString().toStdString());
        m_document.finishEdit();
    });
    connect(&document, &Document::changed, this, &MethodSwitch::applyChange);
    applyChange({});
}

void MethodSwitch::addTo(QMenu& menu) const {
    menu.addActions(m_actions->actions());
}

void MethodSwitch::addTo(QToolBar& bar) const {
    for (QAction* action : m_actions->actions()) {
        bar.addAction(action);
        QWidget* button = bar.widgetForAction(action);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAccessibleName(action->text());
        button->setObjectName(action->objectName());
    }
}

QString MethodSwitch::shownLabel() const {
    const QAction* shown = m_actions->checkedAction();
    return shown ? shown->text() : QString();
}

void MethodSwitch::applyChange(Change change) {
    if (change.kind != Change::Kind::Everything && change.kind != Change::Kind::Method) return;
    for (QAction* action : m_actions->actions())
        action->setChecked(action->data().toString().toStdString() == m_document.project().method);
}

}  // namespace chiaro::app
