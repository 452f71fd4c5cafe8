#pragma once

#include "core/export/textured_mesh.h"

namespace chiaro::exporting {

// One function a file: a scene to the bytes that say it. `path` is only named in errors.

/// A scene without a texture gives meshes without a material.
std::string glbBytes(const std::filesystem::path& path, const TexturedScene& scene,
                     const ImageMetadata& metadata);
std::string pngBytes(const std::filesystem::path& path, const ByteImage& picture,
                     const ImageMetadata& metadata);
/// The material of an OBJ file; `picture` lies beside it.
std::string mtlBytes(const std::filesystem::path& picture, const TexturedScene& scene,
                     const ImageMetadata& metadata);
/// `material` lies beside it.
std::string objBytes(const std::filesystem::path& material, const TexturedScene& scene,
                     const ImageMetadata& metadata);
std::string plyBytes(const TexturedScene& scene, const ImageMetadata& metadata);

/// Takes an object to its place in the world.
class PlacedVertices {
public:
    explicit PlacedVertices(const TexturedObject& object)
        : m_transform(object.transform),
          m_normalMatrix(glm::transpose(glm::inverse(glm::mat3(object.transform)))),
          m_isMirrored(glm::determinant(glm::mat3(object.transform)) < 0) {}

    glm::vec3 position(const glm::vec3& position) const {
        return glm::vec3(m_transform * glm::vec4(position, 1));
    }
    glm::vec3 normal(const glm::vec3& normal) const {
        const glm::vec3 turned = m_normalMatrix * normal;
        const float length = glm::length(turned);
        return length > 0 ? turned / length : glm::vec3(0, 0, 1);
    }
    /// In the order in which the front stays the front.
    scene::Triangle triangle(const scene::Triangle& triangle) const {
        return m_isMirrored ? scene::Triangle{triangle[0], triangle[2], triangle[1]} : triangle;
    }

private:
    glm::mat4 m_transform;
    glm::mat3 m_normalMatrix;
    bool m_isMirrored;
};

}  // namespace chiaro::exporting
