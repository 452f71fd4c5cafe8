#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::widgets {

namespace {

/// What can't be pressed steps back.
QPixmap dimmed(const QPixmap& pixmap) {
    QPixmap result(pixmap.size());
    result.fill(Qt::transparent);
    QPainter painter(&result);
    painter.setOpacity(0.3);
    painter.drawPixmap(0, 0, pixmap);
    return result;
}

}  // namespace

QIcon icon(const char* name) {
    const QString path = QString(":/icons/%1.svg").arg(name);
    if (!QFile::exists(path)) return {};
    const QIcon drawing(path);
    QIcon icon;
    for (int size : {16, 20, 24, 32, 48, 64}) {
        const QPixmap pixmap = drawing.pixmap(QSize(size, size), 1.0);
        icon.addPixmap(pixmap);
        icon.addPixmap(dimmed(pixmap), QIcon::Disabled);
    }
    return icon;
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
