#pragma once

#include "core/base/error.h"
#include "core/base/helper/plain_bytes.h"

#include <filesystem>

namespace chiaro::helper {

/// The beginning of a request that a handler of this name answers: the file by its absolute path, since a
/// helper may have been started in another folder.
inline PlainWriter fileRequest(const std::string& handler, const std::filesystem::path& file) {
    PlainWriter request;
    request.addText(handler);
    request.addText(std::filesystem::absolute(file).string());
    return request;
}

/// What the helper is taken to mean.
inline Error nonsense(const std::filesystem::path& file) {
    return Error(file.string(), "can't be read: its reader gave an answer without sense",
                 "the file may be damaged, so copy it or save it again");
}

/// The result of `understand`, which reads an answer; where that makes no sense, an Error that names the
/// file.
template <class Understand>
auto understood(const std::filesystem::path& file, Understand understand) {
    try {
        return understand();
    } catch (const Error&) {
        throw;
    } catch (const std::runtime_error&) {
        throw nonsense(file);
    }
}

}  // namespace chiaro::helper
