#pragma once

#include "core/project/project.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace chiaro::project {

/// The parameters of one method. Of the others it says nothing.
struct MethodPreset {
    std::string method;  ///< key of a RenderMethod
    MethodParams params;
    friend bool operator==(const MethodPreset&, const MethodPreset&) = default;

    /// Those of the method that the project shows.
    static MethodPreset of(const Project& project);
    /// Over the project's own; what the method doesn't use stays.
    void applyTo(MethodParams& others) const;
};

/// How an object's views are planned, and those that the artist placed (§4.3.1).
struct ViewPlanPreset {
    views::ViewParams params;
    std::vector<PlacedView> placed;
    friend bool operator==(const ViewPlanPreset&, const ViewPlanPreset&) = default;
};

/// What an artist keeps of one project for others: the colours of a sample, how a method paints, where views
/// are.
using Preset = std::variant<gradient::ColorPath, MethodPreset, ViewPlanPreset>;
/// In the order of the variant.
enum class PresetKind { Gradient, Method, ViewPlan };

/// One file a preset, NAME.json, so that artists share them by copying. Throws Error naming the file and what
/// in it is wrong.
Preset readPreset(const std::filesystem::path& file);
/// Writes atomically. Throws Error.
void writePreset(const std::filesystem::path& file, const Preset& preset);

/// The file of a preset of this name in a folder. Throws Error when it can't be the name of a file, on
/// whichever system it is shared with.
std::filesystem::path presetFile(const std::filesystem::path& folder, const std::string& name);

/// A preset file, read or found unfit.
struct ListedPreset {
    std::string name;
    std::filesystem::path file;
    std::optional<Preset> preset;
    std::string problem;  ///< a sentence when there is no preset
};
/// The presets of a kind that a folder holds, by name; none when it isn't there. At most 500 are read.
std::vector<ListedPreset> listPresets(const std::filesystem::path& folder, PresetKind kind);

/// Throws Error, the file then as it was, when another has that name or it can't be one.
void renamePreset(const std::filesystem::path& file, const std::string& name);

}  // namespace chiaro::project
