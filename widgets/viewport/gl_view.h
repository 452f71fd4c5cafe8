#pragma once

#include "widgets/viewport/frame_drawer.h"
#include "widgets/viewport/gl_composition.h"
#include "widgets/viewport/view_state.h"

#include <QElapsedTimer>
#include <QImage>
#include <QOpenGLWidget>

namespace chiaro::widgets {

/// Draws a state by OpenGL. The context may be replaced at any time (floating a
/// dock does): everything is then uploaded again from the state.
class GlView : public QOpenGLWidget {
    Q_OBJECT

public:
    /// The state outlives the view.
    explicit GlView(ViewState& state, QWidget* parent = nullptr);
    ~GlView() override;

    /// The state as it is now, in device pixels.
    QImage picture();
    /// What each of the shown methods took in the last frame, ms.
    const std::vector<double>& methodTimes() const { return m_times; }
    /// The state's view texture is new: it fades in over the earlier one, where frames are quick enough for
    /// that to be seen.
    void fadeTexture();

Q_SIGNALS:
    void frameDrawn(double milliseconds);
    void failed();  ///< the driver refuses; why is in the log

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void releaseGl();
    void stepFade();
    bool drawMethods(QSize pixels);
    bool drawMethod(const std::string& method, QSize pixels, GLuint target);

    ViewState& m_state;
    Gl* m_gl = nullptr;  ///< the current context's, null when it can't draw
    FrameDrawer m_drawer;
    GlComposition m_compared;
    std::vector<double> m_times;
    QElapsedTimer m_fade;  ///< since the view texture is new
    double m_lastMilliseconds = 0;
    GlPaints::Pending m_pending = GlPaints::Pending::Show;
};

}  // namespace chiaro::widgets
