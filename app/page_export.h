#pragma once

#include "app/picture_export.h"

namespace chiaro::app {

/// Writes a relightable page of the source's scene, which begins in its view and light, and replaces what is
/// there. Textures come from the disk's cache if it has them. Throws Error, Cancelled.
void exportPage(const PictureSource& source, const std::filesystem::path& path, const Task& task);

}  // namespace chiaro::app
