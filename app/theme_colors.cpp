#include "app/theme_colors.h"

#include <QtGui>

#include <algorithm>
#include <stdexcept>

namespace chiaro::app {

namespace {

constexpr ThemeColor colors[] = {
    // name               dark      light
    // What lies behind.
    {"window", 0x2e2e2e, 0xe6e6e6},
    {"bar", 0x262626, 0xdadada},
    {"title", 0x383838, 0xcccccc},
    {"gap", 0x1c1c1c, 0xb4b4b4},
    {"base", 0x202020, 0xf8f8f8},
    {"base-alternate", 0x262626, 0xefefef},
    {"base-disabled", 0x292929, 0xe9e9e9},
    {"viewport", 0x2a2a2a, 0xc2c2c2},
    {"tooltip", 0x181818, 0xfcfcfc},
    // Edges and lines.
    {"outline", 0x141414, 0xa2a2a2},
    {"field-edge", 0x171717, 0xb0b0b0},
    {"line", 0x3a3a3a, 0xc4c4c4},
    {"tooltip-edge", 0x454545, 0xa2a2a2},
    // Text.
    {"text", 0xd8d8d8, 0x202020},
    {"text-strong", 0xe8e8e8, 0x101010},
    {"text-title", 0xc4c4c4, 0x303030},
    {"text-dim", 0x9c9c9c, 0x5c5c5c},
    {"text-disabled", 0x6c6c6c, 0x9a9a9a},
    // What is pressed, pointed at or chosen.
    {"accent", 0xd89b4a, 0xc8822a},
    {"accent-dim", 0xa87a3c, 0xd3a267},
    {"on-accent", 0x181818, 0x181818},
    {"focus", 0x8a6a3c, 0xb8741f},
    {"hover", 0x474747, 0xd0d0d0},
    {"selected", 0x4a4a4a, 0xc9c9c9},
    {"selected-idle", 0x555555, 0xc0c0c0},
    {"button", 0x4a4a4a, 0xf4f4f4},
    {"button-hover", 0x565656, 0xffffff},
    {"button-pressed", 0x333333, 0xd2d2d2},
    {"button-disabled", 0x353535, 0xe0e0e0},
    {"tool-pressed", 0x1f1f1f, 0xf6f6f6},
    {"groove", 0x1a1a1a, 0xbababa},
    {"groove-disabled", 0x444444, 0xc8c8c8},
    {"handle", 0xcfcfcf, 0x5a5a5a},
    {"handle-hover", 0xf0c27c, 0xb8741f},
    {"handle-disabled", 0x5c5c5c, 0xb0b0b0},
    {"scroll", 0x4c4c4c, 0xb0b0b0},
    // What the palette has and no rule of the style sheet names.
    {"palette-button", 0x3d3d3d, 0xdedede},
    {"palette-light", 0x4c4c4c, 0xffffff},
    {"palette-mid", 0x282828, 0xbebebe},
    {"palette-dark", 0x1c1c1c, 0x8c8c8c},
    // Over the picture: dark in both themes, since it lies on paint.
    {"overlay-edge", 0x4c4c4c, 0x4c4c4c},
    {"overlay-dim", 0xb4b4b4, 0xb4b4b4},
    {"overlay-text", 0xf0f0f0, 0xf0f0f0},
    // Messages, and the inks of icons.
    {"note-ground", 0x3a3326, 0xfaeccf},
    {"note-edge", 0x6b5530, 0xd6b273},
    {"error-ground", 0x43291f, 0xf8dcd2},
    {"error-edge", 0x8a4a33, 0xd08a74},
    {"icon", 0xd4d4d4, 0x3a3a3a},
    {"note", 0xd8b27a, 0x8a5a10},
    {"error", 0xf0a08c, 0xb03a20},
};

}  // namespace

std::span<const ThemeColor> themeColors() {
    return colors;
}

QColor themeColor(const char* name, bool isDark) {
    const auto* found =
        std::ranges::find_if(colors, [&](const ThemeColor& color) { return qstrcmp(color.name, name) == 0; });
    if (found == std::end(colors)) throw std::out_of_range(std::string("no colour is called ") + name);
    return QColor(isDark ? found->dark : found->light);
}

QPalette themePalette(bool isDark) {
    const auto color = [&](const char* name) { return themeColor(name, isDark); };
    QPalette palette(color("palette-button"), color("window"));
    const std::pair<QPalette::ColorRole, const char*> roles[] = {
        {QPalette::Base, "base"},
        {QPalette::AlternateBase, "base-alternate"},
        {QPalette::WindowText, "text"},
        {QPalette::Text, "text"},
        {QPalette::ButtonText, "text"},
        {QPalette::BrightText, "text-strong"},
        {QPalette::PlaceholderText, "text-dim"},
        {QPalette::Highlight, "accent"},
        {QPalette::HighlightedText, "on-accent"},
        {QPalette::Link, isDark ? "accent" : "focus"},
        {QPalette::LinkVisited, isDark ? "accent-dim" : "focus"},
        {QPalette::ToolTipBase, "tooltip"},
        {QPalette::ToolTipText, "text"},
        {QPalette::Light, "palette-light"},
        {QPalette::Midlight, "palette-button"},
        {QPalette::Mid, "palette-mid"},
        {QPalette::Dark, "palette-dark"},
        {QPalette::Shadow, "outline"},
    };
    for (const auto& [role, name] : roles) palette.setColor(role, color(name));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, color("text-disabled"));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, color("selected-idle"));
    return palette;
}

QString inked(const QString& sheet, bool isDark) {
    static const QRegularExpression name("@([a-z-]+)");
    QString result;
    qsizetype done = 0;
    for (auto match = name.globalMatch(sheet); match.hasNext();) {
        const QRegularExpressionMatch found = match.next();
        result += sheet.mid(done, found.capturedStart() - done);
        result += themeColor(found.captured(1).toLatin1().constData(), isDark).name();
        done = found.capturedEnd();
    }
    return result + sheet.mid(done);
}

}  // namespace chiaro::app
