#pragma once

#include <filesystem>

namespace chiaro::exporting {

/// Whether a video file (MP4, WebM or Matroska) is as long as its parts say, down to the last byte. Encoders
/// hide writes that fail, and players forgive a file whose end is missing, so that frames alone don't tell.
bool isWholeContainer(const std::filesystem::path& path);

}  // namespace chiaro::exporting
