#include "app/distortion_study.h"

#include "app/jobs/job_runner.h"
#include "app/paints.h"

#include <QtWidgets>

namespace chiaro::app {

DistortionStudy::DistortionStudy(JobRunner& jobs, Paints& paints, QObject* parent)
    : QObject(parent), m_jobs(jobs), m_paints(paints) {
    connect(&paints, &Paints::separationChanged, this, [this](int sample) {
        if (sample == m_sample) drop();
    });
    connect(&jobs, &JobRunner::progressed, this, [this] {
        if (m_job != 0) Q_EMIT progressed();
    });
}

void DistortionStudy::setSample(int sample, const QString& name) {
    m_sample = sample;
    m_name = name;
    drop();
}

void DistortionStudy::drop() {
    m_isOutdated = !m_points.empty();
    if (std::exchange(m_job, 0) != 0) {
        m_problem = tr("The strip changed while it was measured: measure again");
        m_jobs.supersede(slot);
    }
    Q_EMIT changed();
}

std::shared_ptr<const ColorImage> DistortionStudy::strip() const {
    const bool isKnown = m_sample >= 0 && m_sample < m_paints.sampleCount();
    const auto separated = isKnown ? m_paints.state(m_sample).separated : nullptr;
    return separated ? separated->strip : nullptr;
}

double DistortionStudy::progress() const {
    for (const JobRunner::JobInfo& job : m_jobs.jobs())
        if (job.number == m_job) return job.progress;
    return 0;
}

void DistortionStudy::start(const metrics::StudyParams& params) {
    m_problem.clear();
    m_job = m_jobs.start(
        {tr("Studying distortions"), slot,
         [this](const QString& message) {
             m_job = 0;
             m_problem = message;
             Q_EMIT changed();
         },
         [this] {
             m_job = 0;
             Q_EMIT changed();
         }},
        [strip = strip(), name = m_name.toStdString(), params](const Task& task) {
            std::vector<metrics::StudyTexture> textures = metrics::builtInTextures();
            if (strip) textures.push_back({name, *strip});
            return metrics::runStudy(textures, params, task);
        },
        [this](std::vector<metrics::StudyPoint> points) {
            m_job = 0;
            m_points = std::move(points);
            m_isOutdated = false;
            Q_EMIT changed();
        });
    Q_EMIT changed();
}

void DistortionStudy::cancel() {
    if (m_job != 0) m_jobs.cancel(m_job);
}

}  // namespace chiaro::app
