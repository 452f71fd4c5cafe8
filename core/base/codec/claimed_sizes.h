#pragma once

#include <filesystem>

namespace chiaro {

/// False when a part of the file claims more bytes than the file has: libraries allocate and fill them before
/// they notice. Of PNG the chunks, of OpenEXR the attributes of the first header and its number of rows.
bool pngChunksFit(const std::filesystem::path& path);
bool openExrHeaderFits(const std::filesystem::path& path);

}  // namespace chiaro
