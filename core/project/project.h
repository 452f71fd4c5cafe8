#pragma once

#include "core/gradient/gradient.h"
#include "core/methods/coherence.h"
#include "core/methods/image_based.h"
#include "core/methods/view_aligned.h"
#include "core/methods/view_dependent.h"
#include "core/sample/strip.h"
#include "core/scene/path.h"
#include "core/scene/placement.h"
#include "core/scene/scene.h"
#include "core/synthesis/levels.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace chiaro::project {

/// A paint sample of a project: where its scan is and what the artist made of it.
struct Sample {
    std::string name;
    std::filesystem::path scan;  ///< absolute once loaded
    sample::StripParams strip;
    gradient::GradientParams gradient;
    std::optional<gradient::ColorPath> recoloring;  ///< replaces the sample's own gradient when set
    friend bool operator==(const Sample&, const Sample&) = default;
};

/// A viewpoint that the artist placed on an object; planning keeps it (§4.3.1).
struct PlacedView {
    glm::vec3 direction{0, 0, 1};  ///< from the object towards the eye, object space, any length but zero
    glm::vec3 up{0, 1, 0};         ///< upwards in its map
    friend bool operator==(const PlacedView&, const PlacedView&) = default;
};

/// One object of the scene: an object of one of the project's mesh files. Several may be of the same, each
/// with a place and paint of its own.
struct ObjectSettings {
    std::string name;         ///< for the artist; no two objects of a project have the same
    std::string source = {};  ///< its name in the mesh file; empty: the same as `name`
    int mesh = 0;             ///< index into Project::meshes
    int sample = 0;           ///< index into Project::samples
    bool visible = true;
    scene::Placement placement = {};
    glm::mat4 transform{1};              ///< before the placement; of projects that other programs wrote
    std::vector<PlacedView> views = {};  ///< placed by the artist
    friend bool operator==(const ObjectSettings&, const ObjectSettings&) = default;

    const std::string& sourceName() const { return source.empty() ? name : source; }
};

/// A mesh file, and those of its objects that the artist took out of the scene.
struct MeshFile {
    std::filesystem::path path;             ///< absolute once loaded
    std::vector<std::string> without = {};  ///< names in the file
    friend bool operator==(const MeshFile&, const MeshFile&) = default;
};

/// What moves over a project's frames.
struct Animation {
    int frames = 48;        ///< 1..100000
    int firstFrame = 1;     ///< of those that are rendered, 1..frames
    int lastFrame = 48;     ///< from firstFrame to frames
    double rate = 24;       ///< frames a second, 1..240
    scene::Path path = {};  ///< nothing moves without keys and turns
    friend bool operator==(const Animation&, const Animation&) = default;
};

/// What a .chiaro file holds: plain values. Derived data (strips, levels, meshes) is never in it.
struct Project {
    static constexpr int version = 2;  ///< 1 had a single mesh file
    std::vector<Sample> samples;
    std::vector<MeshFile> meshes;
    std::vector<ObjectSettings> objects;  ///< objects of the files that are not named here wear sample 0
    std::vector<scene::Light> lights{scene::Light{}};
    scene::OcclusionParams occlusion;
    Animation animation;
    bool frameCamera = true;  ///< aim the camera at the whole scene when it is opened; its target and radius
                              ///< are then not saved
    scene::Camera camera;
    std::string method = "view-aligned";  ///< key of a RenderMethod
    synthesis::LevelParams levels;
    methods::ViewAlignedParams viewAligned;
    methods::ImageBasedParams imageBased;
    views::ViewParams views;  ///< of every object
    methods::ViewDependentParams viewDependent;
    methods::CoherenceParams coherence;  ///< of image-based animations
    friend bool operator==(const Project&, const Project&) = default;
};

/// How a project's methods lay paint on: the parameters of every stage after the gradient.
struct MethodParams {
    synthesis::LevelParams levels;
    methods::ViewAlignedParams viewAligned;
    methods::ImageBasedParams imageBased;
    methods::CoherenceParams coherence;
    methods::ViewDependentParams viewDependent;
    views::ViewParams views;
    friend bool operator==(const MethodParams&, const MethodParams&) = default;

    static MethodParams of(const Project& project);
    void applyTo(Project& project) const;
};

/// A project, and the format of the file that it was read from.
struct ProjectFile {
    Project project;
    int version = Project::version;
    /// The file may say more than the project holds: to write the project over it would lose that.
    bool isNewer() const { return version > Project::version; }
};
/// As readProject(), but of a newer format it reads what this program knows.
ProjectFile readProjectFile(const std::filesystem::path& path);
/// Throws Error when a project of a newer format is there.
void refuseToReplaceNewer(const std::filesystem::path& path);

/// Reads a project; its relative paths are resolved against its folder. Throws Error naming the file and what
/// in it is wrong, and when its format is newer than this program's.
Project readProject(const std::filesystem::path& path);
/// What a project file says: paths relative to the file's folder, keys in a fixed order.
std::string projectText(const std::filesystem::path& path, const Project& project);
/// Writes it atomically. Throws Error; the old file
/// is then intact.
void writeProject(const std::filesystem::path& path, const Project& project);

}  // namespace chiaro::project
