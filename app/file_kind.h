#pragma once

#include <filesystem>

namespace chiaro::app {

/// What a file that an artist hands over is for.
enum class FileKind { Project, Strip, Mesh };

/// Told by the first bytes where they say it, else by the extension. Throws Error naming the file when it is
/// missing, unreadable or none of these.
FileKind fileKind(const std::filesystem::path& path);

}  // namespace chiaro::app
