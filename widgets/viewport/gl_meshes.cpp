#include "widgets/viewport/gl_meshes.h"

#include "core/scene/mesh_winding.h"
#include "widgets/viewport/view_state.h"

namespace chiaro::widgets {

namespace {

template <class T>
void upload(Gl& gl, GLenum target, GLuint buffer, const std::vector<T>& values) {
    gl.glBindBuffer(target, buffer);
    gl.glBufferData(target, GLsizeiptr(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

GlMeshes::Buffers uploaded(Gl& gl, const scene::Mesh& mesh) {
    GlMeshes::Buffers made;
    made.bounds = scene::boundsOf(mesh);
    made.indexCount = GLsizei(mesh.triangles.size() * 3);
    gl.glGenVertexArrays(1, &made.vertexArray);
    gl.glGenBuffers(GLsizei(made.buffers.size()), made.buffers.data());
    gl.glBindVertexArray(made.vertexArray);
    upload(gl, GL_ARRAY_BUFFER, made.buffers[0], mesh.positions);
    gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    upload(gl, GL_ARRAY_BUFFER, made.buffers[1], mesh.normals);
    gl.glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    upload(gl, GL_ELEMENT_ARRAY_BUFFER, made.buffers[2], scene::trianglesTowardsNormals(mesh));
    gl.glEnableVertexAttribArray(0);
    gl.glEnableVertexAttribArray(1);
    gl.glBindVertexArray(0);
    return made;
}

void free(Gl& gl, const GlMeshes::Buffers& buffers) {
    gl.glDeleteVertexArrays(1, &buffers.vertexArray);
    gl.glDeleteBuffers(GLsizei(buffers.buffers.size()), buffers.buffers.data());
}

}  // namespace

void GlMeshes::sync(Gl& gl, const scene::Scene& scene) {
    std::map<std::shared_ptr<const scene::Mesh>, Buffers> kept;
    for (const scene::Object& object : scene.objects) {
        if (!object.mesh || kept.contains(object.mesh)) continue;
        auto known = m_buffers.extract(object.mesh);
        if (known)
            kept.insert(std::move(known));
        else if (isDrawn(object))
            kept.emplace(object.mesh, uploaded(gl, *object.mesh));
    }
    release(gl);
    m_buffers = std::move(kept);
}

void GlMeshes::release(Gl& gl) {
    for (const auto& [mesh, buffers] : m_buffers) free(gl, buffers);
    m_buffers.clear();
}

}  // namespace chiaro::widgets
