#pragma once

#include "widgets/viewport/gl_paints.h"
#include "widgets/viewport/gl_support.h"
#include "widgets/viewport/view_state.h"

#include <vector>

namespace chiaro::widgets {

/// How one method shades a frame whose G-buffer is drawn (§4): FrameDrawer draws that, binds what all methods
/// read, and lays the passes over each other. Every call needs the context current.
class MethodDrawer {
public:
    /// Objects that are shaded together, by index in the scene. They wear one sample.
    using Pass = std::vector<std::size_t>;

    virtual ~MethodDrawer() = default;
    /// With so many samples a pixel. False when the driver refuses; why is in the log.
    virtual bool initialize(Gl& gl, int samples) = 0;
    virtual void release(Gl& gl) = 0;
    /// Whether the paints' level stacks are needed.
    virtual bool usesLevels() const = 0;
    /// Whether the G-buffer is to tell faces.
    virtual bool usesFaces() const { return false; }
    /// Begins and goes on with uploads that take longer than a frame. False while they are on their way: call
    /// it again soon.
    virtual bool sync(Gl&, const ViewState&, GlPaints::Pending) { return true; }
    /// Uploads what else changed, and divides the objects that are drawn among passes over the picture.
    virtual std::vector<Pass> prepare(Gl& gl, const ViewState& state, const GlPaints& paints,
                                      QSize pixels) = 0;
    /// Binds the textures of a pass that prepare() gave and returns the bound program, whose uniforms
    /// `surfaces`, `faces`, `gradient`, `gradientSpan` and `objectRange` the caller sets; null when there is
    /// none.
    virtual QOpenGLShaderProgram* bind(Gl& gl, std::size_t pass, const GlPaints& paints) = 0;

    /// Texture units that the caller binds; a method's own begin at FirstOwnUnit.
    enum TextureUnit { SurfaceUnit, FaceUnit, GradientUnit, FirstOwnUnit };
};

}  // namespace chiaro::widgets
