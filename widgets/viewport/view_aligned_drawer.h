#pragma once

#include "widgets/viewport/method_drawer.h"

#include <map>

namespace chiaro::widgets {

/// Shades with the view-aligned 3D texture (§4.2): a pass for each group of objects that share a paint and a
/// filter.
class ViewAlignedDrawer : public MethodDrawer {
public:
    bool initialize(Gl& gl, int samples) override;
    void release(Gl& gl) override;
    bool usesLevels() const override { return true; }
    std::vector<Pass> prepare(Gl& gl, const ViewState& state, const GlPaints& paints, QSize pixels) override;
    QOpenGLShaderProgram* bind(Gl& gl, std::size_t pass, const GlPaints& paints) override;

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
    static Placed placed(const ViewState& state, std::size_t object, const GlPaints& paints, int height);
    static std::vector<Placed> placedObjects(const ViewState& state, const GlPaints& paints, int height);
    void uploadTable(Gl& gl, const std::vector<Placed>& objects);
    QOpenGLShaderProgram* programFor(const Filter& filter);

    int m_samples = 0;
    std::map<Filter, std::unique_ptr<QOpenGLShaderProgram>> m_programs;
    std::vector<Placed> m_representatives;  ///< one a pass
    GLuint m_tableBuffer = 0;
    GLuint m_table = 0;
};

}  // namespace chiaro::widgets
