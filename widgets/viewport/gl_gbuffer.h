#pragma once

#include "widgets/viewport/gl_meshes.h"
#include "widgets/viewport/gl_support.h"
#include "widgets/viewport/view_state.h"

#include <map>
#include <span>

namespace chiaro::widgets {

/// What each sample of each pixel sees: its light L in 16 bits and the id of the object, the OpenGL
/// counterpart of scene::GBuffer. A drawer shades from it, so that a method's shader runs once a pixel
/// however small the triangles are, and silhouettes stay smooth (4 to 8 samples a pixel). Every call needs
/// the context current.
class GlGBuffer {
public:
    /// False when the driver refuses it; why is in the log.
    bool initialize(Gl& gl);
    /// Draws these objects of the scene, by index, in their order: the first has id 1. Leaves its framebuffer
    /// bound. Returns the pixels (y down) that each can cover. With `withFaces` tells the samples' faces as
    /// well.
    std::vector<QRect> draw(Gl& gl, const ViewState& state, std::span<const std::size_t> objects,
                            QSize pixels, bool withFaces);
    /// The GL_TEXTURE_2D_MULTISAMPLE that shaders/common/gbuffer_samples.glsl reads.
    GLuint texture() const { return m_surfaces; }
    /// The GL_TEXTURE_2D_MULTISAMPLE of each sample's triangle, as numbered in its mesh: four bytes, the
    /// lowest first; undefined where there is none. 0 until it was wanted.
    GLuint faces() const { return m_faces; }
    int samples() const { return m_samples; }
    void release(Gl& gl);

private:
    /// What the shader is compiled for.
    struct Variant {
        int hardLights = 0;
        int pointLights = 0;
        bool withFaces = false;
        auto operator<=>(const Variant&) const = default;
    };
    bool allocate(Gl& gl, QSize pixels);
    void allocateFaces(Gl& gl);
    QOpenGLShaderProgram* programFor(const Variant& variant);
    void setLights(QOpenGLShaderProgram& program, const std::vector<scene::Light>& lights);

    std::map<Variant, std::unique_ptr<QOpenGLShaderProgram>> m_programs;
    GlMeshes m_meshes;
    int m_samples = 0;
    QSize m_size;
    GLuint m_framebuffer = 0;
    GLuint m_surfaces = 0;
    GLuint m_faces = 0;
    GLuint m_depth = 0;
};

}  // namespace chiaro::widgets
