#pragma once

#include "widgets/viewport/composition.h"
#include "widgets/viewport/gl_support.h"

#include <array>
#include <vector>

namespace chiaro::widgets {

/// The pictures of several methods in the graphics memory, and how they become one, as composed() does it: to
/// within 1/255 a channel. A picture takes four bytes a pixel; nothing else is kept twice, since all are
/// drawn by one FrameDrawer. Every call needs the context current.
class GlComposition {
public:
    /// False when the driver refuses; why is in the log.
    bool initialize(Gl& gl);
    void release(Gl& gl);

    /// Room for so many pictures of a size; frees the rest.
    void reserve(Gl& gl, std::size_t count, QSize pixels);
    /// The framebuffer to draw a picture into.
    GLuint target(std::size_t picture) const { return m_pictures[picture].framebuffer; }
    /// Shows the reserved pictures in the framebuffer `target` of this size, over `ground`.
    void show(Gl& gl, const Composition& composition, QSize pixels, double ratio, glm::vec3 ground,
              GLuint target);

private:
    struct Picture {
        GLuint framebuffer = 0;
        GLuint texture = 0;
    };
    void place(Gl& gl, const std::vector<QRect>& panes, QSize pixels, GLuint target) const;
    void combine(Gl& gl, const Composition& composition, QSize pixels);
    void free(Gl& gl);

    std::array<std::unique_ptr<QOpenGLShaderProgram>, 3> m_programs;  ///< wipe, blend, difference
    std::vector<Picture> m_pictures;
    QSize m_size;
    GLuint m_noAttributes = 0;
};

}  // namespace chiaro::widgets
