#pragma once

#include "core/base/parameters.h"

namespace chiaro::scene {

/// What surfaces keep from each other of the light. Off by default: then L is the light of §4 alone.
struct OcclusionParams {
    bool shadows = false;       ///< surfaces cast shadows
    double ambient = 0;         ///< ambient occlusion: the share of L that a closed corner loses, 0..1
    double ambientRadius = 25;  ///< how far that looks around, percent of the scene's radius, 1..200
    friend bool operator==(const OcclusionParams&, const OcclusionParams&) = default;

    bool isOff() const { return !shadows && ambient == 0; }
    static const ParameterTable<OcclusionParams>& table();
};

}  // namespace chiaro::scene
