#pragma once

#include "core/base/task.h"
#include "core/project/project.h"

#include <unordered_map>
#include <unordered_set>

namespace chiaro::project {

/// The names of the objects of each of a project's mesh files, in their order there; empty for a file that
/// can't be read.
using ObjectNames = std::vector<std::vector<std::string>>;

/// The settings of every object of the scene in the scene's order: file by file, as they come in the file;
/// those of one object of a file stay in the project's order. Objects that the project doesn't name get
/// settings of their own; those that their file doesn't have come last of their file.
std::vector<ObjectSettings> allObjects(const Project& project, const ObjectNames& names);

/// Gives names that no two objects share: the wanted one where it is free, else with the smallest number
/// behind it that is. Takes about as long for one object among many as among few.
class UniqueNames {
public:
    /// The names of these are taken.
    explicit UniqueNames(const std::vector<ObjectSettings>& objects);
    /// The name is taken from then on.
    std::string take(const std::string& wanted);

private:
    std::unordered_set<std::string> m_taken;
    std::unordered_map<std::string, int> m_next;  ///< number to try next for a name that was taken
};

/// The name that UniqueNames would give one more object.
std::string uniqueName(const std::string& wanted, const std::vector<ObjectSettings>& objects);

/// A file that a project names and that isn't there.
struct MissingFile {
    enum class Kind { Scan, Mesh };
    Kind kind = Kind::Scan;
    int index = 0;  ///< of the sample or the mesh file
    std::filesystem::path path;
    friend bool operator==(const MissingFile&, const MissingFile&) = default;
};
std::vector<MissingFile> missingFiles(const Project& project);
/// Takes another file in its place. Of other missing files, those with the same name as before and beside
/// the new one, or as far below it as they were, are found as well.
void relink(Project& project, const MissingFile& missing, const std::filesystem::path& found);
/// Finds missing files by their names in a folder or below; of several of a name that whose folders are
/// called most like those where it was. Looks at 200,000 entries at most. Throws Cancelled.
void relinkFrom(Project& project, const std::filesystem::path& folder, const Task& task = {});

}  // namespace chiaro::project
