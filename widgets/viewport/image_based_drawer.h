#pragma once

#include "widgets/viewport/method_drawer.h"

namespace chiaro::widgets {

/// Shades with the image-based texture (§4.1): G(L) of this frame and the texture that was made last, which
/// each object takes along until there is one for this view, which fades in. A pass an object; a texture is
/// uploaded when it is another than in the last frame.
class ImageBasedDrawer : public MethodDrawer {
public:
    bool initialize(Gl& gl, int samples) override;
    void release(Gl& gl) override;
    bool usesLevels() const override { return false; }
    std::vector<Pass> prepare(Gl& gl, const ViewState& state, const GlPaints& paints, QSize pixels) override;
    QOpenGLShaderProgram* bind(Gl& gl, std::size_t pass, const GlPaints& paints) override;

private:
    /// A view texture in the graphics memory.
    struct Uploaded {
        std::shared_ptr<const ViewTexture> texture;
        std::vector<GLuint> texels;  ///< one an object
    };
    /// One object's texels on the screen, for the shader.
    struct Placed {
        GLuint texels = 0;
        QVector4D coordinates;  ///< OpenGL's pixels to s and t: factors, summands
        QVector2D range;        ///< difference = texel value * x + y, its weight included
    };
    using Layers = std::array<Placed, 2>;  ///< the texture, and the earlier one that it fades in over

    void upload(Gl& gl, const std::shared_ptr<const ViewTexture>& texture);
    Placed placed(const Uploaded& uploaded, std::size_t object, const methods::TexturePlacement& motion,
                  int height, float weight) const;
    static void freeTextures(Gl& gl, Uploaded& uploaded);

    std::array<std::unique_ptr<QOpenGLShaderProgram>, 2> m_programs;  ///< by the number of layers less one
    Uploaded m_shown;
    Uploaded m_earlier;  ///< what was shown before
    GLuint m_untextured = 0;
    bool m_isFading = false;
    std::vector<Layers> m_placed;  ///< one a pass
};

}  // namespace chiaro::widgets
