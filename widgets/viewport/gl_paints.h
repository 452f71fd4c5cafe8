#pragma once

#include "core/methods/level_texels.h"
#include "widgets/viewport/gl_support.h"
#include "widgets/viewport/texture_upload.h"
#include "widgets/viewport/view_state.h"

#include <QFuture>

#include <map>
#include <optional>

namespace chiaro::widgets {

/// The paints that a scene's objects wear, as textures: uploaded when they are others than in the last frame;
/// a new gradient alone costs its W texels. Levels are made into texels by another thread and uploaded over
/// as many frames as that takes, so that a large stack does not hold up the window. Every call needs the
/// context current.
class GlPaints {
public:
    struct Paint {
        GLuint levels = 0;  ///< GL_TEXTURE_3D, 0 until a method used it: s and t repeat, level i is centred
                            ///< at r = (i + 0.5) / count
        int size = 0;       ///< a level's side, texels
        QVector2D levelRange;  ///< difference = texel value * x + y
        GLuint gradient = 0;   ///< GL_TEXTURE_1D of W texels
        QVector2D
            gradientSpan;  ///< L * x + y is the coordinate in it: 0 the first texel's centre, 1 the last's
    };

    /// What to do about levels that are not texels yet.
    enum class Pending {
        Show,  ///< go on with what there was: the levels before, or none
        Await
    };
    /// Levels only for a method that uses them: otherwise they stay as they were. False while levels are on
    /// their way: call it again soon.
    bool sync(Gl& gl, const ViewState& state, bool usesLevels, Pending pending);
    const Paint& find(int sample) const { return m_entries.at(sample).paint; }
    void release(Gl& gl);

private:
    struct Entry {
        Paint paint;
        std::shared_ptr<const synthesis::LevelStack> levels;          ///< as uploaded, or on their way
        QFuture<std::shared_ptr<const methods::LevelTexels>> texels;  ///< valid while they are
        std::optional<TextureUpload> upload;                          ///< of those, once they are made
        gradient::Gradient gradient;                                  ///< as uploaded
    };

    static void syncGradient(Gl& gl, Entry& entry, const gradient::Gradient& gradient);
    static void startLevels(Gl& gl, Entry& entry, const std::shared_ptr<const synthesis::LevelStack>& levels);
    static bool finishLevels(Gl& gl, Entry& entry, Pending pending, QDeadlineTimer deadline);
    static void showLevels(Gl& gl, Entry& entry, const methods::LevelTexels& texels, GLuint texture);
    static void drop(Gl& gl, Entry& entry);
    static void free(Gl& gl, Entry& entry);

    std::map<int, Entry> m_entries;
};

}  // namespace chiaro::widgets
