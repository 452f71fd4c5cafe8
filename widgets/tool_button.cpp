#include "widgets/tool_button.h"

#include "widgets/icon_engine.h"

#include <QtWidgets>

namespace chiaro::widgets {

QIcon icon(const char* name) {
    const QString path = QString(":/icons/%1.svg").arg(name);
    if (!QFile::exists(path)) return {};
    return themedIcon(path);
}

QToolButton* makeToolButton(const char* iconName, const QString& name, const QString& tooltip) {
    auto* button = new QToolButton;
    button->setIcon(icon(iconName));
    button->setObjectName(iconName);
    button->setAutoRaise(true);
    button->setAccessibleName(name);
    button->setToolTip(tooltip);
    return button;
}

}  // namespace chiaro::widgets
