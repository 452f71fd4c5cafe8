#pragma once

#include "widgets/viewport/method_drawer.h"

namespace chiaro::widgets {

/// Shades with the image-based texture (§4.1): G(L) of this frame and the texture that was made last, which
/// each object takes along until there is one for this view. A pass an object; a texture is uploaded when it
/// is another than in the last frame.
class ImageBasedDrawer : public MethodDrawer {
public:
    bool initialize(Gl& gl, int samples) override;
    void release(Gl& gl) override;
    bool usesLevels() const override { return false; }
    std::vector<Pass> prepare(Gl& gl, const ViewState& state, const GlPaints& paints, QSize pixels) override;
    QOpenGLShaderProgram* bind(Gl& gl, std::size_t pass, const GlPaints& paints) override;

private:
    struct Placed {
        GLuint texels = 0;
        QVector4D coordinates;  ///< OpenGL's pixels to s and t: factors, summands
    };

    void upload(Gl& gl, const std::shared_ptr<const ViewTexture>& texture);
    void freeTextures(Gl& gl);

    std::unique_ptr<QOpenGLShaderProgram> m_program;
    std::shared_ptr<const ViewTexture> m_texture;  ///< as uploaded
    std::vector<GLuint> m_texels;                  ///< one an object
    GLuint m_untextured = 0;                       ///< no difference anywhere
    QVector2D m_range;
    std::vector<Placed> m_placed;  ///< one a pass
};

}  // namespace chiaro::widgets
