#include "core/base/helper/helper_process.h"

#include "core/base/helper/message.h"
#include "core/base/helper/plain_bytes.h"
#include "core/base/import.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>

#include <poll.h>
#include <system_error>

namespace chiaro::helper {

namespace {

using Clock = std::chrono::steady_clock;

/// How soon a cancelled task is heard.
constexpr std::chrono::milliseconds heartbeat{20};

/// Standard output belongs to results.
spdlog::logger& log() {
    static const auto logger = spdlog::stderr_logger_mt("chiaro-import");
    return *logger;
}

/// Told once a run: it is the same for every helper.
void tellOpenDoors(const std::string& doors) {
    static std::once_flag once;
    if (!doors.empty())
        std::call_once(once,
                       [&] { log().warn("files are read with less protection than usual: {}", doors); });
}

}  // namespace

HelperProcess::Sockets::Sockets() {
    int pair[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair) != 0)
        throw std::system_error(errno, std::generic_category(), "socket");
    ours = FileHandle(pair[0]);
    its = FileHandle(pair[1]);
}

HelperProcess::HelperProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments)
    : HelperProcess(Sockets(), program, arguments) {}

HelperProcess::HelperProcess(Sockets sockets, const std::filesystem::path& program,
                             const std::vector<std::string>& arguments)
    : m_socket(std::move(sockets.ours)), m_process(program, arguments, sockets.its) {}

bool HelperProcess::waitForMessage(const Task& task, const std::stop_token& stop,
                                   Clock::time_point deadline) {
    for (;;) {
        if (task.cancelled() || stop.stop_requested() || ImportsOfTask::cancelled()) {
            giveUp(Trouble::Kind::OutOfTime);
            throw Cancelled();
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0) return false;
        pollfd watched{m_socket.get(), POLLIN, 0};
        if (::poll(&watched, 1, int(std::min(left, heartbeat).count())) > 0) return true;
    }
}

Trouble HelperProcess::giveUp(Trouble::Kind kind) {
    m_isUsable = false;
    m_process.kill();
    return {kind, {}};
}

Trouble HelperProcess::tellDeath(bool hadRequest) {
    m_isUsable = false;
    m_socket.close();
    const std::string how = m_process.howItEnded();
    m_process.kill();
    return {hadRequest ? Trouble::Kind::Crashed : Trouble::Kind::NeverBegan, how};
}

std::variant<Answer, Trouble> HelperProcess::ask(const std::string& request, const Task& task,
                                                 const std::stop_token& stop,
                                                 std::chrono::milliseconds limit) {
    const Clock::time_point deadline = Clock::now() + limit;
    bool hasBegun = false;
    if (!send(m_socket.get(), {Message::Kind::Request, request})) return tellDeath(false);
    while (waitForMessage(task, stop, deadline)) {
        std::optional<Message> message = receive(m_socket.get());
        if (!message) return tellDeath(hasBegun);
        switch (message->kind) {
            case Message::Kind::Hello:
                tellOpenDoors(message->bytes);
                break;
            case Message::Kind::Begun:
                hasBegun = true;
                break;
            case Message::Kind::Progress:
                if (message->bytes.size() == sizeof(double))
                    task.report(std::clamp(PlainReader(message->bytes).take<double>(), 0.0, 1.0));
                break;
            case Message::Kind::Answer:
                try {
                    return Answer{std::move(message->bytes),
                                  message->memory ? SharedBytes(message->memory) : SharedBytes()};
                } catch (const std::runtime_error&) {
                    return giveUp(Trouble::Kind::Crashed);
                }
            case Message::Kind::Failure:
                return Trouble{Trouble::Kind::Refused, message->bytes};
            case Message::Kind::OutOfMemory:
                return giveUp(Trouble::Kind::OutOfMemory);
            case Message::Kind::Request:
                return giveUp(Trouble::Kind::Crashed);
        }
    }
    return giveUp(Trouble::Kind::OutOfTime);
}

}  // namespace chiaro::helper
