#include "widgets/viewport/gl_gbuffer.h"

#include "widgets/viewport/screen_bounds.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr int maximumLights = 16;  ///< of each kind that the shader loops over

bool isPoint(const scene::Light& light) {
    return light.visible && light.kind == scene::Light::Kind::Point;
}

bool isHard(const scene::Light& light) {
    return light.visible && light.kind == scene::Light::Kind::Directional && !light.wrap;
}

int countOf(const std::vector<scene::Light>& lights, bool (*counts)(const scene::Light&)) {
    return std::min(int(std::ranges::count_if(lights, counts)), maximumLights);
}

void drawObject(Gl& gl, QOpenGLShaderProgram& program, const GlMeshes::Buffers& buffers,
                const scene::Object& object, const glm::mat4& worldToClip, std::size_t id) {
    const glm::mat3 linear(object.transform);
    program.setUniformValue("objectToClip", qtMatrix(worldToClip * object.transform));
    program.setUniformValue(
        "normalToWorld", qtMatrix(glm::mat4(glm::transpose(glm::inverse(linear)))).toGenericMatrix<3, 3>());
    program.setUniformValue("objectToWorld", qtMatrix(object.transform));
    program.setUniformValue("objectId", QVector2D(float(id % 256), float(id / 256)));
    // A mirroring transform turns the triangles around; their front sides stay what they were.
    gl.glFrontFace(glm::determinant(linear) < 0 ? GL_CW : GL_CCW);
    gl.glBindVertexArray(buffers.vertexArray);
    gl.glDrawElements(GL_TRIANGLES, buffers.indexCount, GL_UNSIGNED_INT, nullptr);
}

}  // namespace

bool GlGBuffer::initialize(Gl& gl) {
    gl.glGetIntegerv(GL_MAX_SAMPLES, &m_samples);
    m_samples = std::min(m_samples, 8);
    return programFor({}) && allocate(gl, {16, 16});
}

bool GlGBuffer::allocate(Gl& gl, QSize pixels) {
    gl.glDeleteFramebuffers(1, &m_framebuffer);
    gl.glDeleteTextures(1, &m_surfaces);
    gl.glDeleteTextures(1, &m_faces);
    m_faces = 0;
    gl.glDeleteRenderbuffers(1, &m_depth);
    gl.glGenTextures(1, &m_surfaces);
    gl.glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, m_surfaces);
    gl.glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, m_samples, GL_RGBA8, pixels.width(),
                               pixels.height(), GL_TRUE);
    gl.glGenRenderbuffers(1, &m_depth);
    gl.glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
    gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER, m_samples, GL_DEPTH_COMPONENT24, pixels.width(),
                                        pixels.height());
    gl.glGenFramebuffers(1, &m_framebuffer);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, m_surfaces, 0);
    gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
    m_size = pixels;
    const GLenum status = gl.glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) qWarning("OpenGL refuses the G-buffer: 0x%x", status);
    return status == GL_FRAMEBUFFER_COMPLETE;
}

void GlGBuffer::allocateFaces(Gl& gl) {
    gl.glGenTextures(1, &m_faces);
    gl.glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, m_faces);
    gl.glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, m_samples, GL_RGBA8, m_size.width(),
                               m_size.height(), GL_TRUE);
    gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D_MULTISAMPLE, m_faces, 0);
}

QOpenGLShaderProgram* GlGBuffer::programFor(const Variant& variant) {
    const auto [entry, isNew] = m_programs.try_emplace(variant);
    if (isNew)
        entry->second = makeProgram("common/gbuffer.vert", "common/gbuffer.frag",
                                    {{"HARD_LIGHTS", variant.hardLights},
                                     {"POINT_LIGHTS", variant.pointLights},
                                     {"FACES", variant.withFaces}});
    return entry->second.get();
}

void GlGBuffer::setLights(QOpenGLShaderProgram& program, const std::vector<scene::Light>& lights) {
    glm::vec4 wrapped(0);
    std::vector<QVector3D> hard, points;
    std::vector<QVector2D> shine;
    for (const scene::Light& light : lights) {
        if (isPoint(light) && int(points.size()) < maximumLights) {
            points.emplace_back(light.vector.x, light.vector.y, light.vector.z);
            shine.emplace_back(light.shine(0), light.shine(1) - light.shine(0));
        }
        if (!light.visible || light.kind != scene::Light::Kind::Directional) continue;
        const glm::vec3 shone = glm::normalize(light.vector) * light.intensity;
        if (light.wrap)
            wrapped += glm::vec4(shone, light.intensity) * 0.5f;
        else if (int(hard.size()) < maximumLights)
            hard.emplace_back(shone.x, shone.y, shone.z);
    }
    program.setUniformValue("wrappedLight", wrapped.x, wrapped.y, wrapped.z, wrapped.w);
    if (!hard.empty()) program.setUniformValueArray("hardLights", hard.data(), int(hard.size()));
    if (points.empty()) return;
    program.setUniformValueArray("pointLights", points.data(), int(points.size()));
    program.setUniformValueArray("pointShine", shine.data(), int(shine.size()));
}

std::vector<QRect> GlGBuffer::draw(Gl& gl, const ViewState& state, std::span<const std::size_t> objects,
                                   QSize pixels, bool withFaces) {
    const scene::Scene& scene = state.scene();
    m_meshes.sync(gl, scene);
    if (m_size != pixels) allocate(gl, pixels);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    if (withFaces && m_faces == 0) allocateFaces(gl);
    static constexpr std::array<GLenum, 2> targets{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl.glDrawBuffers(withFaces ? 2 : 1, targets.data());
    gl.glViewport(0, 0, pixels.width(), pixels.height());
    gl.glDisable(GL_BLEND);
    gl.glDisable(GL_CULL_FACE);
    gl.glEnable(GL_DEPTH_TEST);
    gl.glDepthFunc(GL_LESS);
    gl.glDepthMask(GL_TRUE);
    gl.glClearColor(0, 0, 0, 0);
    gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    QOpenGLShaderProgram* program =
        programFor({countOf(scene.lights, isHard), countOf(scene.lights, isPoint), withFaces});
    if (!program) return std::vector<QRect>(objects.size());
    program->bind();
    setLights(*program, scene.lights);
    const glm::mat4 worldToClip =
        state.camera.projection(pixels.width(), pixels.height()) * state.camera.view();
    std::vector<QRect> covered;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const scene::Object& object = scene.objects[objects[i]];
        const GlMeshes::Buffers& buffers = m_meshes.find(object.mesh);
        covered.push_back(screenBounds(buffers.bounds, worldToClip * object.transform, pixels));
        if (covered.back().isEmpty()) continue;
        drawObject(gl, *program, buffers, object, worldToClip, i + 1);
    }
    gl.glBindVertexArray(0);
    program->release();
    return covered;
}

void GlGBuffer::release(Gl& gl) {
    m_programs.clear();
    m_meshes.release(gl);
    gl.glDeleteFramebuffers(1, &m_framebuffer);
    gl.glDeleteTextures(1, &m_surfaces);
    gl.glDeleteTextures(1, &m_faces);
    gl.glDeleteRenderbuffers(1, &m_depth);
    m_framebuffer = m_surfaces = m_faces = m_depth = 0;
    m_size = {};
}

}  // namespace chiaro::widgets
