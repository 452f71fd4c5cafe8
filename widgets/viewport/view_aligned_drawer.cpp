#include "widgets/viewport/view_aligned_drawer.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

enum TextureUnit { SurfaceUnit, GradientUnit, LevelUnit, TableUnit };

/// An octave that weighs less shifts no colour by a step of 1/255, as differences lie within [-1, 1] and are
/// mostly far from the ends: it is left out, which most frames of a turning object profit from.
constexpr float negligibleWeight = 1.0f / 64;
/// So little more than one texel on a pixel needs no second tap.
constexpr double negligibleExcess = 1.0 / 64;

struct PlacedOctave {
    glm::vec4 texel{
        0};  ///< factor, summands of s and t, tap step: see shaders/view_aligned/view_aligned.frag
    int taps = 1;
};

/// Screen position in OpenGL's pixels (y up) to s and t. The summands are kept in [0, 1), which the repeating
/// texture allows, so that far offsets cost no precision. Taps as in methods::viewAlignedTexture.
PlacedOctave placedOctave(glm::dvec2 offset, double texelsPerPixel, int size, int height) {
    const double factor = texelsPerPixel / size;
    const double s = -offset.x * factor;
    const double t = (height - offset.y) * factor;
    const int taps = texelsPerPixel <= 1 + negligibleExcess ? 1 : texelsPerPixel <= 2 ? 2 : 4;
    const double tapStep = taps == 1 ? 0 : (texelsPerPixel - 1) / (taps - 1) / size;
    return {glm::vec4(factor, s - std::floor(s), t - std::floor(t), tapStep), taps};
}

}  // namespace

bool ViewAlignedDrawer::initialize(Gl& gl) {
    release(gl);
    if (!m_gbuffer.initialize(gl) || !programFor({1, 0}) || !programFor({1, 2})) return false;
    gl.glGenVertexArrays(1, &m_noAttributes);
    gl.glGenBuffers(1, &m_tableBuffer);
    gl.glGenTextures(1, &m_table);
    return true;
}

void ViewAlignedDrawer::release(Gl& gl) {
    m_gbuffer.release(gl);
    m_paints.release(gl);
    m_programs.clear();
    gl.glDeleteVertexArrays(1, &m_noAttributes);
    gl.glDeleteBuffers(1, &m_tableBuffer);
    gl.glDeleteTextures(1, &m_table);
    m_noAttributes = m_tableBuffer = m_table = 0;
}

QOpenGLShaderProgram* ViewAlignedDrawer::programFor(const Filter& filter) {
    const auto [entry, isNew] = m_programs.try_emplace(filter);
    if (!isNew) return entry->second.get();
    entry->second = makeProgram("common/picture.vert", "view_aligned/view_aligned.frag",
                                {{"SAMPLES", m_gbuffer.samples()},
                                 {"OCTAVES", filter.nextTaps == 0 ? 1 : 2},
                                 {"TAPS", filter.taps},
                                 {"NEXT_TAPS", filter.nextTaps}});
    if (!entry->second) return nullptr;
    QOpenGLShaderProgram& program = *entry->second;
    program.bind();
    program.setUniformValue("surfaces", SurfaceUnit);
    program.setUniformValue("gradient", GradientUnit);
    program.setUniformValue("levels", LevelUnit);
    program.setUniformValue("placements", TableUnit);
    program.release();
    return &program;
}

ViewAlignedDrawer::Placed ViewAlignedDrawer::placed(const ViewState& state, std::size_t object,
                                                    int height) const {
    const methods::TexturePlacement& placement = state.placements()[object];
    const methods::ZoomOctaves octaves =
        methods::zoomOctaves(state.params.followZoom ? placement.zoom : 1.0f);
    const int sample = state.scene().objects[object].sample;
    const int size = m_paints.find(sample).size;
    const glm::dvec2 offset(placement.offset);
    PlacedOctave first = placedOctave(offset, double(octaves.scale) * state.params.density, size, height);
    PlacedOctave next = placedOctave(offset, double(octaves.nextScale) * state.params.density, size, height);
    glm::vec4 weights(octaves.weight, octaves.nextWeight, 0, 0);
    if (octaves.weight < negligibleWeight) {
        std::swap(first, next);
        std::swap(weights.x, weights.y);
    }
    const bool single = weights.y < negligibleWeight;
    return {object, sample, {first.taps, single ? 0 : next.taps}, {first.texel, next.texel, weights}};
}

