#pragma once

#include "core/base/image_io.h"
#include "core/export/bake.h"
#include "core/export/surface_light.h"

#include <filesystem>
#include <string>

namespace chiaro::exporting {

/// What a mesh file is.
enum class MeshFormat { Glb, Obj, Ply };

/// The format that the extension asks for. Throws Error when meshes are not written with such a one.
MeshFormat meshFormat(const std::filesystem::path& path);

/// The files that make up a mesh file: itself, and of an OBJ its material and its picture beside it.
std::vector<std::filesystem::path> filesOf(const std::filesystem::path& path);

/// Throws Error when a mesh can't be written there: another extension, a folder that can't be written to, or,
/// unless it may be replaced, a file that is there already. To be asked before the work begins.
void checkMeshOutput(const std::filesystem::path& path, bool mayReplace);

/// An object as a file holds it. Faces keep their order and their corners theirs.
struct TexturedObject {
    std::string name;
    glm::mat4 transform{1};  ///< object to world
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> coordinates;  ///< in the texture, in [0, 1], y down; empty without one
    std::vector<glm::u8vec3> colors;     ///< of each vertex, display-referred; empty with a texture
    std::vector<scene::Triangle> triangles;
    /// To be shown from behind too. Not where backs are modelled as faces of their own in the same place: a
    /// viewer couldn't tell which of the two lies in front.
    bool isDoubleSided = true;
};

/// Painted objects, ready to be written.
struct TexturedScene {
    std::vector<TexturedObject> objects;
    ByteImage texture;  ///< display-referred; empty when vertices hold the colours
    Bake bake = Bake::Lit;
};

/// Whether a good part of a mesh's faces have another one in the same place that looks the other way.
bool hasModelledBacks(const scene::Mesh& mesh);

/// The object with its vertices split where charts meet.
TexturedObject withCoordinates(const scene::Object& object, const AtlasFaces& faces, int atlasSize);

/// Writes the files of a mesh, all or none:
/// - .glb holds everything in one file: a node an object with its name and place, one picture, a material
///   without metal or gloss. With the scene's light baked in it asks to be shown as it
///   is (KHR_materials_unlit, which a viewer may not know);
/// - .obj with .mtl and .png beside it, objects at their places in the world;
/// - .ply holds all objects as one, a colour a vertex.
/// Textures need coordinates, PLY needs colors. The same scene gives the same bytes. Throws Error.
void writeTexturedScene(const std::filesystem::path& path, const TexturedScene& scene,
                        const ImageMetadata& metadata = {});

}  // namespace chiaro::exporting
