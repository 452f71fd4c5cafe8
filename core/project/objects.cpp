#include "core/project/objects.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>

namespace chiaro::project {

namespace fs = std::filesystem;

std::string uniqueName(const std::string& wanted, const std::vector<ObjectSettings>& objects) {
    const auto isTaken = [&](const std::string& name) {
        return std::ranges::find(objects, name, &ObjectSettings::name) != objects.end();
    };
    std::string name = wanted;
    for (int number = 2; isTaken(name); ++number) name = fmt::format("{} {}", wanted, number);
    return name;
}

std::vector<ObjectSettings> allObjects(const Project& project, const ObjectNames& names) {
    std::multimap<std::pair<int, std::string>, const ObjectSettings*> named;
    for (const ObjectSettings& one : project.objects)
        named.emplace(std::pair(one.mesh, one.sourceName()), &one);
    std::vector<ObjectSettings> all, taken = project.objects;
    for (int file = 0; file < int(project.meshes.size()); ++file) {
        const auto& sources =
            std::size_t(file) < names.size() ? names[std::size_t(file)] : ObjectNames::value_type{};
        for (const std::string& source : sources) {
            const auto [first, last] = named.equal_range({file, source});
            for (auto one = first; one != last; ++one) all.push_back(*one->second);
            const auto& without = project.meshes[std::size_t(file)].without;
            if (first != last || std::ranges::find(without, source) != without.end()) continue;
            ObjectSettings& added = all.emplace_back();
            added.name = uniqueName(source, taken);
            if (added.name != source) added.source = source;
            added.mesh = file;
            taken.push_back(added);
        }
        for (const std::string& source : sources) named.erase({file, source});
        for (const ObjectSettings& one : project.objects)
            if (one.mesh == file && named.contains({file, one.sourceName()})) all.push_back(one);
    }
    return all;
}

std::vector<MissingFile> missingFiles(const Project& project) {
    std::vector<MissingFile> missing;
    std::error_code ignored;
    for (std::size_t i = 0; i < project.samples.size(); ++i)
        if (const fs::path& scan = project.samples[i].scan; !fs::is_regular_file(scan, ignored))
            missing.push_back({MissingFile::Kind::Scan, int(i), scan});
    for (std::size_t i = 0; i < project.meshes.size(); ++i)
        if (const fs::path& mesh = project.meshes[i].path; !fs::is_regular_file(mesh, ignored))
            missing.push_back({MissingFile::Kind::Mesh, int(i), mesh});
    return missing;
}

namespace {

fs::path& pathOf(Project& project, const MissingFile& file) {
    const auto index = std::size_t(file.index);
    return file.kind == MissingFile::Kind::Scan ? project.samples[index].scan : project.meshes[index].path;
}

}  // namespace

void relink(Project& project, const MissingFile& missing, const fs::path& found) {
    pathOf(project, missing) = found;
    std::error_code ignored;
    for (const MissingFile& other : missingFiles(project)) {
        const fs::path relative = other.path.lexically_relative(missing.path.parent_path());
        for (const fs::path& candidate : {(found.parent_path() / relative).lexically_normal(),
                                          found.parent_path() / other.path.filename()})
            if (fs::is_regular_file(candidate, ignored)) {
                pathOf(project, other) = candidate;
                break;
            }
    }
}

}  // namespace chiaro::project
