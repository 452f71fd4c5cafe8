#include "widgets/viewport/gl_composition.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

using Mode = Composition::Mode;

std::size_t programOf(Mode mode) {
    return mode == Mode::Wipe ? 0 : mode == Mode::Blend ? 1 : 2;
}

QVector3D amountOf(const Composition& composition, QSize pixels) {
    if (composition.mode == Mode::Blend) return {float(composition.blend), 0, 0};
    if (composition.mode == Mode::Difference) return {float(composition.gain), 0, 0};
    // OpenGL's y goes up.
    const WipeLine line = wipeLine(composition, pixels);
    return {float(line.normal.x), float(-line.normal.y),
            float(line.offset - pixels.height() * line.normal.y)};
}

}  // namespace

bool GlComposition::initialize(Gl& gl) {
    release(gl);
    for (int mode = 0; mode < int(m_programs.size()); ++mode)
        m_programs[std::size_t(mode)] =
            makeProgram("common/picture.vert", "common/composition.frag", {{"MODE", mode}});
    gl.glGenVertexArrays(1, &m_noAttributes);
    return std::ranges::all_of(m_programs, [](const auto& program) { return program != nullptr; });
}

void GlComposition::free(Gl& gl) {
    for (const Picture& picture : m_pictures) {
        gl.glDeleteFramebuffers(1, &picture.framebuffer);
        gl.glDeleteTextures(1, &picture.texture);
    }
    m_pictures.clear();
}

void GlComposition::release(Gl& gl) {
    free(gl);
    for (auto& program : m_programs) program.reset();
    gl.glDeleteVertexArrays(1, &m_noAttributes);
    m_noAttributes = 0;
}

void GlComposition::reserve(Gl& gl, std::size_t count, QSize pixels) {
    if (count == m_pictures.size() && pixels == m_size) return;
    free(gl);
    m_size = pixels;
    m_pictures.resize(count);
    for (Picture& picture : m_pictures) {
        gl.glGenTextures(1, &picture.texture);
        gl.glBindTexture(GL_TEXTURE_2D, picture.texture);
        gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.width(), pixels.height(), 0, GL_RGBA,
                        GL_UNSIGNED_BYTE, nullptr);
        gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl.glGenFramebuffers(1, &picture.framebuffer);
        gl.glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer);
        gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.texture, 0);
    }
}

void GlComposition::place(Gl& gl, const std::vector<QRect>& panes, QSize pixels, GLuint target) const {
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    for (std::size_t pane = 0; pane < panes.size(); ++pane) {
        const QRect& rect = panes[pane];
        const int bottom = pixels.height() - rect.y() - rect.height();
        gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, m_pictures[pane].framebuffer);
        gl.glBlitFramebuffer(0, 0, rect.width(), rect.height(), rect.x(), bottom, rect.x() + rect.width(),
                             bottom + rect.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
}

void GlComposition::combine(Gl& gl, const Composition& composition, QSize pixels) {
    QOpenGLShaderProgram& program = *m_programs[programOf(composition.mode)];
    program.bind();
    for (int unit = 0; unit < 2; ++unit) {
        gl.glActiveTexture(GLenum(GL_TEXTURE0 + unit));
        gl.glBindTexture(GL_TEXTURE_2D, m_pictures[std::size_t(unit)].texture);
    }
    program.setUniformValue("first", 0);
    program.setUniformValue("second", 1);
    program.setUniformValue("amount", amountOf(composition, pixels));
    gl.glBindVertexArray(m_noAttributes);
    gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    gl.glBindVertexArray(0);
    gl.glActiveTexture(GL_TEXTURE0);
    program.release();
}

void GlComposition::show(Gl& gl, const Composition& composition, QSize pixels, double ratio, glm::vec3 ground,
                         GLuint target) {
    gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
    gl.glViewport(0, 0, pixels.width(), pixels.height());
    gl.glDisable(GL_DEPTH_TEST);
    gl.glClearColor(ground.r, ground.g, ground.b, 1);
    gl.glClear(GL_COLOR_BUFFER_BIT);
    if (composition.mode == Mode::SideBySide)
        place(gl, paneRects(composition, pixels, ratio), pixels, target);
    else
        combine(gl, composition, pixels);
}

}  // namespace chiaro::widgets
