#pragma once

#include "core/base/helper/child_process.h"
#include "core/base/helper/shared_bytes.h"
#include "core/base/task.h"

#include <chrono>
#include <string>
#include <variant>

namespace chiaro::helper {

/// What a helper found: a few bytes, and memory with the rest.
struct Answer {
    std::string bytes;
    SharedBytes memory;
};

/// Why there is no answer.
struct Trouble {
    enum class Kind {
        Refused,      ///< the file can't be used: `text` is the sentence
        OutOfMemory,  ///< it takes more than the helper may have
        OutOfTime,
        Crashed,     ///< `text` tells how: "crashed (Segmentation fault)"
        NeverBegan,  ///< the helper was gone before it had the request: another one may have it
    };
    Kind kind = Kind::Crashed;
    std::string text;
};

/// One running helper, which answers one request after the other.
class HelperProcess {
public:
    /// Throws std::system_error when it can't be started.
    HelperProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);

    /// Waits for the answer. Throws Cancelled, at most a few hundredths of a second after the task was or a
    /// stop was requested; the helper is killed then, and after any trouble but Refused.
    std::variant<Answer, Trouble> ask(const std::string& request, const Task& task,
                                      const std::stop_token& stop, std::chrono::milliseconds limit);

    bool isUsable() const { return m_isUsable; }
    int id() const { return m_process.id(); }

private:
    struct Sockets {
        FileHandle ours, its;
        Sockets();
    };
    HelperProcess(Sockets sockets, const std::filesystem::path& program,
                  const std::vector<std::string>& arguments);
    /// False when the time is up.
    bool waitForMessage(const Task& task, const std::stop_token& stop,
                        std::chrono::steady_clock::time_point deadline);
    Trouble giveUp(Trouble::Kind kind);
    Trouble tellDeath(bool hadRequest);

    FileHandle m_socket;
    ChildProcess m_process;
    bool m_isUsable = true;
};

}  // namespace chiaro::helper
