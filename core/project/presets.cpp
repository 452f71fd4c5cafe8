#include "core/project/presets.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/project/render_method.h"
#include "core/project/stage_json.h"

#include <algorithm>
#include <array>

namespace chiaro::project {

namespace fs = std::filesystem;

namespace {

constexpr int formatVersion = 1;
constexpr std::uintmax_t largestFile = 1 << 20;
constexpr std::size_t mostListed = 500;
constexpr std::size_t longestName = 100;  // bytes
constexpr std::array kindKeys{"gradient", "method", "view-plan"};

/// The objects of a file that hold a method's parameters.
std::vector<std::string> stagesOf(const std::string& method) {
    std::vector<std::string> stages{method};
    if (method != "image-based") stages.emplace_back("levels");
    return stages;
}

Json jsonFrom(const gradient::ColorPath& path) {
    return jsonFromColorPath(path);
}

Json jsonFrom(const MethodPreset& preset) {
    const Json all = jsonFromMethodParams(preset.params);
    Json json{{"method", preset.method}};
    for (const std::string& stage : stagesOf(preset.method)) json[stage] = all.at(stage);
    return json;
}

Json jsonFrom(const ViewPlanPreset& plan) {
    Json json = jsonFromViewParams(plan.params);
    json["placed"] = jsonFromPlacedViews(plan.placed);
    return json;
}

MethodPreset methodPreset(const JsonReader& reader) {
    MethodPreset preset;
    preset.method = reader.text("method");
    if (!findRenderMethod(preset.method)) {
        std::vector<std::string> keys;
        for (const RenderMethod& method : renderMethods()) keys.push_back("\"" + method.key + "\"");
        throw reader.wrong("method", fmt::format("{}", fmt::join(keys, " or ")));
    }
    reader.at(preset.method.c_str());
    readMethodParams(reader, preset.params);
    return preset;
}

ViewPlanPreset viewPlan(const JsonReader& reader) {
    ViewPlanPreset plan;
    readViewParams(reader, plan.params);
    if (reader.has("placed")) plan.placed = placedViewsFromJson(reader, "placed");
    return plan;
}

bool isFit(unsigned char letter) {
    return letter >= ' ' && letter != 127 &&
           std::string_view("/\\:*?\"<>|").find(char(letter)) == std::string_view::npos;
}

}  // namespace

MethodPreset MethodPreset::of(const Project& project) {
    return {project.method, MethodParams::of(project)};
}

void MethodPreset::applyTo(MethodParams& others) const {
    if (method == "image-based") {
        others.imageBased = params.imageBased;
        others.coherence = params.coherence;
        return;
    }
    others.levels = params.levels;
    if (method == "view-aligned") others.viewAligned = params.viewAligned;
    if (method == "view-dependent") {
        others.viewDependent = params.viewDependent;
        others.views = params.views;
    }
}

Preset readPreset(const fs::path& file) {
    const Json json = readJson(file, largestFile, "choose a preset that Chiaro saved");
    const JsonReader reader(json, file.string());
    int version = 0;
    reader.at("chiaro-preset");
    reader.read("chiaro-preset", version, 1, 1 << 30);
    if (version > formatVersion)
        throw Error(file.string(), fmt::format("was written by a newer Chiaro (format {})", version),
                    fmt::format("this one reads format {}", formatVersion));
    const auto [gradient, method, plan] = kindKeys;
    if (reader.has(gradient)) return colorPathFromJson(reader.child(gradient));
    if (reader.has(method)) return methodPreset(reader.child(method));
    if (reader.has(plan)) return viewPlan(reader.child(plan));
    throw Error(file.string(), "says nothing that a preset holds",
                fmt::format("it would have one of \"{}\"", fmt::join(kindKeys, "\", \"")));
}

void writePreset(const fs::path& file, const Preset& preset) {
    Json json;
    json["chiaro-preset"] = formatVersion;
    json[kindKeys[preset.index()]] =
        std::visit([](const auto& content) { return jsonFrom(content); }, preset);
    writeFileAtomically(file, json.dump(2) + "\n");
}

fs::path presetFile(const fs::path& folder, const std::string& name) {
    const std::string subject = "preset name \"" + name.substr(0, longestName) + "\"";
    if (name.find_first_not_of(" .") == name.npos)
        throw Error(subject, "is empty", "name the preset, for example Warm evening");
    if (name.size() > longestName)
        throw Error(subject, "is too long", fmt::format("choose one of at most {} letters", longestName));
    if (!std::ranges::all_of(name, isFit) || name.front() == '.' || name.front() == ' ' || name.back() == ' ')
        throw Error(subject, "can't be the name of a file",
                    "leave out / \\ : * ? \" < > |, a dot at the beginning and spaces at the ends");
    return folder / (name + ".json");
}

std::vector<ListedPreset> listPresets(const fs::path& folder, PresetKind kind) {
    std::vector<ListedPreset> listed;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".json" && !name.starts_with('.') && listed.size() < mostListed)
            listed.push_back({name, entry.path(), {}, {}});
    }
    std::ranges::sort(listed, {}, &ListedPreset::name);
    for (ListedPreset& one : listed) {
        try {
            Preset preset = readPreset(one.file);
            if (preset.index() != std::size_t(kind))
                throw Error(one.file.string(), fmt::format("is a {} preset", kindKeys[preset.index()]),
                            "move it to the folder of its kind");
            one.preset = std::move(preset);
        } catch (const std::exception& problem) {
            one.problem = problem.what();
        }
    }
    return listed;
}

void renamePreset(const fs::path& file, const std::string& name) {
    const fs::path renamed = presetFile(file.parent_path(), name);
    if (renamed == file) return;
    std::error_code error;
    if (fs::exists(renamed, error))
        throw Error(renamed.string(), "is there already", "choose a name that no other preset has");
    fs::rename(file, renamed, error);
    if (error)
        throw Error(file.string(), "could not be renamed (" + error.message() + ")", "check its folder");
}

}  // namespace chiaro::project
