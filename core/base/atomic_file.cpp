#include "core/base/atomic_file.h"

#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <list>
#include <map>
#include <regex>
#include <set>
#include <unistd.h>

namespace chiaro {

namespace fs = std::filesystem;

namespace {

/// A name beside the destination that no other process, here or on another machine that shares the folder,
/// and no other thread is using.
fs::path temporaryBeside(const fs::path& destination) {
    static std::atomic<unsigned> counter{0};
    return destination.parent_path() / fmt::format(".{}.{}-{}-{}{}", destination.stem().string(), ::getpid(),
                                                   counter++, thisMachine(),
                                                   destination.extension().string());
}

Error writeError(const fs::path& path, const std::string& reason) {
    return Error(path.string(), "could not be written (" + reason + ")",
                 "choose a folder you may write to that has space left");
}

void flushToDisk(const fs::path& path, const fs::path& destination, int flags) {
    const int file = ::open(path.c_str(), flags);
    if (file < 0) throw writeError(destination, std::strerror(errno));
    const int result = ::fsync(file);
    const int reason = errno;
    ::close(file);
    if (result != 0) throw writeError(destination, std::strerror(reason));
}

/// Why what is at the destination can't be replaced; empty when it can.
std::string refusal(const fs::path& destination) {
    std::error_code ignored;
    if (fs::is_directory(destination, ignored)) return "it is a folder";
    const fs::perms anyWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    const bool isReadOnly = fs::exists(destination, ignored) &&
                            (fs::status(destination, ignored).permissions() & anyWrite) == fs::perms::none;
    return isReadOnly ? "it is marked read-only" : "";
}

/// Writes a file beside the destination and removes it. A folder that is missing is made only when there is
/// something to put into it, so it is asked of the one that it will be made in.
void checkFolder(const fs::path& destination) {
    std::error_code ignored;
    fs::path folder = fs::absolute(destination, ignored).parent_path();
    while (!fs::exists(folder, ignored) && folder.has_relative_path()) folder = folder.parent_path();
    if (!fs::is_directory(folder, ignored)) throw writeError(destination, folder.string() + " is no folder");
    const fs::path probe = temporaryBeside(folder / destination.filename());
    const int file = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (file < 0) throw writeError(destination, std::strerror(errno));
    ::close(file);
    fs::remove(probe, ignored);
}

}  // namespace

std::string thisMachine() {
    static const std::string name = [] {
        std::array<char, 256> host{};
        if (::gethostname(host.data(), host.size() - 1) != 0 || host[0] == 0) return std::string("unnamed");
        std::string text = host.data();
        std::ranges::replace_if(
            text, [](unsigned char letter) { return !std::isalnum(letter); }, '_');
        return text;
    }();
    return name;
}

AtomicFile::AtomicFile(fs::path destination) : m_destination(std::move(destination)) {
    std::error_code error;
    if (m_destination.has_parent_path()) fs::create_directories(m_destination.parent_path(), error);
    if (error) throw writeError(m_destination, error.message());
    if (const std::string reason = refusal(m_destination); !reason.empty())
        throw writeError(m_destination, reason);
    m_temporary = temporaryBeside(m_destination);
}

AtomicFile::~AtomicFile() {
    std::error_code ignored;
    if (!m_committed) fs::remove(m_temporary, ignored);
}

void AtomicFile::flush() const {
    flushToDisk(m_temporary, m_destination, O_RDONLY);
}

void AtomicFile::commit() {
    flush();
    std::error_code error;
    fs::rename(m_temporary, m_destination, error);
    if (error) throw writeError(m_destination, error.message());
    m_committed = true;
}

void AtomicFile::write(std::string_view bytes) const {
    std::ofstream stream(m_temporary, std::ios::binary);
    stream.write(bytes.data(), std::streamsize(bytes.size()));
    stream.close();
    if (!stream) throw writeError(m_destination, std::strerror(errno));
    flush();
}

void writeFileAtomically(const fs::path& path, std::string_view bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void writeFilesAtomically(const std::vector<NamedBytes>& files) {
    std::list<AtomicFile> written;
    for (const NamedBytes& file : files) written.emplace_back(file.path).write(file.bytes);
    for (AtomicFile& file : written) file.commit();
}

void checkOutputs(const std::vector<fs::path>& files, bool mayReplace, const std::string& whatToDo) {
    std::error_code ignored;
    if (!mayReplace)
        for (const fs::path& file : files)
            if (fs::exists(file, ignored) && !fs::is_directory(file, ignored))
                throw Error(file.string(), "is there already", whatToDo);
    std::set<fs::path> folders;
    for (const fs::path& file : files) {
        if (!refusal(file).empty()) throw writeError(file, refusal(file));
        if (folders.insert(file.parent_path()).second) checkFolder(file);
    }
}

void removeLeftovers(const std::vector<fs::path>& files) {
    std::map<fs::path, std::set<std::string>> names;
    for (const fs::path& file : files) names[file.parent_path()].insert(file.filename().string());
    static const std::regex temporary(R"(\.(.+)\.(\d+)-\d+-(\w+?)(\.[^.]*)?)");
    std::error_code ignored;
    for (const auto& [folder, wanted] : names)
        for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
            const std::string name = entry.path().filename().string();
            std::smatch match;
            if (!std::regex_match(name, match, temporary)) continue;
            // Of another machine's processes nothing is known here.
            const bool isOver = match.str(3) == thisMachine() &&
                                ::kill(std::atoi(match.str(2).c_str()), 0) != 0 && errno == ESRCH;
            if (isOver && wanted.contains(match.str(1) + match.str(4))) fs::remove(entry.path(), ignored);
        }
}

std::string readFile(const fs::path& path, std::uintmax_t limit) {
    std::error_code error;
    if (!fs::exists(path, error)) throw Error(path.string(), "no such file", "check the name and the folder");
    if (!fs::is_regular_file(path, error)) throw Error(path.string(), "is not a file", "name a file");
    const std::uintmax_t size = fs::file_size(path, error);
    if (error || size > limit)
        throw Error(path.string(), fmt::format("is {} MB large", size >> 20),
                    fmt::format("at most {} MB are read", limit >> 20));
    std::string bytes(std::size_t(size), '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(bytes.data(), std::streamsize(size));
    if (!stream) throw Error(path.string(), "could not be read", "check its permissions");
    return bytes;
}

}  // namespace chiaro
