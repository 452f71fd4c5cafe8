#pragma once

#include "core/project/json_reader.h"

#include <glm/glm.hpp>

namespace chiaro::project {

/// The shortest decimal that reads back as this float: 0.1, not 0.10000000149.
inline double tidy(float value) {
    return std::stod(fmt::format("{}", value));
}

template <int N>
Json jsonFromVector(const glm::vec<N, float>& vector) {
    Json json = Json::array();
    for (int i = 0; i < N; ++i) json.push_back(tidy(vector[i]));
    return json;
}

}  // namespace chiaro::project
