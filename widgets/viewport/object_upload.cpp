#include "widgets/viewport/object_upload.h"

namespace chiaro::widgets {

namespace {

template <class T>
void fillBuffer(Gl& gl, GLuint buffer, GLuint texture, GLenum format, const std::vector<T>& values) {
    gl.glBindBuffer(GL_TEXTURE_BUFFER, buffer);
    gl.glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
    gl.glBindTexture(GL_TEXTURE_BUFFER, texture);
    gl.glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
}

}  // namespace

void UploadedObject::free(Gl& gl) {
    gl.glDeleteTextures(1, &texels);
    gl.glDeleteTextures(BufferTextureCount, textures.data());
    gl.glDeleteBuffers(BufferTextureCount, buffers.data());
    *this = {};
}

void ObjectUpload::fillBuffers(Gl& gl) {
    gl.glGenBuffers(UploadedObject::BufferTextureCount, m_made.buffers.data());
    gl.glGenTextures(UploadedObject::BufferTextureCount, m_made.textures.data());
    const auto fill = [&](UploadedObject::BufferTexture which, GLenum format, const auto& values) {
        fillBuffer(gl, m_made.buffers[which], m_made.textures[which], format, values);
    };
    fill(UploadedObject::Corners, GL_RGB32F, m_texels->corners);
    fill(UploadedObject::FaceViews, GL_RG32UI, m_texels->faceViews);
    fill(UploadedObject::Weights, GL_RGBA16UI, m_texels->weights);
    fill(UploadedObject::Views, GL_RGBA32F, m_texels->views);
}

bool ObjectUpload::goOn(Gl& gl, QDeadlineTimer deadline) {
    m_made.layout = m_texels->layout;
    if (m_texels->layout.levelCount == 0) return true;
    if (!m_texture.goOn(gl, deadline)) return false;
    m_made.texels = m_texture.take();
    m_made.bytes = m_texels->textureBytes();
    fillBuffers(gl);
    return true;
}

void ObjectUpload::cancel(Gl& gl) {
    m_texture.cancel(gl);
    m_made.free(gl);
}

}  // namespace chiaro::widgets
