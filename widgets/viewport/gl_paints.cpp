#include "widgets/viewport/gl_paints.h"

#include <QtConcurrent>

#include <set>

namespace chiaro::widgets {

namespace {

void uploadLevels(Gl& gl, GlPaints::Paint& paint, const LevelTexels& texels) {
    if (paint.levels == 0) gl.glGenTextures(1, &paint.levels);
    paint.size = texels.size;
    paint.levelRange = QVector2D(texels.range.factor, texels.range.bias);
    gl.glBindTexture(GL_TEXTURE_3D, paint.levels);
    gl.glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, texels.size, texels.size, texels.count, 0, GL_RGBA,
                    GL_UNSIGNED_BYTE, texels.texels.data());
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
}

/// Half floats: a gradient of thousands of colours has steps far below 1/255.
void uploadGradient(Gl& gl, GLuint texture, const gradient::Gradient& gradient) {
    gl.glBindTexture(GL_TEXTURE_1D, texture);
    gl.glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB16F, GLsizei(gradient.size()), 0, GL_RGB, GL_FLOAT,
                    gradient.data());
    gl.glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

void free(Gl& gl, const GlPaints::Paint& paint) {
    gl.glDeleteTextures(1, &paint.levels);
    gl.glDeleteTextures(1, &paint.gradient);
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
    entry.texels = {};
    const bool textured = levels && !levels->levels.empty();
    // Without levels a single texel of no difference stands in.
    if (isNew || !textured) uploadLevels(gl, entry.paint, {1, 1, {}, {DifferenceTexel{}}});
    if (!textured) return;
    entry.texels =
        QtConcurrent::run([levels] { return std::make_shared<const LevelTexels>(levelTexels(*levels)); });
}

bool GlPaints::finishLevels(Gl& gl, Entry& entry, Pending pending) {
    if (!entry.texels.isValid()) return true;
    if (pending == Pending::Show && !entry.texels.isFinished()) return false;
    uploadLevels(gl, entry.paint, *entry.texels.result());
    entry.texels = {};
    return true;
}

bool GlPaints::sync(Gl& gl, const ViewState& state, bool usesLevels, Pending pending) {
    std::set<int> worn;
    for (const scene::Object& object : state.scene().objects) worn.insert(object.sample);
    std::erase_if(m_entries, [&](const auto& entry) {
        if (worn.contains(entry.first)) return false;
        free(gl, entry.second.paint);
        return true;
    });
    bool complete = true;
    for (const int sample : worn) {
        Entry& entry = m_entries[sample];
        syncGradient(gl, entry, state.paint(sample).gradient);
        if (!usesLevels) continue;
        startLevels(gl, entry, state.paint(sample).levels);
        complete &= finishLevels(gl, entry, pending);
    }
    return complete;
}

void GlPaints::release(Gl& gl) {
    for (const auto& [sample, entry] : m_entries) free(gl, entry.paint);
    m_entries.clear();
}

}  // namespace chiaro::widgets
