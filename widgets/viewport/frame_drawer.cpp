#include "widgets/viewport/frame_drawer.h"

#include "widgets/viewport/image_based_drawer.h"
#include "widgets/viewport/view_aligned_drawer.h"
#include "widgets/viewport/view_dependent_drawer.h"

#include <algorithm>

namespace chiaro::widgets {

FrameDrawer::FrameDrawer() {
    m_methods["image-based"] = std::make_unique<ImageBasedDrawer>();
    m_methods["view-dependent"] = std::make_unique<ViewDependentDrawer>();
    m_methods["view-aligned"] = std::make_unique<ViewAlignedDrawer>();
}

FrameDrawer::~FrameDrawer() = default;

bool FrameDrawer::initialize(Gl& gl) {
    release(gl);
    if (!m_gbuffer.initialize(gl)) return false;
    gl.glGenVertexArrays(1, &m_noAttributes);
    return std::ranges::all_of(
        m_methods, [&](const auto& method) { return method.second->initialize(gl, m_gbuffer.samples()); });
}

void FrameDrawer::release(Gl& gl) {
    m_gbuffer.release(gl);
    m_paints.release(gl);
    for (const auto& [key, method] : m_methods) method->release(gl);
    gl.glDeleteVertexArrays(1, &m_noAttributes);
    m_noAttributes = 0;
}

void FrameDrawer::clear(Gl& gl, const ViewState& state, QSize pixels, GLuint target) {
    gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
    gl.glViewport(0, 0, pixels.width(), pixels.height());
    gl.glDisable(GL_DEPTH_TEST);
    gl.glClearColor(state.background.r, state.background.g, state.background.b, 1);
    gl.glClear(GL_COLOR_BUFFER_BIT);
}

void FrameDrawer::shade(Gl& gl, MethodDrawer& method, std::size_t pass, int sample, const Area& area) {
    QOpenGLShaderProgram* program = method.bind(gl, pass, m_paints);
    if (!program) return;
    const GlPaints::Paint& paint = m_paints.find(sample);
    gl.glActiveTexture(GL_TEXTURE0 + MethodDrawer::GradientUnit);
    gl.glBindTexture(GL_TEXTURE_1D, paint.gradient);
    program->setUniformValue("surfaces", MethodDrawer::SurfaceUnit);
    if (method.usesFaces()) program->setUniformValue("faces", MethodDrawer::FaceUnit);
    program->setUniformValue("gradient", MethodDrawer::GradientUnit);
    program->setUniformValue("gradientSpan", paint.gradientSpan);
    program->setUniformValue("objectRange", QVector2D(float(area.firstId), float(area.lastId)));
    gl.glScissor(area.covered.x(), area.covered.y(), area.covered.width(), area.covered.height());
    gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    program->release();
}

bool FrameDrawer::draw(Gl& gl, const ViewState& state, const std::string& key, QSize pixels, GLuint target,
                       GlPaints::Pending pending) {
    MethodDrawer& method = *m_methods.at(key);
    bool complete = m_paints.sync(gl, state, method.usesLevels(), pending);
    complete &= method.sync(gl, state, pending);
    const std::vector<MethodDrawer::Pass> passes = method.prepare(gl, state, m_paints, pixels);
    std::vector<std::size_t> order;
    for (const MethodDrawer::Pass& pass : passes) order.insert(order.end(), pass.begin(), pass.end());
    const std::vector<QRect> covered = m_gbuffer.draw(gl, state, order, pixels, method.usesFaces());

    clear(gl, state, pixels, target);
    gl.glEnable(GL_SCISSOR_TEST);
    gl.glEnable(GL_BLEND);
    gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    gl.glBindVertexArray(m_noAttributes);
    gl.glActiveTexture(GL_TEXTURE0 + MethodDrawer::SurfaceUnit);
    gl.glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, m_gbuffer.texture());
    gl.glActiveTexture(GL_TEXTURE0 + MethodDrawer::FaceUnit);
    gl.glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, method.usesFaces() ? m_gbuffer.faces() : 0);
    std::size_t first = 0;
    for (std::size_t pass = 0; pass < passes.size(); ++pass) {
        const std::size_t end = first + passes[pass].size();
        QRect together;
        for (std::size_t i = first; i < end; ++i) together |= covered[i];
        together.moveTop(pixels.height() - together.top() - together.height());
        const int sample = state.scene().objects[order[first]].sample;
        if (!together.isEmpty()) shade(gl, method, pass, sample, {first + 1, end, together});
        first = end;
    }
    gl.glDisable(GL_BLEND);
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glBindVertexArray(0);
    gl.glActiveTexture(GL_TEXTURE0);
    return complete;
}

}  // namespace chiaro::widgets
