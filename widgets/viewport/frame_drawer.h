#pragma once

#include "widgets/viewport/gl_gbuffer.h"
#include "widgets/viewport/method_drawer.h"

#include <map>
#include <string>

namespace chiaro::widgets {

/// Draws a state by any method: the picture of core's renderer to within 2/255 on average inside the objects.
/// First the G-buffer, then the passes of the method over the picture. Every call needs the context
/// current.
class FrameDrawer {
public:
    FrameDrawer();
    ~FrameDrawer();

    /// False when the driver refuses; why is in the log.
    bool initialize(Gl& gl);
    /// Fills the framebuffer `target` of so many pixels by one of drawnMethods(). False when it shows a paint
    /// that another is about to take the place of: draw again soon.
    bool draw(Gl& gl, const ViewState& state, const std::string& method, QSize pixels, GLuint target,
              GlPaints::Pending pending = GlPaints::Pending::Await);
    void release(Gl& gl);

private:
    /// The ids that a pass has in the G-buffer, and the pixels (y up) that it can cover.
    struct Area {
        std::size_t firstId = 1;
        std::size_t lastId = 0;
        QRect covered;
    };
    void clear(Gl& gl, const ViewState& state, QSize pixels, GLuint target);
    void shade(Gl& gl, MethodDrawer& method, std::size_t pass, int sample, const Area& area);

    GlGBuffer m_gbuffer;
    GlPaints m_paints;
    std::map<std::string, std::unique_ptr<MethodDrawer>> m_methods;  ///< by drawnMethods()
    GLuint m_noAttributes = 0;  ///< a vertex array, which drawing needs even without attributes
};

}  // namespace chiaro::widgets
