#pragma once

#include "core/base/helper/file_handle.h"

#include <cstdint>
#include <optional>
#include <string>

namespace chiaro::helper {

/// What a program and its helper say to each other over a socket that keeps messages apart.
struct Message {
    enum class Kind : std::uint8_t {
        Hello,        ///< helper: I run; the bytes tell what the system would not let me give up
        Request,      ///< program: the bytes are a request
        Begun,        ///< helper: I have the request
        Progress,     ///< helper: the fraction done, a double
        Answer,       ///< helper: the bytes, and sealed memory when there is more to tell
        Failure,      ///< helper: the sentence that the file is refused with
        OutOfMemory,  ///< helper: it takes more memory than I have
    };
    static constexpr std::size_t maximumBytes = 60'000;

    Kind kind = Kind::Hello;
    std::string bytes;    ///< at most maximumBytes
    FileHandle memory{};  ///< passed along with the bytes
};

/// False when the other side is gone or the message is too long.
bool send(int socket, const Message& message);

/// Waits for the next message. Empty when the other side is gone or speaks nonsense.
std::optional<Message> receive(int socket);

}  // namespace chiaro::helper
