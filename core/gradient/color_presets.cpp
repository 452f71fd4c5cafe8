#include "core/gradient/color_presets.h"

#include <vector>

// The word by which translators' tools know what is translated elsewhere.
#define QT_TRANSLATE_NOOP(context, text) text

namespace chiaro::gradient {

namespace {

ColorPreset preset(const char* name, const char* stops) {
    return {name, parseColorPath(stops, ColorPath::Space::Oklab)};
}

}  // namespace

std::span<const ColorPreset> colorPresets() {
    static const std::vector<ColorPreset> presets{
        preset(QT_TRANSLATE_NOOP("ColorPreset", "Ivory black"), "0 #14120f, 0.45 #6b655c, 1 #f4efe4"),
        preset(QT_TRANSLATE_NOOP("ColorPreset", "Sepia"), "0 #22130a, 0.4 #7a4a26, 0.75 #cfa775, 1 #f7ead2"),
        preset(QT_TRANSLATE_NOOP("ColorPreset", "Sanguine"),
               "0 #2c0c08, 0.4 #96321e, 0.75 #dd8a63, 1 #f8e3cf"),
        preset(QT_TRANSLATE_NOOP("ColorPreset", "Cyanotype"),
               "0 #061530, 0.45 #1c4f86, 0.8 #9dbfd3, 1 #f1f3ea"),
        preset(QT_TRANSLATE_NOOP("ColorPreset", "Indigo and gold"),
               "0 #15103a, 0.35 #55306d, 0.6 #c2564b, 0.82 #f0a63f, 1 #fdf0bd"),
        preset(QT_TRANSLATE_NOOP("ColorPreset", "Verdigris"),
               "0 #0d1d1f, 0.4 #1f6460, 0.75 #85b69a, 1 #f0f1d8"),
        preset(QT_TRANSLATE_NOOP("ColorPreset", "Ultramarine and flesh"),
               "0 #161b45, 0.35 #4b4a86, 0.65 #c98574, 0.85 #efc3a0, 1 #fff3e2"),
        preset(QT_TRANSLATE_NOOP("ColorPreset", "Night garden"),
               "0 #0b1026, 0.35 #17505a, 0.6 #5f9a5c, 0.82 #d9cf6a, 1 #fdf8d8"),
    };
    return presets;
}

}  // namespace chiaro::gradient
