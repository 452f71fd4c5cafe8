#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::widgets {

QToolButton* makeToolButton(const char* icon, const QString& name, const QString& tooltip) {
    auto* button = new QToolButton;
    button->setIcon(QIcon(QString(":/icons/%1.svg").arg(icon)));
    button->setObjectName(icon);
    button->setAutoRaise(true);
    button->setAccessibleName(name);
    button->setToolTip(tooltip);
    return button;
}

}  // namespace chiaro::widgets
