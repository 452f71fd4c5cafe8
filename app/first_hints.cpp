#include "app/first_hints.h"

#include "widgets/tool_button.h"

#include <QtWidgets>

#include <array>

namespace chiaro::app {

namespace {

const char* const settingsKey = "hints/seen";
constexpr int textWidth = 320;  // px
constexpr int margin = 24;      // px, from the lower edge of the viewport

constexpr std::array hints{
    QT_TRANSLATE_NOOP(
        "chiaro::app::FirstHints",
        "<b>Look around.</b> Drag beside the skull to turn it, use the wheel to come nearer. Shift with the "
        "right button turns the light."),
    QT_TRANSLATE_NOOP(
        "chiaro::app::FirstHints",
        "<b>Bring your own.</b> Drop a scan of paint, dark at the left and light at the right, and a mesh on "
        "this window."),
    QT_TRANSLATE_NOOP(
        "chiaro::app::FirstHints",
        "<b>Choose how the paint is laid on</b> with the keys 1, 2 and 3, and recolour it in <i>Gradient "
        "Curve</i>. F1 tells about the dock you are in."),
};

}  // namespace

bool FirstHints::wereSeen() {
    return QSettings().value(settingsKey).toBool();
}

FirstHints::FirstHints(QWidget& viewport)
    : QFrame(&viewport), m_text(new QLabel), m_number(new QLabel), m_next(new QPushButton) {
    setObjectName("first-hints");
    setAccessibleName(tr("Hints for the first start"));
    m_text->setObjectName("hint");
    m_text->setWordWrap(true);
    m_text->setFixedWidth(textWidth);
    m_number->setProperty("note", true);
    auto* close = widgets::makeToolButton("close", tr("Close hints"), tr("Close the hints (Esc)"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(14, 12, 10, 12);
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(8);
    grid->addWidget(m_text, 0, 0, 1, 2);
    grid->addWidget(close, 0, 2, Qt::AlignTop);
    grid->addWidget(m_number, 1, 0);
    grid->addWidget(m_next, 1, 1, Qt::AlignRight);
    connect(close, &QToolButton::clicked, this, &FirstHints::finish);
    connect(m_next, &QPushButton::clicked, this, [this] {
        if (m_hint + 1 == int(hints.size())) return finish();
        showHint(m_hint + 1);
    });
    viewport.installEventFilter(this);
    showHint(0);
    QWidget::show();
}

void FirstHints::showHint(int hint) {
    m_hint = hint;
    m_text->setText(tr(hints[std::size_t(hint)]));
    m_number->setText(tr("%1 of %2").arg(hint + 1).arg(hints.size()));
    m_next->setText(hint + 1 == int(hints.size()) ? tr("Got It") : tr("Next"));
    place();
}

void FirstHints::place() {
    m_text->setFixedHeight(m_text->heightForWidth(textWidth));
    layout()->activate();
    resize(sizeHint());
    move((parentWidget()->width() - width()) / 2, parentWidget()->height() - height() - margin);
    raise();
}

void FirstHints::finish() {
    QSettings().setValue(settingsKey, true);
    deleteLater();
}

bool FirstHints::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QFrame::eventFilter(watched, event);
}

void FirstHints::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) return finish();
    QFrame::keyPressEvent(event);
}

}  // namespace chiaro::app
