#include "widgets/viewport/view_dependent_drawer.h"

#include "core/methods/view_map.h"

#include <glm/gtc/matrix_access.hpp>

#include <QtConcurrent>

#include <algorithm>
#include <set>

namespace chiaro::widgets {

namespace {

constexpr int firstBufferUnit = MethodDrawer::FirstOwnUnit + 1;
constexpr int texelUnit = MethodDrawer::FirstOwnUnit;

/// How far beyond a face its texture may be read: what half a pixel is on a steep face, and no further than
/// there are texels of its own around each map.
constexpr double reachPixels = 2;
constexpr double reachTexels = methods::ViewMap::margin - 1;

template <class T>
void fillBuffer(Gl& gl, GLuint buffer, GLuint texture, GLenum format, const std::vector<T>& values) {
    gl.glBindBuffer(GL_TEXTURE_BUFFER, buffer);
    gl.glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
    gl.glBindTexture(GL_TEXTURE_BUFFER, texture);
    gl.glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
}

GLuint uploadedTexels(Gl& gl, const ObjectTexels& texels) {
    GLuint texture = 0;
    gl.glGenTextures(1, &texture);
    gl.glBindTexture(GL_TEXTURE_3D, texture);
    gl.glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, texels.layout.size.x, texels.layout.size.y,
                    texels.layout.size.z, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.texels.data());
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace

bool ViewDependentDrawer::initialize(Gl& gl, int samples) {
    m_samples = samples;
    gl.glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &m_largestSide);
    return programFor({}) && programFor({.isTextured = true});
}

void ViewDependentDrawer::release(Gl& gl) {
    m_programs.clear();
    for (const auto& [key, entry] : m_entries) free(gl, entry.uploaded);
    m_entries.clear();
}

std::size_t ViewDependentDrawer::textureBytes() const {
    std::size_t bytes = 0;
    for (const auto& [key, entry] : m_entries) bytes += entry.uploaded.bytes;
    return bytes;
}

QOpenGLShaderProgram* ViewDependentDrawer::programFor(const Variant& variant) {
    const auto [entry, isNew] = m_programs.try_emplace(variant);
    if (!isNew) return entry->second.get();
    entry->second = makeProgram("common/picture.vert", "view_dependent/view_dependent.frag",
                                {{"SAMPLES", m_samples},
                                 {"TEXTURED", variant.isTextured},
                                 {"PERSPECTIVE", variant.isPerspective},
                                 {"FOLLOW_CAMERA", variant.followsCamera},
                                 {"PRESERVING", variant.isPreserving},
                                 {"PAGES", variant.pages}});
    if (!entry->second) return nullptr;
    QOpenGLShaderProgram& program = *entry->second;
    program.bind();
    program.setUniformValue("texels", texelUnit);
    static constexpr std::array names{"corners", "faceViews", "weights", "views"};
    for (int i = 0; i < BufferTextureCount; ++i)
        program.setUniformValue(names[std::size_t(i)], firstBufferUnit + i);
    program.release();
    return &program;
}

ViewDependentDrawer::Uploaded ViewDependentDrawer::upload(Gl& gl, const ObjectTexels& texels) {
    Uploaded made;
    made.layout = texels.layout;
    if (texels.layout.levelCount == 0) return made;
    made.bytes = texels.textureBytes();
    made.texels = uploadedTexels(gl, texels);
    gl.glGenBuffers(BufferTextureCount, made.buffers.data());
    gl.glGenTextures(BufferTextureCount, made.textures.data());
    const auto fill = [&](BufferTexture which, GLenum format, const auto& values) {
        fillBuffer(gl, made.buffers[which], made.textures[which], format, values);
    };
    fill(Corners, GL_RGB32F, texels.corners);
    fill(FaceViews, GL_RG32UI, texels.faceViews);
    fill(Weights, GL_RGBA16UI, texels.weights);
    fill(Views, GL_RGBA32F, texels.views);
    return made;
}

void ViewDependentDrawer::free(Gl& gl, const Uploaded& uploaded) {
    gl.glDeleteTextures(1, &uploaded.texels);
    gl.glDeleteTextures(BufferTextureCount, uploaded.textures.data());
    gl.glDeleteBuffers(BufferTextureCount, uploaded.buffers.data());
}

bool ViewDependentDrawer::finish(Gl& gl, Entry& entry, GlPaints::Pending pending) const {
    if (!entry.awaited) return true;
    if (pending == GlPaints::Pending::Show && !entry.texels.isFinished()) return false;
    free(gl, entry.uploaded);
    entry.uploaded = upload(gl, *entry.texels.result());
    entry.shown = std::exchange(entry.awaited, nullptr);
    entry.texels = {};
    return true;
}

bool ViewDependentDrawer::sync(Gl& gl, const ViewState& state, GlPaints::Pending pending) {
    std::set<std::pair<const scene::Mesh*, int>> worn;
    bool complete = true;
    for (std::size_t i = 0; i < state.scene().objects.size(); ++i) {
        const scene::Object& object = state.scene().objects[i];
        const Painted painted = state.paintedObject(i);
        if (!isDrawn(object) || !painted || !worn.insert({object.mesh.get(), object.sample}).second) continue;
        Entry& entry = m_entries[{object.mesh.get(), object.sample}];
        if (entry.shown == painted) {
            entry.awaited = nullptr;
        } else if (entry.awaited != painted) {
            entry.awaited = painted;
            entry.texels = QtConcurrent::run([painted, side = m_largestSide] {
                return std::make_shared<const ObjectTexels>(objectTexels(*painted, side));
            });
        }
        complete &= finish(gl, entry, pending);
    }
    std::erase_if(m_entries, [&](const auto& entry) {
        if (worn.contains(entry.first)) return false;
        free(gl, entry.second.uploaded);
        return true;
    });
    return complete;
}

std::vector<MethodDrawer::Pass> ViewDependentDrawer::prepare(Gl&, const ViewState& state, const GlPaints&,
                                                             QSize pixels) {
    const glm::dmat4 worldToClip(state.camera.projection(pixels.width(), pixels.height()) *
                                 state.camera.view());
    const glm::dvec4 eye(glm::dvec3(glm::inverse(state.camera.view())[3]), 1);
    m_pixelSize = QVector2D(2.0f / float(pixels.width()), 2.0f / float(pixels.height()));
    m_placed.clear();
    std::vector<Pass> passes;
    for (std::size_t i = 0; i < state.scene().objects.size(); ++i) {
        const scene::Object& object = state.scene().objects[i];
        if (!isDrawn(object)) continue;
        passes.push_back({i});
        Placed& placed = m_placed.emplace_back();
        const auto found = m_entries.find({object.mesh.get(), object.sample});
        if (found == m_entries.end() || found->second.uploaded.texels == 0) continue;
        placed.uploaded = &found->second.uploaded;
        const ObjectTexels::Layout& layout = placed.uploaded->layout;
        placed.variant = {true, layout.isPerspective, state.viewDependent.followCamera,
                          state.viewDependent.blend == methods::Blend::Preserving, layout.pageCount};
        const glm::dmat4 transform(object.transform);
        const glm::dmat4 fromMiddle = glm::translate(glm::dmat4(1), layout.middle);
        const glm::dmat4 objectToClip = worldToClip * transform * fromMiddle;
        placed.objectToClip = qtMatrix(glm::mat4(objectToClip));
        const double clipPerUnit = glm::length(glm::dvec3(glm::row(objectToClip, 1)));
        placed.reach = QVector2D(float(reachPixels * m_pixelSize.y() / clipPerUnit),
                                 float(reachTexels * layout.texelSize));
        const glm::dvec3 eyeInObject = glm::dvec3(glm::inverse(transform) * eye) - layout.middle;
        placed.eye = QVector3D(float(eyeInObject.x), float(eyeInObject.y), float(eyeInObject.z));
    }
    return passes;
}

QOpenGLShaderProgram* ViewDependentDrawer::bind(Gl& gl, std::size_t pass, const GlPaints&) {
    const Placed& placed = m_placed[pass];
    QOpenGLShaderProgram* program = programFor(placed.variant);
    if (!program) return nullptr;
    program->bind();
    if (!placed.uploaded) return program;
    gl.glActiveTexture(GL_TEXTURE0 + texelUnit);
    gl.glBindTexture(GL_TEXTURE_3D, placed.uploaded->texels);
    for (int i = 0; i < BufferTextureCount; ++i) {
        gl.glActiveTexture(GLenum(GL_TEXTURE0 + firstBufferUnit + i));
        gl.glBindTexture(GL_TEXTURE_BUFFER, placed.uploaded->textures[std::size_t(i)]);
    }
    const ObjectTexels::Layout& layout = placed.uploaded->layout;
    const float end = 0.5f / float(layout.levelCount);
    program->setUniformValue("texelRange", QVector2D(layout.range.factor, layout.range.bias));
    program->setUniformValue("levelEnds", QVector2D(end, 1 - end));
    program->setUniformValue("objectToClip", placed.objectToClip);
    program->setUniformValue("pixelSize", m_pixelSize);
    program->setUniformValue("reach", placed.reach);
    program->setUniformValue("eye", placed.eye);
    return program;
}

}  // namespace chiaro::widgets
