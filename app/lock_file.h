#pragma once

#include <QLockFile>

#include <filesystem>
#include <memory>

namespace chiaro::app {

/// A lock that is not taken yet. It goes stale when its process runs no more, however old it is; one of
/// another machine never does.
std::unique_ptr<QLockFile> lockAt(const std::filesystem::path& file);

}  // namespace chiaro::app
