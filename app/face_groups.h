#pragma once

#include "widgets/viewport/view_snapshot.h"

#include <QImage>
#include <QObject>

namespace chiaro::widgets {
class Viewport;
}

namespace chiaro::app {

class JobRunner;
class ViewPlans;

/// A picture of the viewport's faces in the colours of the views that they belong to (§4.3.2), of several the
/// one that they face most: by core, in the background, a coarse one first; while the camera moves coarse ones
/// follow each other. Faces that no view took are left clear.
class FaceGroups : public QObject {
    Q_OBJECT

public:
    /// The jobs' slot that it works in.
    static constexpr const char* slot = "face groups";

    FaceGroups(JobRunner& jobs, ViewPlans& plans, widgets::Viewport& viewport, QObject* parent);

    void setWanted(bool isWanted);
    /// As large as a method's picture, or a quarter of that a side; null while there is none.
    const QImage& picture() const { return m_picture; }
    /// Of a view, by its number in the plan: as far as can be from those of its neighbours.
    static QColor colorOf(std::size_t group);

Q_SIGNALS:
    void pictureChanged();

private:
    struct Inputs;
    using Rays = std::shared_ptr<const scene::RayScene>;
    struct Made {
        QImage picture;
        Rays rays;
    };

    void refresh();
    void start(int step);
    void take(const Made& made);
    Inputs inputs() const;
    static Made make(const Inputs& inputs, int step, const Task& task);

    JobRunner& m_jobs;
    ViewPlans& m_plans;
    widgets::Viewport& m_viewport;
    bool m_isWanted = false;
    bool m_isStale = false;   ///< something changed since the running job began
    bool m_isCoarse = false;  ///< a coarse picture is on its way: it is shown whatever changes
    QImage m_picture;
    Rays m_rays;  ///< of the surfaces below
    scene::Scene m_raysScene;
};

}  // namespace chiaro::app
