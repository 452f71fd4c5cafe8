#include "app/theme.h"

#include "app/system_theme.h"
#include "app/theme_colors.h"
#include "widgets/icon_engine.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

struct ThemeName {
    Theme theme;
    const char* key;
    const char* label;
};

constexpr ThemeName themes[] = {
    {Theme::Dark, "dark", QT_TRANSLATE_NOOP("chiaro::app::ThemeSwitch", "&Dark")},
    {Theme::Light, "light", QT_TRANSLATE_NOOP("chiaro::app::ThemeSwitch", "&Light")},
    {Theme::System, "system", QT_TRANSLATE_NOOP("chiaro::app::ThemeSwitch", "As the &System")},
};

const char* const settingsKey = "theme";

}  // namespace

std::optional<Theme> themeOfName(const QString& name) {
    for (const ThemeName& one : themes)
        if (name == one.key) return one.theme;
    return std::nullopt;
}

Theme ThemeSwitch::remembered() {
    return themeOfName(QSettings().value(settingsKey).toString()).value_or(Theme::Dark);
}

ThemeSwitch::ThemeSwitch(Theme theme, QObject* parent)
    : QObject(parent), m_theme(theme), m_system(new SystemTheme(QApplication::palette(), this)) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QFont font = QApplication::font();
    font.setPointSizeF(9);
    QApplication::setFont(font);
    QApplication::setWindowIcon(QIcon(":/icons/chiaro.svg"));
    connect(m_system, &SystemTheme::changed, this, [this] {
        if (m_theme == Theme::System) show();
    });
    show();
}

bool ThemeSwitch::isDark() const {
    return m_theme == Theme::System ? m_system->isDark() : m_theme == Theme::Dark;
}

void ThemeSwitch::setTheme(Theme theme) {
    if (std::exchange(m_theme, theme) != theme) show();
}

void ThemeSwitch::show() {
    const bool dark = isDark();
    widgets::setIconColors({themeColor("icon", dark), themeColor("note", dark), themeColor("error", dark)});
    QApplication::setPalette(themePalette(dark));
    QFile sheet(":/studio.qss");
    if (sheet.open(QIODevice::ReadOnly)) qApp->setStyleSheet(inked(QString::fromUtf8(sheet.readAll()), dark));
}

void ThemeSwitch::addTo(QMenu& menu) {
    auto* group = new QActionGroup(&menu);
    for (const ThemeName& one : themes) {
        QAction* action = menu.addAction(tr(one.label));
        action->setCheckable(true);
        action->setChecked(one.theme == m_theme);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, one] {
            setTheme(one.theme);
            QSettings().setValue(settingsKey, one.key);
        });
    }
}

bool showsDarkTheme() {
    return QApplication::palette().color(QPalette::Window).lightnessF() < 0.5;
}

}  // namespace chiaro::app
