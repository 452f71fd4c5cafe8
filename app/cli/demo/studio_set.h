#pragma once

#include "core/project/pipeline.h"

#include <map>

namespace chiaro::cli::demo {

/// The built-in meshes and samples, each sample's paint made once for all the meshes.
class StudioSet {
public:
    /// Throws Error when the files are missing.
    explicit StudioSet(std::uint64_t seed);

    const std::vector<std::filesystem::path>& meshes() const { return m_meshes; }
    const std::vector<std::filesystem::path>& samples() const { return m_samples; }

    /// With its levels. Throws Error, Cancelled.
    const project::Paint& paint(const std::filesystem::path& sample, const Task& task = {});
    /// The mesh in that paint, seen as a project without a camera of its own shows it. Throws Error,
    /// Cancelled.
    ColorAlphaImage painted(const std::filesystem::path& mesh, const std::filesystem::path& sample, int side,
                            const Task& task = {});

private:
    struct View {
        project::Project project;
        scene::Scene scene;
        scene::GBuffer gbuffer;
    };
    const View& view(const std::filesystem::path& mesh, int side);

    std::uint64_t m_seed;
    std::vector<std::filesystem::path> m_meshes, m_samples;
    std::map<std::filesystem::path, project::Paint> m_paints;
    std::map<std::filesystem::path, View> m_views;
};

}  // namespace chiaro::cli::demo
