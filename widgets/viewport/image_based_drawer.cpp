#include "widgets/viewport/image_based_drawer.h"

namespace chiaro::widgets {

namespace {

void uploadTexels(Gl& gl, GLuint texture, const Image<methods::DifferenceTexel>& texels) {
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
    for (int layers : {1, 2})
        m_programs[std::size_t(layers) - 1] =
            makeProgram("common/picture.vert", "image_based/image_based.frag",
                        {{"SAMPLES", samples}, {"LAYERS", layers}});
    gl.glGenTextures(1, &m_untextured);
    uploadTexels(gl, m_untextured, Image<methods::DifferenceTexel>(1, 1, {128, 128, 128, 255}));
    return m_programs[0] && m_programs[1];
}

void ImageBasedDrawer::release(Gl& gl) {
    for (auto& program : m_programs) program.reset();
    freeTextures(gl, m_shown);
    freeTextures(gl, m_earlier);
    gl.glDeleteTextures(1, &m_untextured);
    m_untextured = 0;
}

void ImageBasedDrawer::freeTextures(Gl& gl, Uploaded& uploaded) {
    gl.glDeleteTextures(GLsizei(uploaded.texels.size()), uploaded.texels.data());
    uploaded = {};
}

void ImageBasedDrawer::upload(Gl& gl, const std::shared_ptr<const ViewTexture>& texture) {
    if (texture == m_shown.texture) return;
    std::swap(m_shown, m_earlier);
    if (texture == m_shown.texture) return;
    const std::size_t count = texture ? texture->objects.size() : 0;
    if (count != m_shown.texels.size()) {
        freeTextures(gl, m_shown);
        m_shown.texels.resize(count);
        gl.glGenTextures(GLsizei(count), m_shown.texels.data());
    }
    for (std::size_t i = 0; i < count; ++i)
        if (!texture->objects[i].texels.empty())
            uploadTexels(gl, m_shown.texels[i], texture->objects[i].texels);
    m_shown.texture = texture;
}

ImageBasedDrawer::Placed ImageBasedDrawer::placed(const Uploaded& uploaded, std::size_t object,
                                                  const methods::TexturePlacement& motion, int height,
                                                  float weight) const {
    const bool textured =
        object < uploaded.texels.size() && !uploaded.texture->objects[object].texels.empty();
    if (!textured) return {m_untextured, {}, {}};
    const methods::DifferenceRange& range = uploaded.texture->range;
    return {uploaded.texels[object], coordinatesOf(uploaded.texture->objects[object], motion, height),
            QVector2D(range.factor, range.bias) * weight};
}

std::vector<MethodDrawer::Pass> ImageBasedDrawer::prepare(Gl& gl, const ViewState& state, const GlPaints&,
                                                          QSize pixels) {
    upload(gl, state.viewTexture);
    m_isFading = m_shown.texture && state.earlierTexture && state.earlierTexture == m_earlier.texture;
    using Motions = std::vector<methods::TexturePlacement>;
    const auto motionsOf = [&](const Uploaded& uploaded) {
        return uploaded.texture ? state.textureMotions(*uploaded.texture, pixels)
                                : Motions(state.scene().objects.size());
    };
    const Motions motions = motionsOf(m_shown);
    const Motions earlierMotions = m_isFading ? motionsOf(m_earlier) : Motions(motions.size());
    // Squares of the weights add up to 1: unrelated strokes keep their contrast on the way.
    const float earlier = m_isFading ? state.earlierWeight : 0;
    const float norm = 1 / std::sqrt(earlier * earlier + (1 - earlier) * (1 - earlier));
    std::vector<Pass> passes;
    m_placed.clear();
    for (std::size_t i = 0; i < state.scene().objects.size(); ++i) {
        if (!isDrawn(state.scene().objects[i])) continue;
        Layers layers{placed(m_shown, i, motions[i], pixels.height(), (1 - earlier) * norm)};
        if (m_isFading) layers[1] = placed(m_earlier, i, earlierMotions[i], pixels.height(), earlier * norm);
        m_placed.push_back(layers);
        passes.push_back({i});
    }
    return passes;
}

QOpenGLShaderProgram* ImageBasedDrawer::bind(Gl& gl, std::size_t pass, const GlPaints&) {
    const std::size_t layers = m_isFading ? 2 : 1;
    QOpenGLShaderProgram* program = m_programs[layers - 1].get();
    program->bind();
    for (std::size_t i = 0; i < layers; ++i) {
        const int unit = FirstOwnUnit + int(i);
        gl.glActiveTexture(GLenum(GL_TEXTURE0 + unit));
        gl.glBindTexture(GL_TEXTURE_2D, m_placed[pass][i].texels);
        const auto name = [i](const char* uniform) {
            return QString("%1[%2]").arg(uniform).arg(i).toLatin1();
        };
        program->setUniformValue(name("texels").constData(), unit);
        program->setUniformValue(name("texelRange").constData(), m_placed[pass][i].range);
        program->setUniformValue(name("texelPlace").constData(), m_placed[pass][i].coordinates);
    }
    return program;
}

}  // namespace chiaro::widgets
