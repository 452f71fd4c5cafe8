#pragma once

#include <QObject>

#include <optional>

class QMenu;

namespace chiaro::app {

class SystemTheme;

enum class Theme { Dark, Light, System };

/// The theme of that name ("dark", "light" or "system").
std::optional<Theme> themeOfName(const QString& name);

/// The studio's look. One for a program: it styles the application, live, and everything in it follows.
class ThemeSwitch : public QObject {
    Q_OBJECT

public:
    /// Takes the application's font and style, and shows `theme`; nothing is remembered until the artist chooses.
    explicit ThemeSwitch(Theme theme, QObject* parent = nullptr);

    /// What the artist chose last, dark at first.
    static Theme remembered();

    /// Dark, Light and As the System, to choose and to remember.
    void addTo(QMenu& menu);
    void setTheme(Theme theme);
    Theme theme() const { return m_theme; }
    bool isDark() const;

private:
    void show();

    Theme m_theme;
    SystemTheme* m_system;
};

/// Whether what is shown now is the dark theme: of the application's palette.
bool showsDarkTheme();

}  // namespace chiaro::app
