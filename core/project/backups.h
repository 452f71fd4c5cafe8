#pragma once

#include <filesystem>
#include <vector>

namespace chiaro::project {

/// Backups of NAME.chiaro lie beside it as NAME.chiaro1, the latest, to NAME.chiaro5, as Blender has them.
constexpr int keptBackups = 5;

/// Keeps the file as it is now as the latest backup and moves the others on, the oldest away. The file itself
/// is never moved: it is there at every moment. Does nothing when there is no file, or when the latest backup
/// is the same. Failing is no error: what is saved counts more than its backups.
void keepBackup(const std::filesystem::path& file);

/// The backups that there are, the latest first.
std::vector<std::filesystem::path> backupsOf(const std::filesystem::path& file);

/// Removes what programs that were killed amid writing this file left beside it; of those on other machines
/// that share the folder only what is older than a day.
void removeLeftovers(const std::filesystem::path& file);

}  // namespace chiaro::project
