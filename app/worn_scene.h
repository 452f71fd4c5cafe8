#pragma once

#include "app/picture_export.h"
#include "core/project/pipeline.h"

namespace chiaro::app {

/// True when an object that is shown wears the sample.
bool isWorn(const scene::Scene& scene, int sample);

/// What the objects of a source wear, as core's methods take it. What the studio has made already is used,
/// the rest is made now; objects without a sample are grey, as the viewport shows them.
class WornScene {
public:
    /// Throws Error, Cancelled.
    WornScene(const PictureSource& source, const Task& task);
    WornScene(const WornScene&) = delete;
    WornScene& operator=(const WornScene&) = delete;

    /// [k - 1] of object k; belongs to this.
    const project::WornPaints& worn() const { return m_worn; }

private:
    void wearTextures(const PictureSource& source, const Task& task);
    void wearPaints(const PictureSource& source, const Task& task);

    project::Paint m_bare;
    std::vector<project::Paint> m_paints;  ///< one a sample
    project::WornPaints m_worn;
};

}  // namespace chiaro::app
