#include "core/base/task.h"

#include <algorithm>
#include <utility>

namespace chiaro {

Task::Task(std::stop_token stop, Progress progress) : m_stop(std::move(stop)) {
    if (!progress) return;
    m_reporter = std::make_shared<Reporter>();
    m_reporter->progress = std::move(progress);
}

void Task::checkpoint() const {
    if (cancelled()) throw Cancelled();
}

void Task::report(double fraction) const {
    if (!m_reporter) return;
    const double overall = m_begin + (m_end - m_begin) * std::clamp(fraction, 0.0, 1.0);
    const std::lock_guard lock(m_reporter->mutex);
    if (overall <= m_reporter->highest) return;
    m_reporter->highest = overall;
    m_reporter->progress(overall);
}

Task Task::part(double begin, double end) const {
    Task part = *this;
    part.m_begin = m_begin + (m_end - m_begin) * begin;
    part.m_end = m_begin + (m_end - m_begin) * end;
    return part;
}

void Task::Steps::done() {
    const std::size_t done = ++m_done;
    m_task.report(double(done) / double(m_count));
    m_task.checkpoint();
}

}  // namespace chiaro
