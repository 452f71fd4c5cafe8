#include "core/base/helper/message.h"

#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace chiaro::helper {

namespace {

/// Room for one file handle beside the bytes.
struct Ancillary {
    alignas(cmsghdr) char bytes[CMSG_SPACE(sizeof(int))] = {};
};

}  // namespace

bool send(int socket, const Message& message) {
    if (message.bytes.size() > Message::maximumBytes) return false;
    auto kind = message.kind;
    iovec parts[] = {{&kind, sizeof kind}, {const_cast<char*>(message.bytes.data()), message.bytes.size()}};
    msghdr header{};
    header.msg_iov = parts;
    header.msg_iovlen = 2;
    Ancillary ancillary;
    if (message.memory) {
        header.msg_control = ancillary.bytes;
        header.msg_controllen = sizeof ancillary.bytes;
        cmsghdr* const control = CMSG_FIRSTHDR(&header);
        control->cmsg_level = SOL_SOCKET;
        control->cmsg_type = SCM_RIGHTS;
        control->cmsg_len = CMSG_LEN(sizeof(int));
        const int descriptor = message.memory.get();
        std::memcpy(CMSG_DATA(control), &descriptor, sizeof descriptor);
    }
    ssize_t sent = -1;
    do sent = ::sendmsg(socket, &header, MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    return sent == ssize_t(sizeof kind + message.bytes.size());
}

std::optional<Message> receive(int socket) {
    std::string buffer(1 + Message::maximumBytes, '\0');
    iovec part{buffer.data(), buffer.size()};
    Ancillary ancillary;
    msghdr header{};
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    header.msg_control = ancillary.bytes;
    header.msg_controllen = sizeof ancillary.bytes;
    ssize_t received = -1;
    do received = ::recvmsg(socket, &header, MSG_CMSG_CLOEXEC);
    while (received < 0 && errno == EINTR);
    if (received < 1) return std::nullopt;
    Message message;
    for (cmsghdr* control = CMSG_FIRSTHDR(&header); control; control = CMSG_NXTHDR(&header, control)) {
        if (control->cmsg_level != SOL_SOCKET || control->cmsg_type != SCM_RIGHTS) continue;
        int descriptor = -1;
        std::memcpy(&descriptor, CMSG_DATA(control), sizeof descriptor);
        message.memory = FileHandle(descriptor);
    }
    const auto kind = std::uint8_t(buffer[0]);
    if ((header.msg_flags & MSG_TRUNC) != 0 || kind > std::uint8_t(Message::Kind::OutOfMemory))
        return std::nullopt;
    message.kind = Message::Kind(kind);
    message.bytes = buffer.substr(1, std::size_t(received) - 1);
    return message;
}

}  // namespace chiaro::helper
