#pragma once

#include "core/scene/gbuffer.h"
#include "widgets/viewport/view_state.h"

#include <QFutureWatcher>
#include <QImage>
#include <QTimer>
#include <QWidget>

#include <stop_token>

namespace chiaro::widgets {

/// Shows the CPU renderer's pictures of a state where there is no OpenGL: rendered in the background, first a
/// coarse one, then the fine one. A change during a rendering drops its fine picture and is rendered next;
/// the coarse one is always shown, so that the picture moves while the mouse does. Rays are cast once however
/// many methods are compared.
class CpuView : public QWidget {
    Q_OBJECT

public:
    /// The state outlives the view.
    explicit CpuView(ViewState& state, QWidget* parent = nullptr);
    ~CpuView() override;

    /// The state changed: renders it soon.
    void refresh();
    /// The methods' pictures are the same, but lie together otherwise.
    void recompose();
    /// The fine picture of the state as it is now, in device pixels; waits for it.
    QImage picture();
    /// What each of the shown methods took in the last fine picture, ms.
    const std::vector<double>& methodTimes() const { return m_times; }

Q_SIGNALS:
    void frameDrawn(double milliseconds);  ///< after the fine picture

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    using Rays = std::shared_ptr<const scene::RayScene>;
    struct Job;
    struct Result {
        Rays rays;
        std::vector<QImage> images;  ///< one a method
        std::vector<double> times;   ///< theirs, ms, each with the rays
        double milliseconds = 0;
        bool fine = false;
    };

    Job jobOfNow();
    void start();
    void take(int index);
    void show(const Result& result);
    static Result rendered(const Job& job, const Rays& rays, int coarseness, std::stop_token stop);
    static void run(QPromise<Result>& promise, const Job& job);

    ViewState& m_state;
    QTimer m_soon;  ///< gathers the changes of one turn of the event loop
    bool m_stale = false;
    QFutureWatcher<Result> m_watcher;
    std::stop_source m_stopFine;
    std::stop_source m_stopAll;
    scene::Scene m_raysScene;  ///< what m_rays holds, or what is being built
    Rays m_rays;
    std::vector<QImage> m_images;  ///< one a shown method, all of one size
    std::vector<double> m_times;
    QImage m_image;  ///< of them together
};

}  // namespace chiaro::widgets
