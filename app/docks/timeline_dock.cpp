#include "app/docks/timeline_dock.h"

#include "app/document.h"
#include "app/playback.h"
#include "widgets/timeline.h"
#include "widgets/tool_button.h"
#include "widgets/wheel_guard.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::app {

using scene::Path;
using widgets::Timeline;

namespace {

/// The lanes of the timeline, from the top.
constexpr std::array parts{Path::Part::Camera, Path::Part::Light};

constexpr int mostFrames = 100'000;

void addGap(QHBoxLayout& row) {
    row.addSpacing(10);
}

}  // namespace

TimelineDock::TimelineDock(Document& document, Playback& playback)
    : QDockWidget(tr("Timeline")), m_document(document), m_playback(playback), m_timeline(new Timeline) {
    setObjectName("timeline-dock");
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(10, 6, 10, 8);
    layout->setSpacing(4);
    layout->addWidget(makeTransport());
    layout->addWidget(m_timeline);
    layout->addWidget(makeKeys());
    layout->addStretch(1);
    setWidget(content);
    connectParts();
    applyChange({});
}

QSpinBox* TimelineDock::addNumber(QHBoxLayout& row, const char* key, const QString& name,
                                  const QString& tooltip) {
    auto* field = new QSpinBox;
    field->setObjectName(key);
    field->setAccessibleName(name);
    field->setToolTip(tooltip);
    field->setRange(1, mostFrames);
    field->setKeyboardTracking(false);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setFixedWidth(56);
    widgets::WheelGuard::protect(field);
    row.addWidget(field);
    connect(field, &QSpinBox::editingFinished, &m_document, &Document::finishEdit);
    return field;
}

QWidget* TimelineDock::makeTransport() {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    const auto addButton = [&](const char* icon, const QString& name, const QString& tooltip) {
        QToolButton* button = widgets::makeToolButton(icon, name, tooltip);
        row->addWidget(button);
        return button;
    };
    auto* first = addButton("first-frame", tr("First frame"), tr("Go to the first frame that is rendered"));
    m_previous = addButton("previous-key", tr("Previous key"), tr("Go to the key before (Down)"));
    m_play = addButton("play", tr("Play"), tr("Play the frames that are rendered (Ctrl+Space)"));
    m_next = addButton("next-key", tr("Next key"), tr("Go to the next key (Up)"));
    auto* last = addButton("last-frame", tr("Last frame"), tr("Go to the last frame that is rendered"));
    addGap(*row);
    row->addWidget(new QLabel(tr("Frame")));
    row->addSpacing(4);
    m_frame = addNumber(*row, "frame", tr("Current frame"), tr("The frame that is shown"));
    row->addSpacing(4);
    row->addWidget(new QLabel(tr("of")));
    row->addSpacing(4);
    m_frames = addNumber(*row, "frames", tr("Frames"),
                         tr("How many frames there are; turns go around once in them"));
    addGap(*row);
    m_rate = addNumber(*row, "rate", tr("Frames a second"), tr("How fast they play, 1..240"));
    m_rate->setRange(1, 240);
    m_rate->setFixedWidth(68);
    m_rate->setSuffix(tr(" fps"));
    m_measured = new QLabel;
    m_measured->setObjectName("measured-rate");
    m_measured->setProperty("note", true);
    m_measured->setToolTip(tr("How many pictures a second were really shown"));
    row->addSpacing(4);
    row->addWidget(m_measured);
    row->addStretch(1);
    connect(first, &QToolButton::clicked, this,
            [this] { setCurrentFrame(m_document.project().animation.firstFrame); });
    connect(last, &QToolButton::clicked, this,
            [this] { setCurrentFrame(m_document.project().animation.lastFrame); });
    connect(m_play, &QToolButton::clicked, this, &TimelineDock::togglePlaying);
    connect(m_previous, &QToolButton::clicked, this, [this] {
        if (const auto frame = m_timeline->keyBefore()) setCurrentFrame(*frame);
    });
    connect(m_next, &QToolButton::clicked, this, [this] {
        if (const auto frame = m_timeline->keyAfter()) setCurrentFrame(*frame);
    });
    return box;
}

