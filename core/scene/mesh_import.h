#pragma once

#include "core/base/helper/handler.h"
#include "core/base/helper/helper_pool.h"
#include "core/scene/mesh_io.h"

namespace chiaro::scene {

/// readModel in a helper. What the helper hands back is checked as a file would be. Throws what readModel
/// throws.
Model importModel(helper::HelperPool& helpers, const std::filesystem::path& path, const Task& task);

constexpr const char* modelRequest = "mesh";
/// Answers it, in the helper.
helper::Finding handleModelRequest(helper::PlainReader& request, const Task& task);

}  // namespace chiaro::scene
