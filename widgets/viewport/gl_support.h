#pragma once

#include "core/scene/camera.h"

#include <QtGui/qopengl.h>

#include <QMatrix4x4>
#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <QSurfaceFormat>

#include <memory>

namespace chiaro::widgets {

/// The functions every drawer calls; OpenGL 4.1 core.
using Gl = QOpenGLFunctions_4_1_Core;

/// What OpenGL offers here.
struct OpenGlSupport {
    bool usable = false;  ///< a 4.1 core context can be made and shown
    int samples = 0;      ///< a pixel: 8, or as many as there are
};

/// Asked once, without showing anything, by the GUI thread. The platforms without a screen count as having no
/// OpenGL: a QOpenGLWidget shown there crashes inside Qt.
const OpenGlSupport& openGlSupport();

/// From now on there is none, whatever the driver could: called before the first viewport is made.
void forbidOpenGl();

/// What the viewport's context is made with. Its framebuffer has one sample a pixel: GlGBuffer has more.
QSurfaceFormat openGlFormat();

/// A program from two files under shaders/, with `#define NAME VALUE` for each constant; null when the driver
/// refuses it (why is in the log). Needs a current context.
struct ShaderConstant {
    const char* name;
    int value;
};
std::unique_ptr<QOpenGLShaderProgram> makeProgram(const QString& vertex, const QString& fragment,
                                                  const std::vector<ShaderConstant>& constants = {});

/// A matrix as uniforms take it.
QMatrix4x4 qtMatrix(const glm::mat4& matrix);

}  // namespace chiaro::widgets