QWidget* TimelineDock::makeKeys() {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    const auto addButton = [&](const char* icon, const QString& name, const QString& tooltip) {
        QToolButton* button = widgets::makeToolButton(icon, name, tooltip);
        row->addWidget(button);
        return button;
    };
    auto* camera = addButton("key-camera", tr("Key camera"), tr("Key the camera as it is shown now (K)"));
    auto* light =
        addButton("key-light", tr("Key light"), tr("Key the first light as it is shown now (Shift+K)"));
    m_removeKey = addButton("remove", tr("Remove key"), tr("Remove the selected key (Delete)"));
    addGap(*row);
    m_turntable = addButton("turntable", tr("Turntable"), tr("The camera goes around once over all frames"));
    m_turntable->setCheckable(true);
    m_sweep = addButton("light-sweep", tr("Light sweep"), tr("The lights go around once over all frames"));
    m_sweep->setCheckable(true);
    addGap(*row);
    m_interpolation = new QComboBox;
    m_interpolation->setObjectName("interpolation");
    m_interpolation->setAccessibleName(tr("Between keys"));
    m_interpolation->setToolTip(tr("How things move from key to key"));
    m_interpolation->addItems({tr("Smooth"), tr("Linear")});
    widgets::WheelGuard::protect(m_interpolation);
    row->addWidget(m_interpolation);
    addGap(*row);
    row->addWidget(new QLabel(tr("Render")));
    row->addSpacing(4);
    m_first = addNumber(*row, "first", tr("First frame to render"), tr("The first frame that is rendered"));
    row->addSpacing(4);
    row->addWidget(new QLabel(tr("to")));
    row->addSpacing(4);
    m_last = addNumber(*row, "last", tr("Last frame to render"), tr("The last frame that is rendered"));
    row->addStretch(1);
    connect(camera, &QToolButton::clicked, this, &TimelineDock::keyCamera);
    connect(light, &QToolButton::clicked, this, &TimelineDock::keyLight);
    connect(m_removeKey, &QToolButton::clicked, this, &TimelineDock::removeSelectedKey);
    connect(m_turntable, &QToolButton::clicked, this,
            [this](bool on) { setTurn(&Path::cameraTurn, on, tr("Turntable")); });
    connect(m_sweep, &QToolButton::clicked, this,
            [this](bool on) { setTurn(&Path::lightTurn, on, tr("Light Sweep")); });
    connect(m_interpolation, &QComboBox::activated, this, [this](int choice) {
        edit(tr("Change Interpolation"), [choice](auto& animation) { animation.path.smooth = choice == 0; });
        m_document.finishEdit();
    });
    return box;
}

void TimelineDock::connectParts() {
    connect(m_frame, &QSpinBox::valueChanged, this, &TimelineDock::setCurrentFrame);
    connect(m_frames, &QSpinBox::valueChanged, this, [this](int frames) {
        edit(tr("Change Frames"), [frames](project::Animation& animation) {
            const bool isWhole = animation.lastFrame == animation.frames;
            // Turns stay once around.
            for (double* turn : {&animation.path.cameraTurn, &animation.path.lightTurn})
                *turn *= double(animation.frames) / frames;
            animation.frames = frames;
            animation.lastFrame = isWhole ? frames : std::min(animation.lastFrame, frames);
            animation.firstFrame = std::min(animation.firstFrame, animation.lastFrame);
        });
    });
    connect(m_rate, &QSpinBox::valueChanged, this, [this](int rate) {
        edit(tr("Change Frame Rate"), [rate](project::Animation& animation) { animation.rate = rate; });
    });
    const auto editRange = [this](int first, int last) {
        edit(tr("Change Render Range"), [first, last](project::Animation& animation) {
            animation.firstFrame = std::clamp(first, 1, animation.frames);
            animation.lastFrame = std::clamp(last, animation.firstFrame, animation.frames);
        });
    };
    connect(m_first, &QSpinBox::valueChanged, this,
            [this, editRange](int first) { editRange(first, std::max(first, m_last->value())); });
    connect(m_last, &QSpinBox::valueChanged, this,
            [this, editRange](int last) { editRange(std::min(last, m_first->value()), last); });
    connect(m_timeline, &Timeline::rangeEdited, this, editRange);
    connect(m_timeline, &Timeline::currentFrameEdited, this, &TimelineDock::setCurrentFrame);
    connect(m_timeline, &Timeline::keyMoved, this, [this](int lane, int from, int to) {
        edit(tr("Move Key"), [=](project::Animation& animation) {
            animation.path.moveKey(parts[std::size_t(lane)], from, to);
        });
    });
    connect(m_timeline, &Timeline::keyRemoveWanted, this, &TimelineDock::removeSelectedKey);
    connect(m_timeline, &Timeline::selectionChanged, this, &TimelineDock::showKeyButtons);
    connect(m_timeline, &Timeline::editFinished, &m_document, &Document::finishEdit);
    connect(&m_playback, &Playback::currentFrameChanged, this, [this](int frame) {
        const QSignalBlocker quiet(m_frame);
        m_frame->setValue(frame);
        m_timeline->setCurrentFrame(frame);
        showKeyButtons();
    });
    connect(&m_playback, &Playback::playingChanged, this, [this](bool playing) {
        m_play->setIcon(widgets::icon(playing ? "pause" : "play"));
        m_play->setAccessibleName(playing ? tr("Pause") : tr("Play"));
        m_measured->clear();
    });
    connect(&m_playback, &Playback::rateMeasured, this,
            [this](double rate) { m_measured->setText(tr("shown: %1 fps").arg(rate, 0, 'f', 1)); });
    connect(&m_document, &Document::changed, this, &TimelineDock::applyChange);
}

