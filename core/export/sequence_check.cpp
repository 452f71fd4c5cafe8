#include "core/export/sequence_check.h"

#include "core/base/color.h"
#include "core/base/error.h"
#include "core/base/image_io.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <compare>
#include <map>

namespace chiaro::exporting {

namespace {

/// What all frames of one animation have in common.
struct Likeness {
    int width = 0;
    int height = 0;
    std::string maker;  ///< version, command and parameters without the frame's number
    auto operator<=>(const Likeness&) const = default;
};

std::string makerOf(const std::filesystem::path& path) {
    std::string maker;
    for (const auto& [key, value] : readImageMetadata(path)) {
        if (key == "Software") maker += value;
        if (key != "chiaro:parameters") continue;
        nlohmann::json parameters = nlohmann::json::parse(value, nullptr, false);
        if (parameters.is_object()) parameters.erase("frame");
        maker += parameters.dump();
    }
    return maker;
}

/// What most of the frames are like.
Likeness mostCommon(const std::map<int, Likeness>& frames) {
    std::map<Likeness, int> counts;
    for (const auto& [frame, likeness] : frames) ++counts[likeness];
    const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
    return most == counts.end() ? Likeness{} : most->first;
}

}  // namespace

std::string rangesText(const std::vector<int>& numbers) {
    std::vector<std::string> parts;
    for (std::size_t first = 0; first < numbers.size();) {
        std::size_t last = first;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        parts.push_back(first == last ? std::to_string(numbers[first])
                                      : fmt::format("{}-{}", numbers[first], numbers[last]));
        first = last + 1;
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string SequenceReport::text() const {
    std::vector<std::string> parts;
    const auto add = [&parts](const std::vector<int>& frames, const std::string& what) {
        if (frames.empty()) return;
        parts.push_back(fmt::format("frame{} {} {} {}", frames.size() == 1 ? "" : "s", rangesText(frames),
                                    frames.size() == 1 ? "is" : "are", what));
    };
    add(missing, "missing");
    add(damaged, "damaged");
    add(different, "of another command or from other files");
    return fmt::format("{}", fmt::join(parts, ", "));
}

SequenceReport checkSequence(const FrameSequence& sequence, FrameRange range, const Task& task) {
    SequenceReport report;
    std::map<int, Likeness> frames;
    for (int frame = range.first; frame <= range.last; ++frame) {
        const std::filesystem::path path = sequence.path(frame);
        std::error_code ignored;
        try {
            if (!std::filesystem::exists(path, ignored)) {
                report.missing.push_back(frame);
            } else {
                const DecodedImage picture = readImage(path);
                frames[frame] = {picture.width, picture.height, makerOf(path)};
            }
        } catch (const Error&) {
            report.damaged.push_back(frame);
        }
        task.report(double(frame - range.first + 1) / range.count());
        task.checkpoint();
    }
    const Likeness usual = mostCommon(frames);
    for (const auto& [frame, likeness] : frames) {
        if (likeness.width != usual.width || likeness.height != usual.height)
            report.damaged.push_back(frame);
        else if (likeness.maker != usual.maker)
            report.different.push_back(frame);
    }
    std::ranges::sort(report.damaged);
    return report;
}

ColorImage readFrame(const std::filesystem::path& path, glm::vec3 background) {
    const DecodedImage decoded = readImage(path);
    const bool isGrey = decoded.channels < 3, hasAlpha = decoded.channels % 2 == 0;
    ColorImage picture(decoded.width, decoded.height);
    const float* value = decoded.values.data();
    for (glm::vec3& pixel : picture.pixels()) {
        pixel = isGrey ? glm::vec3(value[0]) : glm::vec3(value[0], value[1], value[2]);
        if (decoded.linear) pixel = srgbFromLinear(pixel);
        const float alpha = hasAlpha ? value[decoded.channels - 1] : 1;
        pixel = pixel * alpha + background * (1 - alpha);
        value += decoded.channels;
    }
    return picture;
}

}  // namespace chiaro::exporting
