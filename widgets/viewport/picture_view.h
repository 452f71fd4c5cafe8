#pragma once

#include "widgets/viewport/view_state.h"

#include <QImage>
#include <QWidget>

namespace chiaro::widgets {

class CpuView;
class GlView;

/// The picture of a state: OpenGL's, or the CPU renderer's where there is no OpenGL and while the scene has
/// what only that renderer casts.
class PictureView : public QWidget {
    Q_OBJECT

public:
    /// The state outlives the view.
    explicit PictureView(ViewState& state, QWidget* parent);
    ~PictureView() override;

    bool usesOpenGl() const;
    /// Why the CPU renders: a sentence; empty with OpenGL.
    QString note() const;

    /// The state changed.
    void refresh();
    /// Only how the methods' pictures lie together changed.
    void recompose();
    /// The state's view texture is new.
    void fadeTexture();

    /// All of it, in device pixels. Where the CPU renders, waits for the fine picture.
    QImage picture();
    /// What each shown method took in the last frame, ms.
    const std::vector<double>& methodTimes() const;

Q_SIGNALS:
    void frameDrawn(double milliseconds);
    void rendererChanged();  ///< usesOpenGl(), note()

private:
    void makeGlView();
    void makeCpuView();

    ViewState& m_state;
    GlView* m_glView = nullptr;    ///< null without OpenGL
    CpuView* m_cpuView = nullptr;  ///< null until it is needed
};

}  // namespace chiaro::widgets
