#include "widgets/viewport/texture_upload.h"

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr std::size_t pieceBytes = std::size_t(2) << 20;

}  // namespace

void TextureUpload::begin(Gl& gl) {
    gl.glGenTextures(1, &m_texture);
    gl.glBindTexture(GL_TEXTURE_3D, m_texture);
    gl.glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, m_size.x, m_size.y, m_size.z, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    nullptr);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
}

/// Of one layer.
void TextureUpload::addRows(Gl& gl) {
    const std::size_t rowTexels = std::size_t(m_size.x);
    const int y = m_row % m_size.y;
    const int wanted = std::max(int(pieceBytes / (rowTexels * sizeof(methods::DifferenceTexel))), 1);
    const int count = std::min(wanted, m_size.y - y);
    gl.glTexSubImage3D(GL_TEXTURE_3D, 0, 0, y, m_row / m_size.y, m_size.x, count, 1, GL_RGBA,
                       GL_UNSIGNED_BYTE, m_texels + std::size_t(m_row) * rowTexels);
    m_row += count;
}

bool TextureUpload::goOn(Gl& gl, QDeadlineTimer deadline) {
    if (m_texture == 0) begin(gl);
    gl.glBindTexture(GL_TEXTURE_3D, m_texture);
    const int rows = m_size.y * m_size.z;
    do {
        if (m_row < rows) addRows(gl);
    } while (m_row < rows && !deadline.hasExpired());
    return m_row >= rows;
}

void TextureUpload::cancel(Gl& gl) {
    gl.glDeleteTextures(1, &m_texture);
    m_texture = 0;
}

}  // namespace chiaro::widgets
