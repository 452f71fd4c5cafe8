#pragma once

#include "core/scene/scene.h"
#include "widgets/viewport/gl_support.h"

#include <map>
#include <memory>

namespace chiaro::widgets {

/// The meshes of a scene in the graphics memory, each uploaded once however many objects or frames show it.
/// Attribute 0 is the position, 1 the normal. Every call needs the context current.
class GlMeshes {
public:
    struct Buffers {
        GLuint vertexArray = 0;
        std::array<GLuint, 3> buffers{};  ///< positions, normals, indices
        GLsizei indexCount = 0;           ///< 32-bit, triangles
        scene::Bounds bounds;             ///< object space
    };

    /// Uploads what the scene shows for the first time, frees what it shows no longer.
    void sync(Gl& gl, const scene::Scene& scene);
    const Buffers& find(const std::shared_ptr<const scene::Mesh>& mesh) const { return m_buffers.at(mesh); }
    void release(Gl& gl);

private:
    std::map<std::shared_ptr<const scene::Mesh>, Buffers> m_buffers;
};

}  // namespace chiaro::widgets
