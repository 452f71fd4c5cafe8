#include "widgets/pane_label.h"

#include <QtWidgets>

namespace chiaro::widgets {

PaneLabel::PaneLabel(const QString& name, const std::vector<NamedMethod>& methods, QWidget* parent)
    : QFrame(parent), m_name(name) {
    m_button = new QToolButton;
    m_button->setAccessibleName(name);
    m_button->setAutoRaise(true);
    m_button->setFocusPolicy(Qt::TabFocus);
    m_button->setPopupMode(QToolButton::InstantPopup);
    m_button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_button->setToolTip(tr("Which method this is; choose another"));
    auto* menu = new QMenu(m_button);
    m_methods = new QActionGroup(this);
    for (const NamedMethod& method : methods) {
        QAction* action = m_methods->addAction(menu->addAction(method.label));
        action->setCheckable(true);
        action->setData(QString::fromStdString(method.key));
    }
    m_button->setMenu(menu);
    connect(m_methods, &QActionGroup::triggered, this,
            [this](const QAction* action) { Q_EMIT methodChosen(action->data().toString()); });
    m_label = new QLabel;
    m_label->setWordWrap(true);
    m_label->setToolTip(
        tr("What this picture's frame took, in milliseconds, and its errors: how little it resembles its "
           "strips, and how far its shades are from the light, each from 0 to 1"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 3, 8, 4);
    layout->setSpacing(0);
    layout->addWidget(m_button, 0, Qt::AlignLeft);
    layout->addWidget(m_label);
}

void PaneLabel::setMethod(const std::string& key, bool isActive) {
    for (QAction* action : m_methods->actions()) {
        const bool isShown = action->data().toString().toStdString() == key;
        action->setChecked(isShown);
        if (isShown) m_button->setText(action->text());
    }
    m_button->setAccessibleName(tr("%1: %2").arg(m_name, m_button->text()));
    if (property("active").toBool() == isActive) return;
    setProperty("active", isActive);
    style()->unpolish(this);
    style()->polish(this);
}

void PaneLabel::setFigures(const QStringList& figures) {
    m_figures = figures;
    m_label->setAccessibleName(m_figures.join(", "));
}

QString PaneLabel::text() const {
    return (QStringList{m_button->text()} + m_figures).join(" · ");
}

int PaneLabel::leastWidth() const {
    const QMargins margins = layout()->contentsMargins();
    return m_button->sizeHint().width() + margins.left() + margins.right() + 2 * frameWidth();
}

QSize PaneLabel::fit(int width) {
    const QMargins margins = layout()->contentsMargins();
    const int inner = width - margins.left() - margins.right() - 2 * frameWidth();
    m_label->setVisible(!m_figures.isEmpty());
    // On one line where there is room, else each on its own.
    const QString line = m_figures.join(" · ");
    const bool isOneLine = m_label->fontMetrics().horizontalAdvance(line) + 6 <= inner;
    m_label->setWordWrap(!isOneLine);
    m_label->setText(isOneLine ? line : m_figures.join("\n"));
    setMaximumWidth(std::max(width, 1));
    layout()->activate();
    const QSize size = sizeHint().boundedTo(QSize(width, std::numeric_limits<int>::max()));
    resize(size.width(),
           layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(size.width()) : size.height());
    return this->size();
}

}  // namespace chiaro::widgets
