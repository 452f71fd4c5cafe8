#pragma once

#include "core/base/helper/shared_bytes.h"
#include "core/base/task.h"

#include <functional>
#include <string>

namespace chiaro::helper {

class PlainReader;

/// What a handler found: a few bytes, and sealed memory with the rest.
struct Finding {
    std::string bytes;
    FileHandle memory{};
};

/// Reads a file in the helper as the request says. Throws Error when the file can't be used.
using Handler = std::function<Finding(PlainReader& request, const Task& task)>;

/// Bytes as memory to hand over.
FileHandle sealed(const std::string& bytes);

}  // namespace chiaro::helper
