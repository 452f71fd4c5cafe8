#pragma once

#include "core/methods/difference_texels.h"
#include "widgets/viewport/gl_support.h"

#include <QDeadlineTimer>

namespace chiaro::widgets {

/// Texels on their way to a GL_TEXTURE_3D, in pieces, so that no frame waits for hundreds of megabytes. It is
/// linear, and clamps at its edges. Every call needs the context current.
class TextureUpload {
public:
    /// Of a frame, that uploads may take, ms.
    static constexpr int frameMilliseconds = 10;

    /// Layer after layer, row after row; they have to stay until goOn() finished.
    TextureUpload(const methods::DifferenceTexel* texels, glm::ivec3 size) : m_texels(texels), m_size(size) {}

    /// One piece more, and others until the deadline. True once all is there, and bound.
    bool goOn(Gl& gl, QDeadlineTimer deadline);
    /// What goOn() finished; the caller deletes it.
    GLuint take() { return std::exchange(m_texture, 0); }
    /// Frees what was made so far.
    void cancel(Gl& gl);

private:
    void begin(Gl& gl);
    void addRows(Gl& gl);

    const methods::DifferenceTexel* m_texels;
    glm::ivec3 m_size;
    GLuint m_texture = 0;
    int m_row = 0;  ///< of all layers' rows, the next
};

}  // namespace chiaro::widgets
