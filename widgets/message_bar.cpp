#include "widgets/message_bar.h"

#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::widgets {

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), m_icon(new QLabel), m_text(new QLabel) {
    setAttribute(Qt::WA_StyledBackground);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* close = makeToolButton("close", tr("Close message"), tr("Close this message"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    layout->setSpacing(10);
    layout->addWidget(m_icon);
    layout->addWidget(m_text, 1);
    layout->addWidget(close, 0, Qt::AlignTop);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    hide();
}

void MessageBar::showMessage(const QString& text, Kind kind) {
    m_text->setText(text);
    setProperty("error", kind == Kind::Error);
    showIcon();
    style()->unpolish(this);
    style()->polish(this);
    show();
}

void MessageBar::showIcon() {
    constexpr QSize size(18, 18);
    m_icon->setPixmap(icon(property("error").toBool() ? "error" : "note").pixmap(size, devicePixelRatioF()));
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) showIcon();
    QWidget::changeEvent(event);
}

QString MessageBar::text() const {
    return m_text->text();
}

}  // namespace chiaro::widgets
