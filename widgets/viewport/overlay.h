#pragma once

#include "widgets/viewport/gl_support.h"
#include "widgets/viewport/view_state.h"

namespace chiaro::widgets {

/// Marks drawn over a finished frame, whatever its method: FrameDrawer keeps a list of them. They read what
/// they show from the state. Every call needs the context current.
class Overlay {
public:
    virtual ~Overlay() = default;
    /// False when the driver refuses; why is in the log.
    virtual bool initialize(Gl& gl) = 0;
    virtual void release(Gl& gl) = 0;
    /// Draws into the bound framebuffer of so many pixels, whose viewport is set. Its depth is cleared: an
    /// overlay that the scene may hide draws the scene's depth first. Blending, depth test and scissor are
    /// off, and are to be left so.
    virtual void draw(Gl& gl, const ViewState& state, QSize pixels) = 0;
};

}  // namespace chiaro::widgets
