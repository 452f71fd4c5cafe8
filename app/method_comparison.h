#pragma once

#include "app/change.h"
#include "core/base/parameters.h"
#include "core/project/comparison.h"
#include "core/project/texture_cache.h"

#include <QObject>

#include <memory>

namespace chiaro::app {

class Document;
class JobRunner;
class Meshes;

/// What the methods are compared on.
struct ComparisonSettings {
    /// What moves: the camera comes nearer, as `chiaro compare` has it; it goes around; or the timeline.
    enum class Movement { Approach, Turntable, Timeline };
    Movement movement = Movement::Approach;
    int frames = 8;          ///< measured from the first on
    int period = 48;         ///< frames in which a turntable goes around
    int size = 512;          ///< of every frame, px a side
    int seeds = 1;           ///< syntheses to average over
    int pixels = 1000;       ///< measured in each frame
    bool asReported = true;  ///< methods animate as in the report, not as the project says
    static const ParameterTable<ComparisonSettings>& table();
    friend bool operator==(const ComparisonSettings&, const ComparisonSettings&) = default;
};

/// What a comparison found, and on what.
struct Comparison {
    ComparisonSettings settings;
    scene::Path path;
    scene::View start;                          ///< the view that the path sets out from
    std::vector<project::MethodMeasure> table;  ///< without the pictures
};

/// Paints and measures an animation of the document by every method (§5), when it is asked to, in the
/// background. An edit meanwhile ends it, for the result would be of another project; a result that is there
/// stays, marked as outdated. Which method is shown, and the camera, make no difference to it.
class MethodComparison : public QObject {
    Q_OBJECT

public:
    /// The jobs' slot that it works in.
    static constexpr const char* slot = "comparison";

    MethodComparison(Document& document, JobRunner& jobs, Meshes& meshes, QObject* parent = nullptr);

    /// Where textures of objects' views are kept; nowhere without.
    void setCache(std::shared_ptr<const project::TextureCache> cache) { m_cache = std::move(cache); }

    /// False while there is no mesh, or no sample on it.
    bool canStart() const;
    /// Throws Error when a setting is out of range.
    void start(const ComparisonSettings& settings);
    void cancel();
    bool isRunning() const;
    double progress() const;  ///< in [0, 1]

    /// Null while there is none.
    const std::shared_ptr<const Comparison>& result() const { return m_result; }
    /// The project has changed since.
    bool isOutdated() const { return m_isOutdated; }
    /// Why the last one gave nothing; empty when it did, or was cancelled.
    const QString& problem() const { return m_problem; }

Q_SIGNALS:
    void changed();
    void progressed();

private:
    void applyChange(Change change);

    Document& m_document;
    JobRunner& m_jobs;
    Meshes& m_meshes;
    std::shared_ptr<const project::TextureCache> m_cache;
    std::shared_ptr<const Comparison> m_result;
    bool m_isOutdated = false;
    QString m_problem;
    ComparisonSettings::Movement m_movement{};  ///< of the last one begun
    int m_job = 0;
};

}  // namespace chiaro::app
