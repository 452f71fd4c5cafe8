#pragma once

#include "core/methods/object_texels.h"
#include "widgets/viewport/texture_upload.h"

#include <array>
#include <memory>

namespace chiaro::widgets {

/// An object's textures in the graphics memory.
struct UploadedObject {
    enum BufferTexture { Corners, FaceViews, Weights, Views, BufferTextureCount };

    GLuint texels = 0;
    std::array<GLuint, BufferTextureCount> buffers{};
    std::array<GLuint, BufferTextureCount> textures{};  ///< of those
    methods::ObjectTexels::Layout layout;
    std::size_t bytes = 0;  ///< of the texels

    void free(Gl& gl);
};

/// An object's texels on their way to the graphics memory, as TextureUpload; the buffers, which are some
/// bytes a face, come after the texture. Every call needs the context current.
class ObjectUpload {
public:
    explicit ObjectUpload(std::shared_ptr<const methods::ObjectTexels> texels)
        : m_texels(std::move(texels)), m_texture(m_texels->texels.data(), m_texels->layout.size) {}

    /// True once all is there; else to be called again in the next frame.
    bool goOn(Gl& gl, QDeadlineTimer deadline);
    /// What goOn() finished; the caller frees it.
    UploadedObject take() { return std::exchange(m_made, {}); }
    /// Frees what was made so far.
    void cancel(Gl& gl);

private:
    void fillBuffers(Gl& gl);

    std::shared_ptr<const methods::ObjectTexels> m_texels;
    TextureUpload m_texture;
    UploadedObject m_made;
};

}  // namespace chiaro::widgets
