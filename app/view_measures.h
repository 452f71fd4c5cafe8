#pragma once

#include "app/measured_view.h"
#include "widgets/viewport/heat_overlay.h"
#include "widgets/viewport/view_snapshot.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace chiaro::app {

class JobRunner;
class Paints;

/// How well what the viewport shows resembles the strips (§5.1, §5.2): two figures from some pixels, and if
/// wanted maps of every pixel; of each method's picture where it compares several. Made in the background
/// once the picture rests; whatever changes it drops them.
///
/// The picture that is measured is core's, of what the viewport shows and as large: the light and the object
/// of each of its pixels are then exactly known, nothing is read back from the graphics card while the window
/// waits, and figures are the same with and without OpenGL, and those of the command line.
class ViewMeasures : public QObject {
    Q_OBJECT

public:
    /// The jobs' slot that it measures in.
    static constexpr const char* slot = "view measures";
    enum class Map { None, Similarity, Shading };
    /// Tells what the viewport shows: views that differ in their method alone. Called on the GUI thread.
    using Source = std::function<std::vector<widgets::ViewSnapshot>()>;

    using HeatMaps = std::vector<std::shared_ptr<const widgets::HeatMap>>;

    ViewMeasures(JobRunner& jobs, Paints& paints, Source source, QObject* parent = nullptr);

    /// Whether figures are wanted at all, and which map.
    void setLive(bool isLive);
    bool isLive() const { return m_isLive; }
    void setMap(Map map);
    Map map() const { return m_map; }

    /// Of the picture as it is now; none while it is not known, or where there is no such picture.
    std::optional<metrics::FrameMeasure> measure(std::size_t picture = 0) const;
    /// The wanted map; null while there is none. A coarse one comes first. Those of several pictures show the
    /// same values in the same colours.
    std::shared_ptr<const widgets::HeatMap> heatMap(std::size_t picture = 0) const;
    HeatMaps heatMaps() const;
    bool isMapFinal() const { return m_isMapFinal; }
    /// Why there are no figures: a sentence; else empty.
    const QString& problem() const { return m_problem; }
    /// Of the map that is being made, in [0, 1]; none: nothing is being made.
    std::optional<double> mapProgress() const;
    bool isWaiting() const { return m_rest.isActive(); }

public Q_SLOTS:
    /// The picture is another now.
    void restart();

Q_SIGNALS:
    void measureChanged();  ///< measure() or problem()
    void mapChanged();      ///< heatMap() or mapProgress()

private:
    struct Strip;
    struct Inputs;
    struct Prepared;
    struct Maps;
    using Rays = std::shared_ptr<const scene::RayScene>;

    bool isWanted() const { return m_isLive || m_map != Map::None; }
    std::optional<Inputs> inputs() const;
    void begin();
    void take(const std::shared_ptr<const Prepared>& prepared);
    void startMaps(int step);
    void fail(const QString& message);
    static std::shared_ptr<const Prepared> prepare(const Inputs& inputs, const Task& task);
    static std::shared_ptr<const Maps> makeMaps(const Prepared& prepared, int step, const Task& task);
    static HeatMaps heatMapsOf(const Prepared& prepared, const std::vector<ViewMaps>& found,
                               const QString& title, ScalarImage ViewMaps::*values);

    JobRunner& m_jobs;
    Paints& m_paints;
    Source m_source;
    bool m_isLive = false;
    Map m_map = Map::None;
    QTimer m_rest;
    std::shared_ptr<const Prepared> m_prepared;  ///< of the picture as it is now
    std::shared_ptr<const Maps> m_maps;
    bool m_isMapFinal = false;
    int m_mapJob = 0;  ///< its number; 0: none
    QString m_problem;
    /// Of the strips that were measured last, by their key. Each takes tens of MB, and a colour that is
    /// dragged makes many: no more are kept.
    std::map<std::uint64_t, std::shared_ptr<const metrics::NeighbourIndex>> m_indices;
    Rays m_rays;  ///< of the surfaces below
    scene::Scene m_raysScene;
};

}  // namespace chiaro::app
