#include "core/project/backups.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>

namespace chiaro::project {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largestFile = 64 << 20;

fs::path backup(const fs::path& file, int number) {
    return fmt::format("{}{}", file.string(), number);
}

bool isSame(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    if (!fs::exists(b, ignored) || fs::file_size(a, ignored) != fs::file_size(b, ignored)) return false;
    try {
        return readFile(a, largestFile) == readFile(b, largestFile);
    } catch (const Error&) {
        return false;
    }
}

/// Who writes an atomic file under the temporary name .STEM.PROCESS-NUMBER-MACHINE.EXTENSION.
struct Writer {
    int process = 0;      ///< 0: it is no such name
    std::string machine;  ///< empty when the name doesn't tell
};

Writer writerOf(const fs::path& path, const fs::path& file) {
    const std::string name = path.stem().string(), start = fmt::format(".{}.", file.stem().string());
    if (!name.starts_with(start) || path.extension() != file.extension()) return {};
    const char* const last = name.data() + name.size();
    int process = 0, number = 0;
    const auto afterProcess = std::from_chars(name.data() + start.size(), last, process);
    if (afterProcess.ec != std::errc() || afterProcess.ptr == last || *afterProcess.ptr != '-') return {};
    const auto afterNumber = std::from_chars(afterProcess.ptr + 1, last, number);
    if (afterNumber.ec != std::errc()) return {};
    if (afterNumber.ptr == last) return {process, {}};
    return *afterNumber.ptr == '-' ? Writer{process, {afterNumber.ptr + 1, last}} : Writer{};
}

/// Whether its writer runs no more. Of a process on another machine that shares the folder only the time
/// tells: nobody writes a project for a day.
bool isLeftBehind(const Writer& writer, const fs::path& path) {
    if (writer.process <= 0) return false;
    if (writer.machine == thisMachine()) return ::kill(writer.process, 0) != 0 && errno == ESRCH;
    std::error_code error;
    const auto written = fs::last_write_time(path, error);
    return !error && fs::file_time_type::clock::now() - written > std::chrono::hours(24);
}

}  // namespace

void keepBackup(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error) || isSame(file, backup(file, 1))) return;
    // A second name for what is there: the file is replaced when it is saved, never written to.
    const fs::path fresh = backup(file, 0);
    fs::remove(fresh, error);
    fs::create_hard_link(file, fresh, error);
    if (error && !fs::copy_file(file, fresh, fs::copy_options::overwrite_existing, error)) {
        fs::remove(fresh, error);  // a part of it may be there
        return;
    }
    for (int number = keptBackups - 1; number >= 1; --number)
        fs::rename(backup(file, number), backup(file, number + 1), error);
    fs::rename(fresh, backup(file, 1), error);
}

std::vector<fs::path> backupsOf(const fs::path& file) {
    std::vector<fs::path> found;
    std::error_code ignored;
    for (int number = 1; number <= keptBackups; ++number)
        if (fs::is_regular_file(backup(file, number), ignored)) found.push_back(backup(file, number));
    return found;
}

void removeLeftovers(const fs::path& file) {
    std::error_code error;
    const fs::path folder = fs::absolute(file).parent_path();
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (!isLeftBehind(writerOf(entry.path(), file), entry.path())) continue;
        std::error_code ignored;
        fs::remove(entry.path(), ignored);
    }
}

}  // namespace chiaro::project
