#include "core/project/stage_json.h"

#include "core/project/json_writer.h"

#include <algorithm>

namespace chiaro::project {

namespace {

constexpr std::size_t mostPlacedViews = 64;

}  // namespace

gradient::ColorPath colorPathFromJson(const JsonReader& reader) {
    gradient::ColorPath path;
    const std::string space = reader.has("space") ? reader.text("space") : "rgb";
    if (space != "rgb" && space != "oklab") throw reader.wrong("space", "\"rgb\" or \"oklab\"");
    path.space = space == "oklab" ? gradient::ColorPath::Space::Oklab : gradient::ColorPath::Space::Rgb;
    for (const JsonReader& stop : reader.children("stops")) {
        gradient::ColorStop& added = path.stops.emplace_back();
        stop.read("position", added.position, 0, 1);
        stop.read("color", added.color);
        added.color = glm::clamp(added.color, 0.0f, 1.0f);
    }
    if (path.stops.empty()) throw reader.wrong("stops", "at least one stop");
    std::stable_sort(path.stops.begin(), path.stops.end(),
                     [](const auto& a, const auto& b) { return a.position < b.position; });
    return path;
}

Json jsonFromColorPath(const gradient::ColorPath& path) {
    Json json;
    json["space"] = path.space == gradient::ColorPath::Space::Oklab ? "oklab" : "rgb";
    for (const gradient::ColorStop& stop : path.stops)
        json["stops"].push_back({{"position", tidy(stop.position)}, {"color", jsonFromVector(stop.color)}});
    return json;
}

std::vector<PlacedView> placedViewsFromJson(const JsonReader& reader, const char* key) {
    std::vector<PlacedView> views;
    for (const JsonReader& child : reader.children(key)) {
        PlacedView& view = views.emplace_back();
        child.read("direction", view.direction);
        child.read("up", view.up);
        if (glm::length(view.direction) == 0) throw child.wrong("direction", "a direction that is not zero");
    }
    if (views.size() > mostPlacedViews)
        throw reader.wrong(key, fmt::format("at most {} views", mostPlacedViews));
    return views;
}

Json jsonFromPlacedViews(const std::vector<PlacedView>& views) {
    Json json = Json::array();
    for (const PlacedView& view : views)
        json.push_back({{"direction", jsonFromVector(view.direction)}, {"up", jsonFromVector(view.up)}});
    return json;
}

void readViewParams(const JsonReader& reader, views::ViewParams& params) {
    reader.params(params);
    glm::vec3 up(params.up);
    reader.read("up", up);
    if (glm::length(up) == 0) throw reader.wrong("up", "a direction that is not zero");
    params.up = glm::dvec3(up);
}

Json jsonFromViewParams(const views::ViewParams& params) {
    Json json = jsonFromParams(params);
    json["up"] = jsonFromVector(glm::vec3(params.up));
    return json;
}

void readMethodParams(const JsonReader& reader, MethodParams& params) {
    if (reader.has("levels")) {
        reader.child("levels").params(params.levels);
        reader.child("levels").params(params.levels.quilt);
    }
    if (reader.has("view-aligned")) reader.child("view-aligned").params(params.viewAligned);
    if (reader.has("image-based")) {
        reader.child("image-based").params(params.imageBased);
        reader.child("image-based").params(params.imageBased.quilt);
        reader.child("image-based").params(params.coherence);
    }
    if (reader.has("view-dependent")) {
        reader.child("view-dependent").params(params.viewDependent);
        readViewParams(reader.child("view-dependent"), params.views);
    }
}

Json jsonFromMethodParams(const MethodParams& params) {
    Json json;
    json["levels"] = jsonFromParams(params.levels);
    json["levels"].update(jsonFromParams(params.levels.quilt));
    json["view-aligned"] = jsonFromParams(params.viewAligned);
    json["image-based"] = jsonFromParams(params.imageBased);
    json["image-based"].update(jsonFromParams(params.imageBased.quilt));
    json["image-based"].update(jsonFromParams(params.coherence));
    json["view-dependent"] = jsonFromParams(params.viewDependent);
    json["view-dependent"].update(jsonFromViewParams(params.views));
    return json;
}

}  // namespace chiaro::project
