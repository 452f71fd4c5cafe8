#include "widgets/viewport/image_based_drawer.h"

namespace chiaro::widgets {

namespace {

constexpr int texelUnit = MethodDrawer::FirstOwnUnit;

void uploadTexels(Gl& gl, GLuint texture, const Image<DifferenceTexel>& texels) {
    gl.glBindTexture(GL_TEXTURE_2D, texture);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texels.width(), texels.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    texels.pixels().data());
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
}

/// Screen position (y up) to s and t of an object's texels, whose rows run down, after the object moved.
QVector4D coordinatesOf(const ViewTexture::Object& object, const methods::TexturePlacement& motion,
                        int height) {
    const glm::vec2 size(object.texels.width(), object.texels.height());
    const glm::vec2 origin(object.origin);
    const glm::vec2 factor = glm::vec2(1, -1) / (motion.zoom * size);
    const glm::vec2 corner = (glm::vec2(0, float(height)) - motion.offset) / motion.zoom - origin;
    const glm::vec2 summand = corner / size;
    return {factor.x, factor.y, summand.x, summand.y};
}

}  // namespace

bool ImageBasedDrawer::initialize(Gl& gl, int samples) {
    m_program = makeProgram("common/picture.vert", "image_based/image_based.frag", {{"SAMPLES", samples}});
    gl.glGenTextures(1, &m_untextured);
    uploadTexels(gl, m_untextured, Image<DifferenceTexel>(1, 1, {128, 128, 128, 255}));
    return m_program != nullptr;
}

void ImageBasedDrawer::release(Gl& gl) {
    m_program.reset();
    freeTextures(gl);
    gl.glDeleteTextures(1, &m_untextured);
    m_untextured = 0;
}

void ImageBasedDrawer::freeTextures(Gl& gl) {
    gl.glDeleteTextures(GLsizei(m_texels.size()), m_texels.data());
    m_texels.clear();
    m_texture = nullptr;
}

void ImageBasedDrawer::upload(Gl& gl, const std::shared_ptr<const ViewTexture>& texture) {
    if (texture == m_texture) return;
    const std::size_t count = texture ? texture->objects.size() : 0;
    if (count != m_texels.size()) {
        freeTextures(gl);
        m_texels.resize(count);
        gl.glGenTextures(GLsizei(count), m_texels.data());
    }
    for (std::size_t i = 0; i < count; ++i)
        if (!texture->objects[i].texels.empty()) uploadTexels(gl, m_texels[i], texture->objects[i].texels);
    m_texture = texture;
    const DifferenceRange range = texture ? texture->range : DifferenceRange::of(0);
    m_range = QVector2D(range.factor, range.bias);
}

std::vector<MethodDrawer::Pass> ImageBasedDrawer::prepare(Gl& gl, const ViewState& state, const GlPaints&,
                                                          QSize pixels) {
    upload(gl, state.viewTexture);
    const std::vector<methods::TexturePlacement> motions = state.textureMotions(pixels);
    std::vector<Pass> passes;
    m_placed.clear();
    for (std::size_t i = 0; i < state.scene().objects.size(); ++i) {
        if (!isDrawn(state.scene().objects[i])) continue;
        const bool textured = m_texture && i < m_texels.size() && !m_texture->objects[i].texels.empty();
        m_placed.push_back(
            textured ? Placed{m_texels[i], coordinatesOf(m_texture->objects[i], motions[i], pixels.height())}
                     : Placed{m_untextured, {}});
        passes.push_back({i});
    }
    return passes;
}

QOpenGLShaderProgram* ImageBasedDrawer::bind(Gl& gl, std::size_t pass, const GlPaints&) {
    gl.glActiveTexture(GL_TEXTURE0 + texelUnit);
    gl.glBindTexture(GL_TEXTURE_2D, m_placed[pass].texels);
    m_program->bind();
    m_program->setUniformValue("texels", texelUnit);
    m_program->setUniformValue("texelRange", m_range);
    m_program->setUniformValue("texelPlace", m_placed[pass].coordinates);
    return m_program.get();
}

}  // namespace chiaro::widgets
