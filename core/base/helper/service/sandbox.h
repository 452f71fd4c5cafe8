#pragma once

#include <cstddef>
#include <string>

namespace chiaro::helper {

/// Gives up, for this process and for good, all that reading a file doesn't need: memory beyond `megabytes`,
/// core dumps, writing or creating files, the network, other processes and programs. Files may still be
/// opened for reading. Call it before there is a second thread. Returns what the system would not let it give
/// up, in words; empty when all went well.
std::string shutIn(std::size_t megabytes);

}  // namespace chiaro::helper
