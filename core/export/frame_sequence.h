#pragma once

#include <filesystem>
#include <string>

namespace chiaro::exporting {

/// The files of a sequence: `folder/name.####.png`, where the signs stand for the frame's number with at
/// least as many digits. At most one run of signs, in the file's name.
class FrameSequence {
public:
    /// Throws Error when the name has no run of #, or the extension is none that a picture can be written
    /// with.
    explicit FrameSequence(const std::filesystem::path& pattern);
    std::filesystem::path path(int frame) const;

private:
    std::filesystem::path m_folder;
    std::string m_before, m_after;
    int m_digits = 0;
};

/// The frames of "1-48" or "7", first and last; 1 or later.
struct FrameRange {
    int first = 1;
    int last = 1;
    int count() const { return last - first + 1; }
    /// Throws Error.
    static FrameRange parse(const std::string& text);
};

}  // namespace chiaro::exporting
