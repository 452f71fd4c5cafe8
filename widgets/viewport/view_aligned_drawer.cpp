#include "widgets/viewport/view_aligned_drawer.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

enum OwnUnit { LevelUnit = MethodDrawer::FirstOwnUnit, TableUnit };

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

bool ViewAlignedDrawer::initialize(Gl& gl, int samples) {
    m_samples = samples;
    gl.glGenBuffers(1, &m_tableBuffer);
    gl.glGenTextures(1, &m_table);
    return programFor({1, 0}) && programFor({1, 2});
}

void ViewAlignedDrawer::release(Gl& gl) {
    m_programs.clear();
    gl.glDeleteBuffers(1, &m_tableBuffer);
    gl.glDeleteTextures(1, &m_table);
    m_tableBuffer = m_table = 0;
}

QOpenGLShaderProgram* ViewAlignedDrawer::programFor(const Filter& filter) {
    const auto [entry, isNew] = m_programs.try_emplace(filter);
    if (!isNew) return entry->second.get();
    entry->second = makeProgram("common/picture.vert", "view_aligned/view_aligned.frag",
                                {{"SAMPLES", m_samples},
                                 {"OCTAVES", filter.nextTaps == 0 ? 1 : 2},
                                 {"TAPS", filter.taps},
                                 {"NEXT_TAPS", filter.nextTaps}});
    if (!entry->second) return nullptr;
    QOpenGLShaderProgram& program = *entry->second;
    program.bind();
    program.setUniformValue("levels", LevelUnit);
    program.setUniformValue("placements", TableUnit);
    program.release();
    return &program;
}

ViewAlignedDrawer::Placed ViewAlignedDrawer::placed(const ViewState& state, std::size_t object,
                                                    const GlPaints& paints, int height) {
    const methods::TexturePlacement& placement = state.placements()[object];
    const methods::ZoomOctaves octaves =
        methods::zoomOctaves(state.params.followZoom ? placement.zoom : 1.0f);
    const int sample = state.scene().objects[object].sample;
    const int size = paints.find(sample).size;
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
                                                                        const GlPaints& paints, int height) {
    std::vector<Placed> objects;
    for (std::size_t i = 0; i < state.scene().objects.size(); ++i)
        if (isDrawn(state.scene().objects[i])) objects.push_back(placed(state, i, paints, height));
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

std::vector<MethodDrawer::Pass> ViewAlignedDrawer::prepare(Gl& gl, const ViewState& state,
                                                           const GlPaints& paints, QSize pixels) {
    const std::vector<Placed> objects = placedObjects(state, paints, pixels.height());
    uploadTable(gl, objects);
    std::vector<Pass> passes;
    m_representatives.clear();
    for (const Placed& object : objects) {
        const bool joins = !passes.empty() && object.sample == m_representatives.back().sample &&
                           object.filter == m_representatives.back().filter;
        if (!joins) {
            passes.emplace_back();
            m_representatives.push_back(object);
        }
        passes.back().push_back(object.object);
    }
    return passes;
}

QOpenGLShaderProgram* ViewAlignedDrawer::bind(Gl& gl, std::size_t pass, const GlPaints& paints) {
    const Placed& representative = m_representatives[pass];
    QOpenGLShaderProgram* program = programFor(representative.filter);
    if (!program) return nullptr;
    const GlPaints::Paint& paint = paints.find(representative.sample);
    gl.glActiveTexture(GL_TEXTURE0 + LevelUnit);
    gl.glBindTexture(GL_TEXTURE_3D, paint.levels);
    gl.glActiveTexture(GL_TEXTURE0 + TableUnit);
    gl.glBindTexture(GL_TEXTURE_BUFFER, m_table);
    program->bind();
    program->setUniformValue("levelRange", paint.levelRange);
    return program;
}

}  // namespace chiaro::widgets
