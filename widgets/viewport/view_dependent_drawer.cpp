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

}  // namespace

bool ViewDependentDrawer::initialize(Gl& gl, int samples) {
    m_samples = samples;
    gl.glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &m_largestSide);
    return programFor({}) && programFor({.isTextured = true});
}

void ViewDependentDrawer::release(Gl& gl) {
    m_programs.clear();
    for (auto& [key, entry] : m_entries) free(gl, entry);
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
    for (int i = 0; i < UploadedObject::BufferTextureCount; ++i)
        program.setUniformValue(names[std::size_t(i)], firstBufferUnit + i);
    program.release();
    return &program;
}

void ViewDependentDrawer::free(Gl& gl, Entry& entry) {
    if (entry.upload) entry.upload->cancel(gl);
    entry.uploaded.free(gl);
}

/// Drops what is on its way, and begins with the texels of this; null: with nothing.
void ViewDependentDrawer::await(Gl& gl, Entry& entry, const Painted& painted) const {
    if (entry.awaited == painted) return;
    if (entry.upload) entry.upload->cancel(gl);
    entry.upload.reset();
    entry.awaited = painted;
    entry.texels = {};
    if (!painted) return;
    entry.texels = QtConcurrent::run([painted, side = m_largestSide] {
        return std::make_shared<const methods::ObjectTexels>(methods::objectTexels(*painted, side));
    });
}

bool ViewDependentDrawer::finish(Gl& gl, Entry& entry, GlPaints::Pending pending, QDeadlineTimer deadline) {
    if (!entry.awaited) return true;
    if (!entry.upload) {
        if (pending == GlPaints::Pending::Show && !entry.texels.isFinished()) return false;
        entry.upload.emplace(entry.texels.result());
        entry.texels = {};
    }
    if (pending == GlPaints::Pending::Await) deadline = QDeadlineTimer(QDeadlineTimer::Forever);
    if (!entry.upload->goOn(gl, deadline)) return false;
    entry.uploaded.free(gl);
    entry.uploaded = entry.upload->take();
    entry.upload.reset();
    entry.shown = std::exchange(entry.awaited, nullptr);
    return true;
}

bool ViewDependentDrawer::sync(Gl& gl, const ViewState& state, GlPaints::Pending pending) {
    std::set<std::pair<const scene::Mesh*, int>> worn;
    bool complete = true;
    const QDeadlineTimer deadline(TextureUpload::frameMilliseconds);
    for (std::size_t i = 0; i < state.scene().objects.size(); ++i) {
        const scene::Object& object = state.scene().objects[i];
        const Painted painted = state.paintedObject(i);
        if (!isDrawn(object) || !painted || !worn.insert({object.mesh.get(), object.sample}).second) continue;
        Entry& entry = m_entries[{object.mesh.get(), object.sample}];
        await(gl, entry, entry.shown == painted ? nullptr : painted);
        complete &= finish(gl, entry, pending, deadline);
    }
    for (auto entry = m_entries.begin(); entry != m_entries.end();) {
        if (worn.contains(entry->first)) {
            ++entry;
            continue;
        }
        free(gl, entry->second);
        entry = m_entries.erase(entry);
    }
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
        const methods::ObjectTexels::Layout& layout = placed.uploaded->layout;
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
    for (int i = 0; i < UploadedObject::BufferTextureCount; ++i) {
        gl.glActiveTexture(GLenum(GL_TEXTURE0 + firstBufferUnit + i));
        gl.glBindTexture(GL_TEXTURE_BUFFER, placed.uploaded->textures[std::size_t(i)]);
    }
    const methods::ObjectTexels::Layout& layout = placed.uploaded->layout;
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
