#pragma once

#include "app/change.h"
#include "core/scene/path.h"

#include <QDockWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QSpinBox;
class QToolButton;

namespace chiaro::widgets {
class Timeline;
}

namespace chiaro::app {

class Document;
class Playback;

/// The document's frames: which one is shown, playing them, keys of the camera and the light, turns, and the
/// range that is rendered.
class TimelineDock : public QDockWidget {
    Q_OBJECT

public:
    TimelineDock(Document& document, Playback& playback);

    widgets::Timeline* timeline() const { return m_timeline; }
    /// Playing and keys, with their shortcuts.
    void addTo(QMenu& menu);

public Q_SLOTS:
    void setCurrentFrame(int frame);
    void togglePlaying();
    /// Keys what the current frame shows.
    void keyCamera();
    void keyLight();

private:
    QWidget* makeTransport();
    QWidget* makeKeys();
    QSpinBox* addNumber(QHBoxLayout& row, const char* key, const QString& name, const QString& tooltip);
    void connectParts();
    void applyChange(Change change);
    void showAnimation();
    void showKeyButtons();
    void setTurn(double scene::Path::*turn, bool on, const QString& text);
    void removeSelectedKey();
    template <class Edit>
    void edit(const QString& text, Edit edit);

    Document& m_document;
    Playback& m_playback;
    widgets::Timeline* m_timeline = nullptr;
    QToolButton* m_play = nullptr;
    QToolButton* m_previous = nullptr;
    QToolButton* m_next = nullptr;
    QToolButton* m_removeKey = nullptr;
    QToolButton* m_turntable = nullptr;
    QToolButton* m_sweep = nullptr;
    QSpinBox* m_frame = nullptr;
    QSpinBox* m_frames = nullptr;
    QSpinBox* m_rate = nullptr;
    QSpinBox* m_first = nullptr;
    QSpinBox* m_last = nullptr;
    QComboBox* m_interpolation = nullptr;
    QLabel* m_measured = nullptr;
};

}  // namespace chiaro::app
