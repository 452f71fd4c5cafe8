#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace chiaro::test {

/// What a file of a format is opened as.
enum class Opened { Picture, Mesh, Project, Path, Preset };

/// A format that the studio and the command line open, and tiny files of it that are as they should be.
struct Format {
    std::string name;       ///< of its folder in corpus/
    std::string extension;  ///< ".png"
    Opened as = Opened::Picture;

    /// The bytes of its files, in order of their names.
    std::vector<std::string> corpus() const;
};

const std::vector<Format>& formats();

/// How many mutations of each format a test is to try: `quick`, or `thorough` when CHIARO_LONG_TESTS is set.
std::size_t rounds(std::size_t quick, std::size_t thorough);

}  // namespace chiaro::test
