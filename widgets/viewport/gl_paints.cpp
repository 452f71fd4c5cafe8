#include "widgets/viewport/gl_paints.h"

#include <QtConcurrent>

#include <set>

namespace chiaro::widgets {

namespace {

/// Half floats: a gradient of thousands of colours has steps far below 1/255.
void uploadGradient(Gl& gl, GLuint texture, const gradient::Gradient& gradient) {
    gl.glBindTexture(GL_TEXTURE_1D, texture);
    gl.glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB16F, GLsizei(gradient.size()), 0, GL_RGB, GL_FLOAT,
                    gradient.data());
    gl.glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

}  // namespace

void GlPaints::syncGradient(Gl& gl, Entry& entry, const gradient::Gradient& gradient) {
    if (entry.paint.gradient != 0 && entry.gradient == gradient) return;
    if (entry.paint.gradient == 0) gl.glGenTextures(1, &entry.paint.gradient);
    uploadGradient(gl, entry.paint.gradient, gradient);
    const float width = float(gradient.size());
    entry.paint.gradientSpan = QVector2D((width - 1) / width, 0.5f / width);
    entry.gradient = gradient;
}

void GlPaints::startLevels(Gl& gl, Entry& entry, const std::shared_ptr<const synthesis::LevelStack>& levels) {
    const bool isNew = entry.paint.levels == 0;
    if (!isNew && entry.levels == levels) return;
    entry.levels = levels;
    drop(gl, entry);
    const bool textured = levels && !levels->levels.empty();
    if (isNew || !textured) {
        // Without levels a single texel of no difference stands in.
        const methods::LevelTexels none{1, 1, {}, {methods::DifferenceTexel{}}};
        TextureUpload upload(none.texels.data(), glm::ivec3(1));
        upload.goOn(gl, QDeadlineTimer(QDeadlineTimer::Forever));
        showLevels(gl, entry, none, upload.take());
    }
    if (!textured) return;
    entry.texels = QtConcurrent::run(
        [levels] { return std::make_shared<const methods::LevelTexels>(methods::levelTexels(*levels)); });
}

bool GlPaints::finishLevels(Gl& gl, Entry& entry, Pending pending, QDeadlineTimer deadline) {
    if (!entry.texels.isValid()) return true;
    if (pending == Pending::Show && !entry.texels.isFinished()) return false;
    const std::shared_ptr<const methods::LevelTexels> texels = entry.texels.result();
    if (!entry.upload)
        entry.upload.emplace(texels->texels.data(), glm::ivec3(texels->size, texels->size, texels->count));
    if (pending == Pending::Await) deadline = QDeadlineTimer(QDeadlineTimer::Forever);
    if (!entry.upload->goOn(gl, deadline)) return false;
    showLevels(gl, entry, *texels, entry.upload->take());
    drop(gl, entry);
    return true;
}

/// The texture is one that an upload finished, and bound.
void GlPaints::showLevels(Gl& gl, Entry& entry, const methods::LevelTexels& texels, GLuint texture) {
    gl.glDeleteTextures(1, &entry.paint.levels);
    entry.paint.levels = texture;
    entry.paint.size = texels.size;
    entry.paint.levelRange = QVector2D(texels.range.factor, texels.range.bias);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_T, GL_REPEAT);
}

/// What is on its way.
void GlPaints::drop(Gl& gl, Entry& entry) {
    if (entry.upload) entry.upload->cancel(gl);
    entry.upload.reset();
    entry.texels = {};
}

void GlPaints::free(Gl& gl, Entry& entry) {
    drop(gl, entry);
    gl.glDeleteTextures(1, &entry.paint.levels);
    gl.glDeleteTextures(1, &entry.paint.gradient);
}

bool GlPaints::sync(Gl& gl, const ViewState& state, bool usesLevels, Pending pending) {
    std::set<int> worn;
    for (const scene::Object& object : state.scene().objects) worn.insert(object.sample);
    for (auto entry = m_entries.begin(); entry != m_entries.end();) {
        if (worn.contains(entry->first)) {
            ++entry;
            continue;
        }
        free(gl, entry->second);
        entry = m_entries.erase(entry);
    }
    bool complete = true;
    const QDeadlineTimer deadline(TextureUpload::frameMilliseconds);
    for (const int sample : worn) {
        Entry& entry = m_entries[sample];
        syncGradient(gl, entry, state.paint(sample).gradient);
        if (!usesLevels) continue;
        startLevels(gl, entry, state.paint(sample).levels);
        complete &= finishLevels(gl, entry, pending, deadline);
    }
    return complete;
}

void GlPaints::release(Gl& gl) {
    for (auto& [sample, entry] : m_entries) free(gl, entry);
    m_entries.clear();
}

}  // namespace chiaro::widgets
