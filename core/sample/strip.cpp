#include "core/sample/strip.h"

#include "core/base/error.h"
#include "core/base/opencv_memory.h"
#include "core/sample/crop.h"

#include <opencv2/imgproc.hpp>
#include <spdlog/fmt/fmt.h>

namespace chiaro::sample {

namespace {

constexpr int minimumWidth = 64, maximumWidth = 8192;
constexpr int minimumHeight = 16, maximumHeight = 4096;

void checkSize(double width, double height) {
    if (width >= minimumWidth && width <= maximumWidth && height >= minimumHeight && height <= maximumHeight)
        return;
    throw Error(
        "strip", fmt::format("is {:.0f} x {:.0f} pixels", width, height),
        fmt::format("a strip is {} to {} pixels wide and {} to {} high, so crop or scale it otherwise",
                    minimumWidth, maximumWidth, minimumHeight, maximumHeight));
}

ColorImage turned(const ColorImage& image, int clockwiseTurns) {
    const int width = image.width(), height = image.height();
    const bool upended = clockwiseTurns % 2 != 0;
    ColorImage result(upended ? height : width, upended ? width : height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            switch (clockwiseTurns) {
                case 1:
                    result(height - 1 - y, x) = image(x, y);
                    break;
                case 2:
                    result(width - 1 - x, height - 1 - y) = image(x, y);
                    break;
                default:
                    result(y, width - 1 - x) = image(x, y);
                    break;
            }
        }
    }
    return result;
}

void mirror(ColorImage& image) {
    for (int y = 0; y < image.height(); ++y) std::reverse(image.row(y).begin(), image.row(y).end());
}

/// Shrinks by area, so that no stroke is skipped; enlarges by Lanczos, whose overshoot is clipped.
ColorImage resized(const ColorImage& image, int width, int height) {
    ColorImage result(width, height);
    // OpenCV takes no const pixels; it only reads these.
    const cv::Mat from(image.height(), image.width(), CV_32FC3,
                       const_cast<glm::vec3*>(image.pixels().data()));
    cv::Mat to(height, width, CV_32FC3, result.pixels().data());
    const bool shrinks = width <= image.width() && height <= image.height();
    withOpenCv([&] { cv::resize(from, to, to.size(), 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LANCZOS4); });
    for (glm::vec3& pixel : result.pixels()) pixel = glm::clamp(pixel, 0.0f, 1.0f);
    return result;
}

}  // namespace

const ParameterTable<StripParams>& StripParams::table() {
    static const auto table =
        ParameterTable<StripParams>()
            .add(&StripParams::quarterTurns,
                 ParameterSpec::integer("quarter-turns", "Quarter turns", "", 0, 3,
                                        "How often the scan is turned by 90° clockwise, until dark and light "
                                        "lie left and right."))
            .add(&StripParams::mirror,
                 ParameterSpec::boolean("mirror", "Mirror",
                                        "Swaps left and right, for scans whose light end is at the left."))
            .add(
                &StripParams::scale,
                ParameterSpec::real("scale", "Scale", "", 0.05, 8, 0.05,
                                    "Enlarges or shrinks the strip; strokes on the object are as large as in "
                                    "the strip."));
    return table;
}

ColorImage makeStrip(const ColorImage& scan, const StripParams& params) {
    StripParams::table().check(params);
    // The size is known, and refused, before a pixel is touched.
    const Crop crop = makeCrop(params.crop, scan.width(), scan.height());
    int width = crop.width, height = crop.height;
    if (params.quarterTurns % 2 != 0) std::swap(width, height);
    const double scaledWidth = std::round(width * params.scale);
    const double scaledHeight = std::round(height * params.scale);
    checkSize(scaledWidth, scaledHeight);

    ColorImage strip = cropped(scan, crop);
    if (params.quarterTurns != 0) strip = turned(strip, params.quarterTurns);
    if (params.mirror) mirror(strip);
    if (params.scale != 1) strip = resized(strip, int(scaledWidth), int(scaledHeight));
    return strip;
}

ColorImage readStrip(const std::filesystem::path& path, const StripParams& params) {
    const ColorImage scan = readScan(path);
    try {
        return makeStrip(scan, params);
    } catch (const Error& error) {
        throw Error(path.string(), error);
    }
}

}  // namespace chiaro::sample
