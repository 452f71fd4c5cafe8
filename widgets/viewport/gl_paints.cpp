#include "widgets/viewport/gl_paints.h"

#include "widgets/viewport/level_texels.h"

#include <set>

namespace chiaro::widgets {

namespace {

void uploadLevels(Gl& gl, GLuint texture, const LevelTexels& texels) {
    gl.glBindTexture(GL_TEXTURE_3D, texture);
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

void syncGradient(Gl& gl, GlPaints::Paint& paint, gradient::Gradient& uploaded,
                  const gradient::Gradient& gradient) {
    if (paint.gradient != 0 && uploaded == gradient) return;
    if (paint.gradient == 0) gl.glGenTextures(1, &paint.gradient);
    uploadGradient(gl, paint.gradient, gradient);
    const float width = float(gradient.size());
    paint.gradientSpan = QVector2D((width - 1) / width, 0.5f / width);
    uploaded = gradient;
}

void syncLevels(Gl& gl, GlPaints::Paint& paint, std::shared_ptr<const synthesis::LevelStack>& uploaded,
                const std::shared_ptr<const synthesis::LevelStack>& levels) {
    if (paint.levels != 0 && uploaded == levels) return;
    if (paint.levels == 0) gl.glGenTextures(1, &paint.levels);
    // Without levels a single texel of no difference stands in.
    const LevelTexels texels = levels && !levels->levels.empty()
                                   ? levelTexels(*levels)
                                   : LevelTexels{1, 1, 0, 0, {LevelTexels::Texel{}}};
    uploadLevels(gl, paint.levels, texels);
    paint.size = texels.size;
    paint.levelRange = QVector2D(texels.factor, texels.bias);
    uploaded = levels;
}

}  // namespace

void GlPaints::sync(Gl& gl, const ViewState& state) {
    std::set<int> worn;
    for (const scene::Object& object : state.scene().objects) worn.insert(object.sample);
    std::erase_if(m_entries, [&](const auto& entry) {
        if (worn.contains(entry.first)) return false;
        free(gl, entry.second.paint);
        return true;
    });
    for (const int sample : worn) {
        Entry& entry = m_entries[sample];
        syncGradient(gl, entry.paint, entry.gradient, state.paint(sample).gradient);
        syncLevels(gl, entry.paint, entry.levels, state.paint(sample).levels);
    }
}

void GlPaints::release(Gl& gl) {
    for (const auto& [sample, entry] : m_entries) free(gl, entry.paint);
    m_entries.clear();
}

}  // namespace chiaro::widgets
