#include "core/metrics/heat_map.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace chiaro::metrics {

namespace {

constexpr glm::vec3 ground{0.35f};

/// 256 colours of one of OpenCV's maps.
std::array<glm::vec3, 256> colorsOf(int map) {
    cv::Mat numbers(1, 256, CV_8UC1), colors;
    for (int i = 0; i < 256; ++i) numbers.at<std::uint8_t>(i) = std::uint8_t(i);
    cv::applyColorMap(numbers, colors, map);
    std::array<glm::vec3, 256> result;
    for (int i = 0; i < 256; ++i) {
        const cv::Vec3b& bgr = colors.at<cv::Vec3b>(i);
        result[std::size_t(i)] = glm::vec3(bgr[2], bgr[1], bgr[0]) / 255.0f;
    }
    return result;
}

std::size_t indexOf(float fraction) {
    return std::size_t(std::lround(std::clamp(fraction, 0.0f, 1.0f) * 255));
}

/// White text; `at` is the left end of its middle line.
void write(ColorImage& image, const std::string& text, glm::ivec2 at) {
    cv::Mat whole(image.height(), image.width(), CV_8UC1, cv::Scalar(0));
    constexpr double scale = 0.4;
    int baseline = 0;
    const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale, 1, &baseline);
    cv::putText(whole, text, cv::Point(at.x, at.y + size.height / 2), cv::FONT_HERSHEY_SIMPLEX, scale,
                cv::Scalar(255), 1, cv::LINE_AA);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image(x, y) = glm::mix(image(x, y), glm::vec3(1), float(whole.at<std::uint8_t>(y, x)) / 255);
}

}  // namespace

ColorImage heatMap(const ScalarImage& values, float least, float most) {
    static const std::array<glm::vec3, 256> colors = colorsOf(cv::COLORMAP_INFERNO);
    ColorImage picture(values.width(), values.height(), ground);
    for (std::size_t i = 0; i < values.pixelCount(); ++i)
        if (const float value = values.pixels()[i]; value >= 0)
            picture.pixels()[i] = colors[indexOf((value - least) / (most - least))];
    return picture;
}

ColorImage heatMapWithBar(const ScalarImage& values, float least, float most) {
    constexpr int gap = 12, barWidth = 16, labelWidth = 56, ticks = 5;
    const int margin = std::min(10, values.height() / 4);
    const int barHeight = std::max(values.height() - 2 * margin, 1);
    ColorImage picture(values.width() + gap + barWidth + labelWidth, values.height(), glm::vec3(0.16f));
    const ColorImage map = heatMap(values, least, most);
    for (int y = 0; y < map.height(); ++y) std::ranges::copy(map.row(y), picture.row(y).begin());
    ScalarImage bar(barWidth, barHeight);
    for (int y = 0; y < barHeight; ++y)
        std::ranges::fill(bar.row(y), 1 - (float(y) + 0.5f) / float(barHeight));
    const ColorImage barColors = heatMap(bar, 0, 1);
    for (int y = 0; y < barHeight; ++y)
        std::ranges::copy(barColors.row(y), picture.row(y + margin).begin() + map.width() + gap);
    if (barHeight < 24) return picture;  // no room for figures
    const int shown = barHeight < 100 ? 2 : ticks;
    for (int i = 0; i < shown; ++i) {
        const float fraction = float(i) / float(shown - 1);
        const int y = margin + int(std::lround((1 - fraction) * float(barHeight - 1)));
        write(picture, fmt::format("{:.3g}", least + fraction * (most - least)),
              {map.width() + gap + barWidth + 6, y});
    }
    return picture;
}

float heatMapEnd(const ScalarImage& values) {
    std::vector<float> measured;
    std::ranges::copy_if(values.pixels(), std::back_inserter(measured),
                         [](float value) { return value >= 0; });
    float high = 0;
    if (!measured.empty()) {
        const auto place = measured.begin() + std::ptrdiff_t((measured.size() - 1) * 199 / 200);
        std::ranges::nth_element(measured, place);
        high = *place;
    }
    return std::max(std::ceil(high * 100 - 1e-4f) / 100, 0.01f);
}

ColorImage matchMap(const Image<glm::i16vec2>& best, int sourceWidth, int sourceHeight) {
    static const std::array<glm::vec3, 256> colors = colorsOf(cv::COLORMAP_TURBO);
    ColorImage picture(best.width(), best.height(), ground);
    for (std::size_t i = 0; i < best.pixelCount(); ++i) {
        const glm::ivec2 place = best.pixels()[i];
        if (place.x < 0) continue;
        const float x = float(place.x) / float(std::max(sourceWidth - 1, 1));
        const float y = float(place.y) / float(std::max(sourceHeight - 1, 1));
        picture.pixels()[i] = colors[indexOf(x)] * (1 - 0.55f * y);
    }
    return picture;
}

}  // namespace chiaro::metrics
