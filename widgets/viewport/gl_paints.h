#pragma once

#include "widgets/viewport/gl_support.h"
#include "widgets/viewport/view_state.h"

#include <map>

namespace chiaro::widgets {

/// The paints that a scene's objects wear, as textures: uploaded when they are others than in the last frame;
/// a new gradient alone costs its W texels. Every call needs the context current.
class GlPaints {
public:
    struct Paint {
        GLuint levels = 0;     ///< GL_TEXTURE_3D: s and t repeat, level i is centred at r = (i + 0.5) / count
        int size = 0;          ///< a level's side, texels
        QVector2D levelRange;  ///< difference = texel value * x + y
        GLuint gradient = 0;   ///< GL_TEXTURE_1D of W texels
        QVector2D
            gradientSpan;  ///< L * x + y is the coordinate in it: 0 the first texel's centre, 1 the last's
    };

    void sync(Gl& gl, const ViewState& state);
    const Paint& find(int sample) const { return m_entries.at(sample).paint; }
    void release(Gl& gl);

private:
    struct Entry {
        Paint paint;
        std::shared_ptr<const synthesis::LevelStack> levels;  ///< as uploaded
        gradient::Gradient gradient;                          ///< as uploaded
    };

    std::map<int, Entry> m_entries;
};

}  // namespace chiaro::widgets
