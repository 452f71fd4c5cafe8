#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiaro {

/// A file that appears whole or not at all: it is written beside its destination under another name, checked,
/// flushed to the disk and then renamed over the destination. Destroyed uncommitted, it leaves nothing
/// behind. The other name is .STEM.PROCESS-NUMBER-MACHINE.EXTENSION.
class AtomicFile {
public:
    /// Creates the destination's folder when it is missing. Throws Error when that can't be done.
    explicit AtomicFile(std::filesystem::path destination);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Where to write meanwhile: the same folder, the same extension.
    const std::filesystem::path& temporaryPath() const { return m_temporary; }
    /// Flushes to the disk what was written under the temporary name. Throws Error naming the destination.
    void flush() const;
    /// Writes the bytes under the temporary name and flushes them to the disk, every write checked. Throws
    /// Error naming the destination.
    void write(std::string_view bytes) const;
    /// Flushes to the disk and renames. Throws Error naming the destination; the old file is then intact.
    void commit();

private:
    std::filesystem::path m_destination;
    std::filesystem::path m_temporary;
    bool m_committed = false;
};

/// The name of this machine as temporary names have it: letters, digits and underscores alone.
std::string thisMachine();

/// Writes the bytes as an AtomicFile, every write checked. Throws Error naming the path.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// A file's name and what it is to hold.
struct NamedBytes {
    std::filesystem::path path;
    std::string bytes;
};
/// Writes files that belong together: none gets its name before all of them are written and flushed to the
/// disk. Throws Error naming the one that failed.
void writeFilesAtomically(const std::vector<NamedBytes>& files);

/// To be called before long work: throws Error naming the file when one is there already and may not be
/// replaced, or when its folder can't be written to. `whatToDo` ends the sentence about the former.
void checkOutputs(const std::vector<std::filesystem::path>& files, bool mayReplace,
                  const std::string& whatToDo = "choose another name, or --overwrite");

/// Removes what a process of this machine that was killed amid writing one of these files left beside it.
void removeLeftovers(const std::vector<std::filesystem::path>& files);

/// Reads a whole file of at most `limit` bytes. Throws Error when it is missing, no file, or larger.
std::string readFile(const std::filesystem::path& path, std::uintmax_t limit);

}  // namespace chiaro
