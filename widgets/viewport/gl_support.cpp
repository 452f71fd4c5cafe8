#include "widgets/viewport/gl_support.h"

#include <QFile>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <algorithm>

/// The shaders lie in a static library, whose resources register only when asked; outside any namespace, as
/// the macro demands.
static void registerShaders() {
    Q_INIT_RESOURCE(shaders);
}

namespace chiaro::widgets {

namespace {

/// The text of a file under shaders/: the constants after its version line, the files that it includes in
/// their places.
QByteArray shaderSource(const QString& name, const std::vector<ShaderConstant>& constants) {
    QFile file(":/shaders/" + name);
    if (!file.open(QIODevice::ReadOnly)) qFatal("no shader %s", qPrintable(name));
    QByteArray source;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine();
        if (line.startsWith("#include \""))
            source += shaderSource(QString::fromUtf8(line.split('"').at(1)), {});
        else
            source += line;
        if (!line.startsWith("#version")) continue;
        for (const auto& [constant, value] : constants)
            source += "#define " + QByteArray(constant) + " " + QByteArray::number(value) + "\n";
    }
    return source;
}

bool isOpenGlForbidden = false;

OpenGlSupport probe() {
    if (isOpenGlForbidden) return {};
    const QString platform = QGuiApplication::platformName();
    if (platform == "offscreen" || platform == "minimal") return {};
    QOpenGLContext context;
    context.setFormat(openGlFormat());
    if (!context.create() || context.format().version() < qMakePair(4, 1)) return {};
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!context.makeCurrent(&surface)) return {};
    GLint samples = 0;
    context.functions()->glGetIntegerv(GL_MAX_SAMPLES, &samples);
    context.doneCurrent();
    return {true, std::min(samples, 8)};
}

}  // namespace

void forbidOpenGl() {
    isOpenGlForbidden = true;
}

const OpenGlSupport& openGlSupport() {
    static const OpenGlSupport support = probe();
    return support;
}

QSurfaceFormat openGlFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

std::unique_ptr<QOpenGLShaderProgram> makeProgram(const QString& vertex, const QString& fragment,
                                                  const std::vector<ShaderConstant>& constants) {
    registerShaders();
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const bool made =
        program->addShaderFromSourceCode(QOpenGLShader::Vertex, shaderSource(vertex, constants)) &&
        program->addShaderFromSourceCode(QOpenGLShader::Fragment, shaderSource(fragment, constants)) &&
        program->link();
    return made ? std::move(program) : nullptr;
}

QMatrix4x4 qtMatrix(const glm::mat4& matrix) {
    return QMatrix4x4(&matrix[0][0]).transposed();
}

}  // namespace chiaro::widgets
