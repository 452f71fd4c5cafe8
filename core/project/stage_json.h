#pragma once

#include "core/project/json_reader.h"
#include "core/project/project.h"

namespace chiaro::project {

// How a project file, or a preset, writes the settings of one stage. What reads throws Error naming the file,
// the place in it and what would be right.

gradient::ColorPath colorPathFromJson(const JsonReader& reader);
Json jsonFromColorPath(const gradient::ColorPath& path);

/// Placed views under this key: at most 64, none without a direction.
std::vector<PlacedView> placedViewsFromJson(const JsonReader& reader, const char* key);
Json jsonFromPlacedViews(const std::vector<PlacedView>& views);

/// What is not there stays as it is.
void readViewParams(const JsonReader& reader, views::ViewParams& params);
Json jsonFromViewParams(const views::ViewParams& params);

/// One object a stage: "levels", "view-aligned", "image-based" and "view-dependent". What is not there stays
/// as it is.
void readMethodParams(const JsonReader& reader, MethodParams& params);
Json jsonFromMethodParams(const MethodParams& params);

template <class Params>
Json jsonFromParams(const Params& params) {
    return Json::parse(parametersToJson(params).dump());
}

}  // namespace chiaro::project
