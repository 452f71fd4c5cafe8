#pragma once

#include "widgets/viewport/frame_drawer.h"
#include "widgets/viewport/view_state.h"

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

Q_SIGNALS:
    void frameDrawn(double milliseconds);
    void failed();  ///< the driver refuses; why is in the log

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void releaseGl();

    ViewState& m_state;
    Gl* m_gl = nullptr;  ///< the current context's, null when it can't draw
    FrameDrawer m_drawer;
    GlPaints::Pending m_pending = GlPaints::Pending::Show;
};

}  // namespace chiaro::widgets
