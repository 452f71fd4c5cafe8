#include "app/theme.h"

#include "app/main_window.h"
#include "app/theme_colors.h"
#include "widgets/tool_button.h"
#include "widgets/viewport/viewport.h"

#include <QtTest>
#include <QtWidgets>

#include <cmath>

using namespace chiaro;
using app::Theme;

namespace {

QString sheet() {
    QFile file(":/studio.qss");
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// WCAG's contrast of two colours, 1 to 21.
double contrast(const QColor& first, const QColor& second) {
    const auto luminance = [](const QColor& color) {
        const auto linear = [](double c) {
            return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
               0.0722 * linear(color.blueF());
    };
    const double a = luminance(first), b = luminance(second);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

/// The mean colour of what an icon draws.
QColor ink(const QIcon& icon) {
    const QImage image = icon.pixmap(QSize(32, 32), 2.0).toImage();
    double red = 0, green = 0, blue = 0, weight = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor color = image.pixelColor(x, y);
            red += color.redF() * color.alphaF();
            green += color.greenF() * color.alphaF();
            blue += color.blueF() * color.alphaF();
            weight += color.alphaF();
        }
    return weight > 0 ? QColor::fromRgbF(float(red / weight), float(green / weight), float(blue / weight))
                      : QColor();
}

}  // namespace

class ThemeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        Q_INIT_RESOURCE(resources);
    }
    void init() { QSettings().clear(); }

    void theStyleSheetNamesEveryColourThatThereIs() {
        QVERIFY(!sheet().isEmpty());
        for (const bool isDark : {true, false}) QVERIFY(!app::inked(sheet(), isDark).contains('@'));
        QVERIFY2(!sheet().contains(QRegularExpression("#[0-9a-fA-F]{6}\\b")),
                 "a colour stands in the style sheet itself");
        QVERIFY_THROWS_EXCEPTION(std::out_of_range, app::inked("color: @no-such-colour;", true));
    }

    void textIsReadableInBothThemes() {
        for (const bool isDark : {true, false}) {
            const QPalette palette = app::themePalette(isDark);
            for (const QPalette::ColorRole ground :
                 {QPalette::Window, QPalette::Base, QPalette::AlternateBase}) {
                QVERIFY(contrast(palette.color(QPalette::Text), palette.color(ground)) >= 7);
                QVERIFY(contrast(palette.color(QPalette::PlaceholderText), palette.color(ground)) >= 4.5);
            }
            QVERIFY(contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)) >=
                    4.5);
            const auto pair = [&](const char* text, const char* ground) {
                return contrast(app::themeColor(text, isDark), app::themeColor(ground, isDark));
            };
            QVERIFY(pair("text-dim", "bar") >= 4.5);
            QVERIFY(pair("text-strong", "title") >= 7);
            QVERIFY(pair("error", "base") >= 4.5);
            QVERIFY(pair("icon", "window") >= 4.5);
        }
    }

    void everyIconCanBeSeenInBothThemes() {
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            const app::ThemeSwitch shown(theme);
            const QColor window = QApplication::palette().color(QPalette::Window);
            for (const QString& file : QDir(":/icons").entryList({"*.svg"})) {
                // The program's own, and what lies on the accent or is told by shape alone.
                if (file == "chiaro.svg" || file == "check.svg" || file == "eye-off.svg") continue;
                const QIcon icon = file.startsWith("arrow-")
                                       ? QIcon(":/icons/" + file)
                                       : widgets::icon(file.chopped(4).toUtf8().constData());
                QVERIFY2(contrast(ink(icon), window) >= 2.9, qPrintable(file));
            }
        }
    }

    void aSwitchChangesTheWindowAtOnceAndIsRemembered() {
        app::ThemeSwitch theme(Theme::Dark);
        app::MainWindow window;
        window.addAppearance(theme);
        window.show();
        QVERIFY(window.viewport().background().x < 0.3F);
        QAction* light = nullptr;
        for (QAction* action : window.findChildren<QAction*>())
            if (action->text() == "&Light" && action->isCheckable()) light = action;
        QVERIFY(light);
        light->trigger();
        QVERIFY(!theme.isDark());
        QVERIFY(window.palette().color(QPalette::Window).lightnessF() > 0.8F);
        QTRY_VERIFY(window.viewport().background().x > 0.6F);
        QCOMPARE(app::ThemeSwitch::remembered(), Theme::Light);
    }
};

QTEST_MAIN(ThemeTest)
#include "theme_test.moc"