std::vector<ViewAlignedDrawer::Placed> ViewAlignedDrawer::placedObjects(const ViewState& state,
                                                                        int height) const {
    std::vector<Placed> objects;
    for (std::size_t i = 0; i < state.scene().objects.size(); ++i)
        if (isDrawn(state.scene().objects[i])) objects.push_back(placed(state, i, height));
    std::ranges::stable_sort(objects, {},
                             [](const Placed& object) { return std::pair(object.sample, object.filter); });
    return objects;
}

void ViewAlignedDrawer::uploadTable(Gl& gl, const std::vector<Placed>& objects) {
    std::vector<glm::vec4> texels;
    for (const Placed& object : objects)
        texels.insert(texels.end(), object.texels.begin(), object.texels.end());
    gl.glBindBuffer(GL_TEXTURE_BUFFER, m_tableBuffer);
    gl.glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(texels.size() * sizeof(glm::vec4)), texels.data(),
                    GL_STREAM_DRAW);
    gl.glActiveTexture(GL_TEXTURE0 + TableUnit);
    gl.glBindTexture(GL_TEXTURE_BUFFER, m_table);
    gl.glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, m_tableBuffer);
}

void ViewAlignedDrawer::shade(Gl& gl, const Placed& representative, const Pass& pass) {
    QOpenGLShaderProgram* program = programFor(representative.filter);
    if (!program) return;
    const GlPaints::Paint& paint = m_paints.find(representative.sample);
    gl.glActiveTexture(GL_TEXTURE0 + GradientUnit);
    gl.glBindTexture(GL_TEXTURE_1D, paint.gradient);
    gl.glActiveTexture(GL_TEXTURE0 + LevelUnit);
    gl.glBindTexture(GL_TEXTURE_3D, paint.levels);
    program->bind();
    program->setUniformValue("objectRange", QVector2D(float(pass.firstId), float(pass.lastId)));
    program->setUniformValue("gradientSpan", paint.gradientSpan);
    program->setUniformValue("levelRange", paint.levelRange);
    gl.glScissor(pass.covered.x(), pass.covered.y(), pass.covered.width(), pass.covered.height());
    gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    program->release();
}

bool ViewAlignedDrawer::draw(Gl& gl, const ViewState& state, QSize pixels, GLuint target,
                             GlPaints::Pending pending) {
    const bool complete = m_paints.sync(gl, state, pending);
    const std::vector<Placed> objects = placedObjects(state, pixels.height());
    std::vector<std::size_t> order;
    for (const Placed& object : objects) order.push_back(object.object);
    const std::vector<QRect> covered = m_gbuffer.draw(gl, state, order, pixels);

    gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
    gl.glViewport(0, 0, pixels.width(), pixels.height());
    gl.glDisable(GL_DEPTH_TEST);
    gl.glClearColor(state.background.r, state.background.g, state.background.b, 1);
    gl.glClear(GL_COLOR_BUFFER_BIT);
    gl.glEnable(GL_SCISSOR_TEST);
    gl.glEnable(GL_BLEND);
    gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    gl.glBindVertexArray(m_noAttributes);
    uploadTable(gl, objects);
    gl.glActiveTexture(GL_TEXTURE0 + SurfaceUnit);
    gl.glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, m_gbuffer.texture());
    for (std::size_t first = 0; first < objects.size();) {
        std::size_t end = first;
        QRect together;
        for (; end < objects.size() && objects[end].sample == objects[first].sample &&
               objects[end].filter == objects[first].filter;
             ++end)
            together |= covered[end];
        together.moveTop(pixels.height() - together.top() - together.height());
        if (!together.isEmpty()) shade(gl, objects[first], {first + 1, end, together});
        first = end;
    }
    gl.glDisable(GL_BLEND);
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glBindVertexArray(0);
    gl.glActiveTexture(GL_TEXTURE0);
    return complete;
}

}  // namespace chiaro::widgets
