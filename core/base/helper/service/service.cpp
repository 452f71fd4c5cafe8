#include "core/base/helper/service/service.h"

#include "core/base/error.h"
#include "core/base/helper/child_process.h"
#include "core/base/helper/message.h"
#include "core/base/helper/plain_bytes.h"
#include "core/base/helper/service/sandbox.h"

#include <sys/socket.h>

#include <chrono>
#include <malloc.h>
#include <new>
#include <poll.h>
#include <thread>

namespace chiaro::helper {

namespace {

constexpr int socketHandle = ChildProcess::socketHandle;

bool isStartedAsHelper() {
    int type = 0;
    socklen_t size = sizeof type;
    return ::getsockopt(socketHandle, SOL_SOCKET, SO_TYPE, &type, &size) == 0 && type == SOCK_SEQPACKET;
}

/// However long a reader takes, the process ends with the program that wants the answer.
void endWithTheProgram() {
    std::thread([] {
        pollfd watched{socketHandle, POLLRDHUP, 0};
        while (::poll(&watched, 1, -1) < 0) {
        }
        ::_exit(0);
    }).detach();
}

/// A task that tells its progress, but not more often than anyone would see.
Task reportingTask() {
    std::chrono::steady_clock::time_point last{};
    return Task({}, [last](double fraction) mutable {
        const auto now = std::chrono::steady_clock::now();
        if (now - last < std::chrono::milliseconds(50)) return;
        last = now;
        PlainWriter bytes;
        bytes.add(fraction);
        send(socketHandle, {Message::Kind::Progress, bytes.take()});
    });
}

Message answerTo(const std::string& request, const std::map<std::string, Handler>& handlers) {
    try {
        PlainReader reader(request);
        Finding finding = handlers.at(reader.takeText())(reader, reportingTask());
        return {Message::Kind::Answer, std::move(finding.bytes), std::move(finding.memory)};
    } catch (const std::bad_alloc&) {
        return {Message::Kind::OutOfMemory, {}};
    } catch (const std::exception& problem) {
        return {Message::Kind::Failure, std::string(problem.what()).substr(0, 4000)};
    }
}

}  // namespace

int serve(std::size_t megabytes, const std::map<std::string, Handler>& handlers) {
    if (!isStartedAsHelper()) return 2;
    const std::string openDoors = shutIn(megabytes);
    endWithTheProgram();
    if (!send(socketHandle, {Message::Kind::Hello, openDoors})) return 0;
    while (const std::optional<Message> message = receive(socketHandle)) {
        if (message->kind != Message::Kind::Request) break;
        send(socketHandle, {Message::Kind::Begun, {}});
        if (!send(socketHandle, answerTo(message->bytes, handlers))) break;
        ::malloc_trim(0);  // it waits for the next file with as little as it can
    }
    ::_exit(0);  // libraries' threads may still run
}

}  // namespace chiaro::helper
