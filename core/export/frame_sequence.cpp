#include "core/export/frame_sequence.h"

#include "core/base/error.h"
#include "core/base/image_io.h"

#include <spdlog/fmt/fmt.h>

#include <charconv>

namespace chiaro::exporting {

namespace {

constexpr int latestFrame = 1'000'000;

/// A whole number that makes up the whole text; 0 for anything else.
int frameFrom(std::string_view text) {
    int frame = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), frame);
    return problem == std::errc() && end == text.data() + text.size() ? frame : 0;
}

}  // namespace

FrameSequence::FrameSequence(const std::filesystem::path& pattern) : m_folder(pattern.parent_path()) {
    const std::string name = pattern.filename().string();
    const std::size_t begin = name.find('#');
    const std::size_t end = name.find_first_not_of('#', begin);
    if (begin == std::string::npos || end == std::string::npos || name.find('#', end) != std::string::npos)
        throw Error(pattern.string(), "has no place for the frame's number",
                    "write #### there, as in name.####.png");
    if (!isWritableImage(pattern))
        throw Error(pattern.string(), "has no extension of a picture", "choose .png, .exr or .tif");
    m_before = name.substr(0, begin);
    m_after = name.substr(end);
    m_digits = int(end - begin);
}

std::filesystem::path FrameSequence::path(int frame) const {
    return m_folder / fmt::format("{}{:0{}}{}", m_before, frame, m_digits, m_after);
}

FrameRange FrameRange::parse(const std::string& text) {
    const std::size_t dash = text.find('-');
    FrameRange range;
    range.first = frameFrom(std::string_view(text).substr(0, dash));
    range.last = dash == std::string::npos ? range.first : frameFrom(std::string_view(text).substr(dash + 1));
    if (range.first < 1 || range.last < range.first || range.last > latestFrame)
        throw Error("frames", fmt::format("is \"{}\"", text),
                    fmt::format("write the first and the last frame as 1-48, 1..{}", latestFrame));
    return range;
}

}  // namespace chiaro::exporting
