#include "core/project/objects.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace chiaro::project {

namespace fs = std::filesystem;

UniqueNames::UniqueNames(const std::vector<ObjectSettings>& objects) {
    for (const ObjectSettings& object : objects) m_taken.insert(object.name);
}

std::string UniqueNames::take(const std::string& wanted) {
    std::string name = wanted;
    if (m_taken.contains(name)) {
        int& number = m_next.try_emplace(wanted, 2).first->second;
        while (m_taken.contains(name = fmt::format("{} {}", wanted, number))) ++number;
    }
    m_taken.insert(name);
    return name;
}

std::string uniqueName(const std::string& wanted, const std::vector<ObjectSettings>& objects) {
    return UniqueNames(objects).take(wanted);
}

namespace {

/// The settings that name objects of one mesh file, in the project's order.
struct FileSettings {
    std::vector<const ObjectSettings*> all;
    std::unordered_multimap<std::string, std::size_t> bySource;  ///< indices into `all`
};

std::vector<FileSettings> settingsByFile(const Project& project) {
    std::vector<FileSettings> files(project.meshes.size());
    for (const ObjectSettings& one : project.objects) {
        FileSettings& file = files[std::size_t(one.mesh)];
        file.bySource.emplace(one.sourceName(), file.all.size());
        file.all.push_back(&one);
    }
    return files;
}

}  // namespace

std::vector<ObjectSettings> allObjects(const Project& project, const ObjectNames& names) {
    const std::vector<FileSettings> files = settingsByFile(project);
    std::vector<ObjectSettings> all;
    UniqueNames unique(project.objects);
    for (std::size_t file = 0; file < files.size(); ++file) {
        const FileSettings& known = files[file];
        const MeshFile& mesh = project.meshes[file];
        const std::unordered_set<std::string> without(mesh.without.begin(), mesh.without.end());
        std::vector<bool> isThere(known.all.size(), false);
        const auto sources = file < names.size() ? names[file] : ObjectNames::value_type{};
        for (const std::string& source : sources) {
            std::vector<std::size_t> named;
            const auto [first, last] = known.bySource.equal_range(source);
            for (auto one = first; one != last; ++one) named.push_back(one->second);
            std::ranges::sort(named);
            for (const std::size_t one : named) {
                all.push_back(*known.all[one]);
                isThere[one] = true;
            }
            if (!named.empty() || without.contains(source)) continue;
            ObjectSettings& added = all.emplace_back();
            added.name = unique.take(source);
            if (added.name != source) added.source = source;
            added.mesh = int(file);
        }
        for (std::size_t one = 0; one < known.all.size(); ++one)
            if (!isThere[one]) all.push_back(*known.all[one]);
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

/// How many names, from the file's own upwards, two paths have in common.
int commonEnd(const fs::path& a, const fs::path& b) {
    const std::vector<fs::path> as(a.begin(), a.end()), bs(b.begin(), b.end());
    const auto [end, ignored] = std::mismatch(as.rbegin(), as.rend(), bs.rbegin(), bs.rend());
    return int(end - as.rbegin());
}

}  // namespace

void relinkFrom(Project& project, const fs::path& folder, const Task& task) {
    constexpr int mostEntries = 200'000;
    const std::vector<MissingFile> missing = missingFiles(project);
    std::vector<fs::path> found(missing.size());
    std::error_code error;
    int entries = 0;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(folder, options, error), end;
         !error && entry != end && entries < mostEntries; entry.increment(error), ++entries) {
        task.checkpoint();
        for (std::size_t i = 0; i < missing.size(); ++i) {
            const fs::path& wanted = missing[i].path;
            std::error_code ignored;
            if (entry->path().filename() != wanted.filename() || !entry->is_regular_file(ignored)) continue;
            if (commonEnd(entry->path(), wanted) > commonEnd(found[i], wanted)) found[i] = entry->path();
        }
    }
    for (std::size_t i = 0; i < missing.size(); ++i)
        if (!found[i].empty()) pathOf(project, missing[i]) = found[i];
}

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
