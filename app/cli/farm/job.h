#pragma once

#include "core/export/frame_sequence.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace chiaro::cli::farm {

/// An animation that is painted in parts, on a farm or here. Its folder holds job.json, which is this;
/// chunk.sh, which paints the chunk whose number it is given; and what each chunk wrote and came to.
struct Job {
    std::filesystem::path folder;               ///< absolute
    std::string engine;                         ///< key of the one that it was given to
    std::string number;                         ///< as that engine calls it; empty before
    std::filesystem::path program;              ///< chiaro, absolute
    std::filesystem::path workplace;            ///< where relative names in the arguments begin; absolute
    std::filesystem::path pattern;              ///< of the frames, absolute
    std::vector<std::string> arguments;         ///< of `chiaro animate`, but for frames, threads and resuming
    std::vector<exporting::FrameRange> chunks;  ///< chunk 1 first
    int threads = 0;                            ///< of each chunk; 0: all cores
    int tries = 3;                              ///< how often a chunk may be begun
    double rate = 24;                           ///< frames a second, for a video of the frames

    exporting::FrameRange range() const { return {chunks.front().first, chunks.back().last}; }
    std::filesystem::path script() const { return folder / "chunk.sh"; }
    /// What a chunk printed, 1 or later.
    std::filesystem::path log(int chunk) const;
};

/// Where the job of such frames lies unless another folder is named: name.farm beside them.
std::filesystem::path jobFolder(const std::filesystem::path& pattern);

/// Cuts a range of frames into chunks of `size` frames. Each but the first begins at a keyframe, 1 + a
/// multiple of `every`, so that no two chunks make the same keyframe but the one that both blend towards.
std::vector<exporting::FrameRange> chunksOf(exporting::FrameRange range, int size, int every);

/// Writes job.json and chunk.sh and forgets how chunks of an earlier job ended. Throws Error.
void writeJob(const Job& job);
/// Writes job.json alone, once the job has its number. Throws Error.
void writeNumber(const Job& job);
/// The job of a folder. Throws Error when there is none.
Job readJob(const std::filesystem::path& folder);

/// The text of chunk.sh.
std::string chunkScript(const Job& job);
/// The command line that paints a chunk, quoted for a shell.
std::string commandLine(const Job& job, int chunk);
/// A word as a shell takes it.
std::string quoted(const std::string& word);

/// What chunk.sh noted of a chunk.
struct Note {
    enum class Kind { Running, Done, Failed } kind;
    int tries = 0;   ///< how often it was begun
    int status = 0;  ///< exit status of one that failed
};
std::optional<Note> noteOf(const Job& job, int chunk);

}  // namespace chiaro::cli::farm
