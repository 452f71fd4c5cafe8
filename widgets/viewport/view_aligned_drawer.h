#pragma once

#include "widgets/viewport/gl_gbuffer.h"
#include "widgets/viewport/gl_paints.h"

#include <map>

namespace chiaro::widgets {

/// Draws a state with the view-aligned 3D texture (§4.2): the picture of methods::renderViewAligned to within
/// 2/255 on average inside the objects. First the G-buffer, then a pass over the picture for each group of
/// objects that share a paint and a filter. Every call needs the context current.
class ViewAlignedDrawer {
public:
    /// False when the driver refuses; why is in the log.
    bool initialize(Gl& gl);
    /// Fills the framebuffer `target` of so many pixels. False when it shows a paint that another is about to
    /// take the place of: draw again soon.
    bool draw(Gl& gl, const ViewState& state, QSize pixels, GLuint target,
              GlPaints::Pending pending = GlPaints::Pending::Await);
    void release(Gl& gl);

private:
    /// What the shader is compiled for: taps a side of each octave; 0 where there is no second.
    struct Filter {
        int taps = 1;
        int nextTaps = 0;
        auto operator<=>(const Filter&) const = default;
    };
    /// One object's texture on the screen, for the shader: three texels of the table.
    struct Placed {
        std::size_t object = 0;  ///< index in the scene
        int sample = 0;
        Filter filter;
        std::array<glm::vec4, 3> texels{};
    };
    /// Objects shaded in one pass.
    struct Pass {
        std::size_t firstId = 1;  ///< in the G-buffer
        std::size_t lastId = 0;
        QRect covered;  ///< pixels that they can cover, y up
    };

    Placed placed(const ViewState& state, std::size_t object, int height) const;
    std::vector<Placed> placedObjects(const ViewState& state, int height) const;
    void uploadTable(Gl& gl, const std::vector<Placed>& objects);
    void shade(Gl& gl, const Placed& representative, const Pass& pass);
    QOpenGLShaderProgram* programFor(const Filter& filter);

    GlGBuffer m_gbuffer;
    GlPaints m_paints;
    std::map<Filter, std::unique_ptr<QOpenGLShaderProgram>> m_programs;
    GLuint m_noAttributes = 0;  ///< a vertex array, which drawing needs even without attributes
    GLuint m_tableBuffer = 0;
    GLuint m_table = 0;
};

}  // namespace chiaro::widgets
