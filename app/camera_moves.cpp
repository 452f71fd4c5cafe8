#include "app/camera_moves.h"

#include "app/document.h"
#include "widgets/tool_button.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int restMilliseconds = 500;

}  // namespace

CameraMoves::CameraMoves(Document& document, widgets::Viewport& viewport, QObject* parent)
    : QObject(parent), m_viewport(viewport) {
    const auto make = [this](const char* icon, const QString& text, const char* keys, bool isBack) {
        auto* action = new QAction(widgets::icon(icon), text, this);
        action->setObjectName(icon);
        action->setShortcut(QKeySequence(keys));
        connect(action, &QAction::triggered, this, [this, isBack] { step(isBack); });
        return action;
    };
    m_previous = make("camera-previous", tr("&Previous Camera"), "Alt+Left", true);
    m_next = make("camera-next", tr("Ne&xt Camera"), "Alt+Right", false);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        if (m_viewport.isDragging())
            m_rest.start();
        else
            endMove();
    });
    connect(&viewport, &widgets::Viewport::cameraAboutToBeEdited, this, [this] {
        if (m_isStepping) return;
        m_history.beginMove(m_viewport.camera());
        m_rest.start();
        showActions();
    });
    connect(&viewport, &widgets::Viewport::cameraEditFinished, this, &CameraMoves::endMove);
    connect(&document, &Document::changed, this, [this](Change change) {
        if (change.kind != Change::Kind::Everything) return;
        m_history.clear();
        showActions();
    });
    showActions();
}

void CameraMoves::endMove() {
    m_rest.stop();
    m_history.endMove(m_viewport.camera());
    showActions();
}

void CameraMoves::step(bool isBack) {
    m_rest.stop();
    const scene::Camera now = m_viewport.camera();
    const auto there = isBack ? m_history.back(now) : m_history.forth(now);
    m_isStepping = true;
    if (there) m_viewport.moveCamera(*there);
    m_isStepping = false;
    showActions();
}

void CameraMoves::showActions() {
    m_previous->setEnabled(m_history.canGoBack());
    m_next->setEnabled(m_history.canGoForth());
}

}  // namespace chiaro::app
