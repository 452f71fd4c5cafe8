#include "core/project/collect.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/scene/side_files.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <fstream>
#include <list>
#include <map>
#include <set>

namespace chiaro::project {

namespace fs = std::filesystem;

namespace {

/// As file systems compare names that don't tell case apart, so that a collection may go to any of them.
std::string folded(const fs::path& path) {
    std::string text = path.generic_string();
    std::ranges::transform(text, text.begin(),
                           [](unsigned char letter) { return char(std::tolower(letter)); });
    return text;
}

bool isInside(const fs::path& file, const fs::path& folder) {
    const fs::path relative = file.lexically_relative(folder);
    return !relative.empty() && relative.is_relative() && *relative.begin() != "..";
}

/// Gives every file its place.
class Planner {
public:
    Planner(const Project& project, const fs::path& projectFile) {
        m_plan.projectFile = fs::absolute(projectFile).lexically_normal();
        m_plan.project = project;
        m_folder = m_plan.projectFile.parent_path();
        m_taken.insert(folded(m_plan.projectFile));
    }

    Collection plan() && {
        // What stays where it is has its place before others look for theirs.
        for (Sample& sample : m_plan.project.samples) keep(sample.scan);
        for (MeshFile& mesh : m_plan.project.meshes) keep(mesh.path);
        for (Sample& sample : m_plan.project.samples)
            place(sample.scan, [this](const fs::path& scan) { return placeScan(scan); });
        for (MeshFile& mesh : m_plan.project.meshes)
            place(mesh.path, [this](const fs::path& file) { return placeMesh(file); });
        return std::move(m_plan);
    }

private:
    void keep(const fs::path& file) {
        std::error_code ignored;
        if (!isInside(file, m_folder) || m_places.contains(file) || !fs::is_regular_file(file, ignored))
            return;
        m_places[file] = file;
        m_taken.insert(folded(file));
        for (const fs::path& side : scene::sideFiles(file)) m_taken.insert(folded(file.parent_path() / side));
    }

    template <class Place>
    void place(fs::path& file, Place choose) {
        if (file.empty()) return;
        std::error_code ignored;
        const auto known = m_places.find(file);
        if (known == m_places.end() && !fs::is_regular_file(file, ignored)) {
            if (std::ranges::find(m_plan.left, file) == m_plan.left.end()) m_plan.left.push_back(file);
            return;
        }
        if (known == m_places.end()) m_places[file] = choose(file);
        file = m_places.at(file);
    }

    /// The wanted place if it is free, else with a number behind the name.
    fs::path freePlace(const fs::path& wanted) {
        fs::path place = wanted;
        for (int number = 2; !m_taken.insert(folded(place)).second; ++number)
            place = wanted.parent_path() /
                    fmt::format("{} {}{}", wanted.stem().string(), number, wanted.extension().string());
        return place;
    }

    fs::path placeScan(const fs::path& scan) {
        const fs::path place = freePlace(m_folder / "scans" / scan.filename());
        m_plan.files.push_back({scan, place});
        return place;
    }

    fs::path placeMesh(const fs::path& mesh) {
        const std::vector<fs::path> sides = scene::sideFiles(mesh);
        if (sides.empty()) {
            const fs::path place = freePlace(m_folder / "meshes" / mesh.filename());
            m_plan.files.push_back({mesh, place});
            return place;
        }
        // It names them by their places relative to it: they keep them, in a folder of their own.
        const fs::path folder = freePlace(m_folder / "meshes" / mesh.stem());
        m_plan.files.push_back({mesh, folder / mesh.filename()});
        for (const fs::path& side : sides) m_plan.files.push_back({mesh.parent_path() / side, folder / side});
        return folder / mesh.filename();
    }

    Collection m_plan;
    fs::path m_folder;
    std::map<fs::path, fs::path> m_places;  ///< from where a file is to where it goes
    std::set<std::string> m_taken;
};

/// Folders that were made for files, and go away with it unless they are kept.
class MadeFolders {
public:
    ~MadeFolders() {
        std::error_code ignored;  // one that isn't empty stays
        for (auto folder = m_made.rbegin(); folder != m_made.rend(); ++folder) fs::remove(*folder, ignored);
    }
    void make(const fs::path& folder) {
        std::error_code error;
        if (fs::is_directory(folder, error)) return;
        if (folder.has_parent_path() && folder != folder.parent_path()) make(folder.parent_path());
        if (fs::create_directory(folder, error)) m_made.push_back(folder);
        if (error)
            throw Error(folder.string(), "could not be made (" + error.message() + ")",
                        "choose a folder you may write to");
    }
    void keep() { m_made.clear(); }

private:
    std::vector<fs::path> m_made;
};

void copy(const Collection::File& file, const fs::path& temporary, const Task& task) {
    std::ifstream in(file.from, std::ios::binary);
    if (!in)
        throw Error(file.from.string(), "could not be read", "check that it is there and its permissions");
    std::ofstream out(temporary, std::ios::binary);
    std::vector<char> bytes(std::size_t(1) << 20);
    while (out && in) {
        task.checkpoint();
        in.read(bytes.data(), std::streamsize(bytes.size()));
        out.write(bytes.data(), in.gcount());
    }
    if (in.bad()) throw Error(file.from.string(), "could not be read to its end", "check its disk");
    out.close();
    if (!out) throw Error(file.to.string(), "could not be written", "choose a folder that has space left");
}

}  // namespace

std::vector<fs::path> Collection::targets() const {
    std::vector<fs::path> targets;
    for (const File& file : files) targets.push_back(file.to);
    targets.push_back(projectFile);
    return targets;
}

Collection planCollection(const Project& project, const fs::path& projectFile) {
    return Planner(project, projectFile).plan();
}

void collectFiles(const Collection& collection, const Task& task) {
    refuseToReplaceNewer(collection.projectFile);
    MadeFolders folders;
    folders.make(collection.projectFile.parent_path());
    std::list<AtomicFile> written;
    const double share = 1 / double(collection.files.size() + 1);
    for (std::size_t i = 0; i < collection.files.size(); ++i) {
        const Collection::File& file = collection.files[i];
        task.report(share * double(i));
        folders.make(file.to.parent_path());
        const AtomicFile& copied = written.emplace_back(file.to);
        copy(file, copied.temporaryPath(), task);
        copied.flush();
    }
    written.emplace_back(collection.projectFile)
        .write(projectText(collection.projectFile, collection.project));
    for (AtomicFile& file : written) file.commit();
    folders.keep();
    task.report(1);
}

}  // namespace chiaro::project
