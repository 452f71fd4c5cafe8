#pragma once

#include "core/base/image.h"
#include "core/metrics/study.h"

#include <QObject>

#include <memory>
#include <vector>

namespace chiaro::app {

class JobRunner;
class Paints;

/// How the metric answers to known distortions (§5.1) of the built-in textures and of one of the artist's
/// strips, measured when it is asked to, in the background. Another strip ends it; what was found stays and
/// names its own.
class DistortionStudy : public QObject {
    Q_OBJECT

public:
    /// The jobs' slot that it works in.
    static constexpr const char* slot = "distortion study";

    DistortionStudy(JobRunner& jobs, Paints& paints, QObject* parent = nullptr);

    /// The sample to study besides the built-in textures; -1: none. Its name stands at its curves.
    void setSample(int sample, const QString& name);
    void start(const metrics::StudyParams& params = {});
    void cancel();
    bool isRunning() const { return m_job != 0; }
    double progress() const;  ///< in [0, 1]

    const std::vector<metrics::StudyPoint>& points() const { return m_points; }
    /// The strip has changed since, or another was chosen.
    bool isOutdated() const { return m_isOutdated; }
    /// Why the last one gave nothing; empty when it did, or was cancelled.
    const QString& problem() const { return m_problem; }

Q_SIGNALS:
    void changed();
    void progressed();

private:
    std::shared_ptr<const ColorImage> strip() const;
    void drop();

    JobRunner& m_jobs;
    Paints& m_paints;
    int m_sample = -1;
    QString m_name;
    std::vector<metrics::StudyPoint> m_points;
    bool m_isOutdated = false;
    QString m_problem;
    int m_job = 0;
};

}  // namespace chiaro::app