void TimelineDock::addTo(QMenu& menu) {
    menu.addAction(widgets::icon("play"), tr("&Play or Pause"), QKeySequence("Ctrl+Space"), this,
                   &TimelineDock::togglePlaying);
    menu.addAction(widgets::icon("key-camera"), tr("Key &Camera"), QKeySequence("K"), this,
                   &TimelineDock::keyCamera);
    menu.addAction(widgets::icon("key-light"), tr("Key &Light"), QKeySequence("Shift+K"), this,
                   &TimelineDock::keyLight);
}

void TimelineDock::applyChange(Change change) {
    if (change.kind == Change::Kind::Everything || change.kind == Change::Kind::Animation) showAnimation();
}

void TimelineDock::showAnimation() {
    const project::Animation& animation = m_document.project().animation;
    m_timeline->setFrames(animation.frames, animation.firstFrame, animation.lastFrame);
    m_timeline->setLanes({{tr("Camera"), animation.path.keyFrames(parts[0])},
                          {tr("Light"), animation.path.keyFrames(parts[1])}});
    m_frame->setMaximum(animation.frames);
    const auto show = [](QSpinBox* field, int value) {
        const QSignalBlocker quiet(field);
        field->setValue(value);
    };
    show(m_frames, animation.frames);
    show(m_rate, int(std::lround(animation.rate)));
    for (QSpinBox* field : {m_first, m_last}) {
        const QSignalBlocker quiet(field);
        field->setMaximum(animation.frames);
    }
    show(m_first, animation.firstFrame);
    show(m_last, animation.lastFrame);
    m_turntable->setChecked(animation.path.cameraTurn != 0);
    m_sweep->setChecked(animation.path.lightTurn != 0);
    m_interpolation->setCurrentIndex(animation.path.smooth ? 0 : 1);
    showKeyButtons();
}

void TimelineDock::showKeyButtons() {
    m_removeKey->setEnabled(m_timeline->selectedKey().has_value());
    m_previous->setEnabled(m_timeline->keyBefore().has_value());
    m_next->setEnabled(m_timeline->keyAfter().has_value());
}

template <class Edit>
void TimelineDock::edit(const QString& text, Edit edit) {
    project::Animation animation = m_document.project().animation;
    edit(animation);
    m_document.editAnimation(animation, text);
}

void TimelineDock::setCurrentFrame(int frame) {
    m_playback.setCurrentFrame(frame);
}

void TimelineDock::togglePlaying() {
    m_playback.setPlaying(!m_playback.isPlaying());
}

void TimelineDock::keyCamera() {
    m_document.finishEdit();
    edit(tr("Key Camera"), [this](project::Animation& animation) {
        animation.path.setKey(m_playback.currentFrame(), m_playback.cameraKey());
    });
    m_document.finishEdit();
}

void TimelineDock::keyLight() {
    if (m_document.project().lights.empty()) return;
    m_document.finishEdit();
    edit(tr("Key Light"), [this](project::Animation& animation) {
        animation.path.setKey(m_playback.currentFrame(), m_playback.lightKey());
    });
    m_document.finishEdit();
}

void TimelineDock::removeSelectedKey() {
    const auto key = m_timeline->selectedKey();
    if (!key) return;
    m_document.finishEdit();
    edit(tr("Remove Key"), [&](project::Animation& animation) {
        animation.path.removeKey(parts[std::size_t(key->lane)], key->frame);
    });
    m_document.finishEdit();
}

void TimelineDock::setTurn(double Path::*turn, bool on, const QString& text) {
    m_document.finishEdit();
    edit(text,
         [&](project::Animation& animation) { animation.path.*turn = on ? 360.0 / animation.frames : 0; });
    m_document.finishEdit();
}

}  // namespace chiaro::app
