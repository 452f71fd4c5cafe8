#pragma once

#include "core/base/task.h"
#include "core/project/project.h"

namespace chiaro::project {

/// A project and all that it needs, in one folder: what is to be copied where, and the project that names the
/// copies.
struct Collection {
    struct File {
        std::filesystem::path from;
        std::filesystem::path to;
    };
    std::filesystem::path projectFile;
    Project project;
    std::vector<File> files;                  ///< no two go to the same place
    std::vector<std::filesystem::path> left;  ///< that are missing; the project names them where they were
    std::vector<std::filesystem::path> targets() const;  ///< all that is written, the project last
};

/// Plans to collect a project as `projectFile`: scans go to scans/ beside it, meshes to meshes/, one with
/// side files (scene::sideFiles()) to a folder of its own below. What lies in the project's folder stays
/// where it is. Files of the same name get numbers. Writes nothing.
Collection planCollection(const Project& project, const std::filesystem::path& projectFile);

/// Copies and writes it: none of the files gets its name before all are whole and on the disk, the project
/// last; files that are there already are replaced. Throws Error, Cancelled; nothing is there then that was
/// not before.
void collectFiles(const Collection& collection, const Task& task = {});

}  // namespace chiaro::project
