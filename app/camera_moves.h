#pragma once

#include "app/change.h"
#include "widgets/viewport/camera_history.h"

#include <QObject>
#include <QTimer>

class QAction;
class QMenu;

namespace chiaro::widgets {
class Viewport;
}

namespace chiaro::app {

class Document;

/// Takes back where the artist looked, and looks there again: a history of its own beside the document's.
class CameraMoves : public QObject {
    Q_OBJECT

public:
    CameraMoves(Document& document, widgets::Viewport& viewport, QObject* parent);

    QAction* previousAction() const { return m_previous; }
    QAction* nextAction() const { return m_next; }

private:
    void endMove();
    void step(bool isBack);
    void showActions();

    widgets::Viewport& m_viewport;
    widgets::CameraHistory m_history;
    QTimer m_rest;  ///< keys and wheel turns that follow each other sooner are one move
    bool m_isStepping = false;
    QAction* m_previous = nullptr;
    QAction* m_next = nullptr;
};

}  // namespace chiaro::app
