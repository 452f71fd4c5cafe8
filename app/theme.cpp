#include "app/theme.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

const QColor accent(0xd8, 0x9b, 0x4a);

QPalette darkPalette() {
    const QColor window(0x2e, 0x2e, 0x2e);
    const QColor base(0x20, 0x20, 0x20);
    const QColor button(0x3d, 0x3d, 0x3d);
    const QColor text(0xd8, 0xd8, 0xd8);
    const QColor dim(0x98, 0x98, 0x98);
    const QColor disabled(0x6c, 0x6c, 0x6c);

    QPalette palette(button, window);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, QColor(0x26, 0x26, 0x26));
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::PlaceholderText, dim);
    palette.setColor(QPalette::Highlight, accent);
    palette.setColor(QPalette::HighlightedText, QColor(0x18, 0x18, 0x18));
    palette.setColor(QPalette::Link, accent);
    palette.setColor(QPalette::ToolTipBase, QColor(0x18, 0x18, 0x18));
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::Light, QColor(0x4c, 0x4c, 0x4c));
    palette.setColor(QPalette::Mid, QColor(0x28, 0x28, 0x28));
    palette.setColor(QPalette::Dark, QColor(0x1c, 0x1c, 0x1c));
    for (QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, disabled);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(0x55, 0x55, 0x55));
    return palette;
}

}  // namespace

void applyTheme(QApplication& application) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(darkPalette());
    QFont font = QApplication::font();
    font.setPointSizeF(9);
    QApplication::setFont(font);
    QFile sheet(":/studio.qss");
    if (sheet.open(QIODevice::ReadOnly)) application.setStyleSheet(QString::fromUtf8(sheet.readAll()));
    application.setWindowIcon(QIcon(":/icons/chiaro.svg"));
}

}  // namespace chiaro::app
