#include "widgets/viewport/texture_upload.h"

#include "core/base/random.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <QtTest>

namespace chiaro::widgets {

namespace {

constexpr glm::ivec3 size(1000, 700, 3);

std::vector<methods::DifferenceTexel> someTexels() {
    std::vector<methods::DifferenceTexel> texels(std::size_t(size.x) * std::size_t(size.y) *
                                                 std::size_t(size.z));
    Random random(1);
    for (methods::DifferenceTexel& texel : texels)
        for (std::uint8_t& value : texel) value = std::uint8_t(random.below(256));
    return texels;
}

}  // namespace

/// Skipped, saying so, where there is no OpenGL.
class TextureUploadTest : public QObject {
    Q_OBJECT

    QOpenGLContext m_context;
    QOffscreenSurface m_surface;
    Gl* m_gl = nullptr;

private Q_SLOTS:
    void initTestCase() {
        if (!openGlSupport().usable) QSKIP("no OpenGL 4.1 here");
        m_context.setFormat(openGlFormat());
        m_surface.setFormat(m_context.format());
        m_surface.create();
        QVERIFY(m_context.create() && m_context.makeCurrent(&m_surface));
        m_gl = QOpenGLVersionFunctionsFactory::get<Gl>(&m_context);
    }

    void oneCallIsEnoughWithoutADeadline() {
        const std::vector<methods::DifferenceTexel> texels = someTexels();
        TextureUpload upload(texels.data(), size);
        QVERIFY(upload.goOn(*m_gl, QDeadlineTimer(QDeadlineTimer::Forever)));
        const GLuint texture = upload.take();
        m_gl->glDeleteTextures(1, &texture);
    }

    void piecesMakeTheWhole() {
        const std::vector<methods::DifferenceTexel> texels = someTexels();
        TextureUpload upload(texels.data(), size);
        int calls = 1;
        while (!upload.goOn(*m_gl, QDeadlineTimer(0))) ++calls;
        QVERIFY2(calls >= 4, "8.4 MB came in fewer frames than they may");
        const GLuint texture = upload.take();
        std::vector<methods::DifferenceTexel> read(texels.size());
        m_gl->glBindTexture(GL_TEXTURE_3D, texture);
        m_gl->glGetTexImage(GL_TEXTURE_3D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
        QVERIFY(read == texels);
        QCOMPARE(m_gl->glGetError(), GLenum(GL_NO_ERROR));
        m_gl->glDeleteTextures(1, &texture);
    }

    void nothingIsLeftOfOneThatIsCancelled() {
        const std::vector<methods::DifferenceTexel> texels = someTexels();
        TextureUpload upload(texels.data(), size);
        QVERIFY(!upload.goOn(*m_gl, QDeadlineTimer(0)));
        GLint bound = 0;
        m_gl->glGetIntegerv(GL_TEXTURE_BINDING_3D, &bound);
        QVERIFY(m_gl->glIsTexture(GLuint(bound)));
        upload.cancel(*m_gl);
        QVERIFY(!m_gl->glIsTexture(GLuint(bound)));
        QCOMPARE(upload.take(), 0U);
    }
};

}  // namespace chiaro::widgets

QTEST_MAIN(chiaro::widgets::TextureUploadTest)
#include "texture_upload_test.moc"
