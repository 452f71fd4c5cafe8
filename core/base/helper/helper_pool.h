#pragma once

#include "core/base/helper/helper_process.h"
#include "core/base/import.h"

#include <condition_variable>
#include <mutex>

namespace chiaro::helper {

/// The helpers that files are read in: started as they are needed, kept warm in between, several at once when
/// several files are read. Thread-safe.
class HelperPool {
public:
    /// Every import is cancelled once a stop is requested, whatever its task says.
    explicit HelperPool(ImportSettings settings, std::stop_token stop = {});
    ~HelperPool();

    /// Has a helper read a file. `request` is what the helper's program understands; errors name `file`.
    /// Throws Error when the file is refused, when reading it crashes, takes too long or too much memory, and
    /// when no helper can be started: what should be read in one is never read here instead. Throws
    /// Cancelled.
    Answer ask(const std::string& request, const std::filesystem::path& file, const Task& task);

    /// Of those that are waiting for work.
    std::vector<int> idleProcesses() const;

private:
    std::unique_ptr<HelperProcess> takeHelper(const Task& task);
    std::unique_ptr<HelperProcess> startHelper() const;
    void giveBack(std::unique_ptr<HelperProcess> helper);
    [[noreturn]] void tell(const Trouble& trouble, const std::filesystem::path& file) const;

    const ImportSettings m_settings;
    const std::stop_token m_stop;
    const std::size_t m_maximum;
    mutable std::mutex m_mutex;
    std::condition_variable m_returned;
    std::vector<std::unique_ptr<HelperProcess>> m_idle;
    std::size_t m_busy = 0;
};

}  // namespace chiaro::helper
