#include "core/sample/crop.h"

#include "core/base/error.h"
#include "core/base/opencv_memory.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <optional>

namespace chiaro::sample {

namespace {

/// Fractions are held in single precision; nobody places a corner to a hundredth of a pixel.
constexpr double cornerTolerance = 0.01;

Error badCrop(const char* problem, const char* remedy) {
    return Error("crop", problem, remedy);
}

struct PixelRectangle {
    int x, y, width, height;
};

std::optional<PixelRectangle> wholePixels(const Crop& crop) {
    std::array<glm::ivec2, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        corners[i] = glm::ivec2(glm::round(crop.corners[i]));
        const glm::dvec2 error = glm::abs(glm::dvec2(corners[i]) - crop.corners[i]);
        if (std::max(error.x, error.y) > cornerTolerance) return std::nullopt;
    }
    const bool upright = corners[0].x == corners[3].x && corners[1].x == corners[2].x &&
                         corners[0].y == corners[1].y && corners[2].y == corners[3].y;
    if (!upright) return std::nullopt;
    return PixelRectangle{corners[0].x, corners[0].y, corners[1].x - corners[0].x,
                          corners[3].y - corners[0].y};
}

/// Catmull-Rom weights of the four samples around a place that lies `t` in [0, 1) past the second.
std::array<float, 4> cubicWeights(float t) {
    const float t2 = t * t;
    const float t3 = t2 * t;
    return {-0.5f * t3 + t2 - 0.5f * t, 1.5f * t3 - 2.5f * t2 + 1, -1.5f * t3 + 2 * t2 + 0.5f * t,
            0.5f * t3 - 0.5f * t2};
}

/// The scan at a place whose pixel centres are whole numbers; its border pixels go on outside.
glm::vec3 bicubic(const ColorImage& scan, glm::dvec2 place) {
    const glm::dvec2 floor = glm::floor(place);
    const std::array<float, 4> across = cubicWeights(float(place.x - floor.x));
    const std::array<float, 4> down = cubicWeights(float(place.y - floor.y));
    glm::vec3 sum(0);
    for (int j = 0; j < 4; ++j) {
        const auto row = scan.row(std::clamp(int(floor.y) - 1 + j, 0, scan.height() - 1));
        glm::vec3 rowSum(0);
        for (int i = 0; i < 4; ++i) {
            const int x = std::clamp(int(floor.x) - 1 + i, 0, scan.width() - 1);
            rowSum += across[std::size_t(i)] * row[std::size_t(x)];
        }
        sum += down[std::size_t(j)] * rowSum;
    }
    return glm::clamp(sum, 0.0f, 1.0f);
}

ColorImage warped(const ColorImage& scan, const Crop& crop) {
    // Pixel centres of both pictures lie half a pixel inside their outer corners.
    std::array<cv::Point2f, 4> from, to;
    const std::array<glm::dvec2, 4> ends{
        glm::dvec2{0, 0}, {crop.width, 0}, {crop.width, crop.height}, {0, crop.height}};
    for (std::size_t i = 0; i < 4; ++i) {
        from[i] = {float(ends[i].x), float(ends[i].y)};
        to[i] = {float(crop.corners[i].x), float(crop.corners[i].y)};
    }
    const cv::Matx33d map =
        withOpenCv([&]() -> cv::Matx33d { return cv::getPerspectiveTransform(from.data(), to.data()); });
    ColorImage result(crop.width, crop.height);
    cv::parallel_for_({0, crop.height}, [&](const cv::Range& rows) {
        for (int y = rows.start; y < rows.end; ++y) {
            for (int x = 0; x < crop.width; ++x) {
                const cv::Vec3d place = map * cv::Vec3d(x + 0.5, y + 0.5, 1);
                result(x, y) = bicubic(scan, glm::dvec2(place[0], place[1]) / place[2] - 0.5);
            }
        }
    });
    return result;
}

}  // namespace

Crop makeCrop(const std::array<glm::vec2, 4>& fractions, int scanWidth, int scanHeight) {
    Crop crop;
    const glm::dvec2 size(scanWidth, scanHeight);
    for (std::size_t i = 0; i < 4; ++i) {
        crop.corners[i] = glm::dvec2(fractions[i]) * size;
        const glm::dvec2 inside = glm::clamp(crop.corners[i], glm::dvec2(0), size);
        // The comparison is written so that NaN fails it too.
        if (!(glm::distance(inside, crop.corners[i]) <= cornerTolerance))
            throw badCrop("a corner lies outside the scan", "keep all four corners on the picture");
        crop.corners[i] = inside;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 before = crop.corners[i] - crop.corners[(i + 3) % 4];
        const glm::dvec2 after = crop.corners[(i + 1) % 4] - crop.corners[i];
        if (before.x * after.y - before.y * after.x <= 0)
            throw badCrop(
                "the corners don't make a convex quadrilateral",
                "place them around the paint in the order top-left, top-right, bottom-right, bottom-left");
    }
    const auto edge = [&](std::size_t a, std::size_t b) {
        return glm::distance(crop.corners[a], crop.corners[b]);
    };
    crop.width = int(std::lround((edge(0, 1) + edge(3, 2)) / 2));
    crop.height = int(std::lround((edge(0, 3) + edge(1, 2)) / 2));
    return crop;
}

ColorImage cropped(const ColorImage& scan, const Crop& crop) {
    const std::optional<PixelRectangle> rectangle = wholePixels(crop);
    if (!rectangle) return warped(scan, crop);
    ColorImage result(rectangle->width, rectangle->height);
    for (int y = 0; y < result.height(); ++y) {
        const auto row = scan.row(rectangle->y + y).subspan(std::size_t(rectangle->x));
        std::copy_n(row.begin(), result.width(), result.row(y).begin());
    }
    return result;
}

}  // namespace chiaro::sample
