#include "core/metrics/descriptor.h"

#include "core/base/error.h"
#include "core/base/opencv_memory.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace chiaro::metrics {

namespace {

constexpr float steps = 65535;

cv::Mat stepsOf(const ColorImage& picture) {
    cv::Mat image(picture.height(), picture.width(), CV_32FC3);
    for (int y = 0; y < picture.height(); ++y) {
        auto* to = image.ptr<cv::Vec3f>(y);
        for (const glm::vec3& pixel : picture.row(y)) {
            for (int c = 0; c < 3; ++c) {
                const float value = pixel[c] >= 0 ? std::min(pixel[c], 1.0f) : 0;  // NaN fails the comparison
                (*to)[c] = std::round(value * steps);
            }
            ++to;
        }
    }
    return image;
}

/// The filters of the edge images; sums of six values of 16 bits are exact in float.
std::array<cv::Mat, 4> edgeFilters() {
    return {cv::Mat(cv::Matx33f(-1, 0, 1, -1, 0, 1, -1, 0, 1)),
            cv::Mat(cv::Matx33f(-1, -1, -1, 0, 0, 0, 1, 1, 1)),
            cv::Mat(cv::Matx33f(0, 0, 3, 0, 0, 0, -3, 0, 0)),
            cv::Mat(cv::Matx33f(-3, 0, 0, 0, 0, 0, 0, 0, 3))};
}

/// The smallest whole number not below the k/10 quantile of sorted values.
std::int32_t quantileCeiling(const std::vector<std::int32_t>& sorted, std::size_t tenths) {
    const std::size_t position = tenths * (sorted.size() - 1);
    const std::int64_t below = sorted[position / 10];
    const std::int64_t above = sorted[std::min(position / 10 + 1, sorted.size() - 1)];
    return std::int32_t(below + ((above - below) * std::int64_t(position % 10) + 9) / 10);
}

void count(Descriptor& descriptor, const BinImage& bins, int x, int top, int rows, int step) {
    for (int y = top; y < top + rows; ++y) {
        const auto& pixel = bins(x, y);
        for (std::size_t channel = 0; channel < channelCount; ++channel) {
            std::uint16_t& counted = descriptor[channel * binCount + pixel[channel]];
            counted = std::uint16_t(counted + step);
        }
    }
}

}  // namespace

namespace {

ChannelImage filtered(const ColorImage& picture) {
    ChannelImage channels(picture.width(), picture.height());
    if (picture.empty()) return channels;
    std::array<cv::Mat, 5> images{stepsOf(picture)};
    const std::array<cv::Mat, 4> filters = edgeFilters();
    for (std::size_t i = 0; i < filters.size(); ++i)
        cv::filter2D(images[0], images[i + 1], CV_32F, filters[i], cv::Point(-1, -1), 0,
                     cv::BORDER_REPLICATE);
    for (std::size_t i = 0; i < images.size(); ++i)
        for (int y = 0; y < picture.height(); ++y) {
            const auto* from = images[i].ptr<cv::Vec3f>(y);
            for (auto& pixel : channels.row(y)) {
                for (int c = 0; c < 3; ++c) pixel[3 * i + std::size_t(c)] = std::int32_t((*from)[c]);
                ++from;
            }
        }
    return channels;
}

}  // namespace

ChannelImage channelImages(const ColorImage& picture) {
    return withOpenCv([&] { return filtered(picture); });
}

Bins binsOf(const ColorImage& source) {
    const auto pixels = source.pixels();
    if (std::ranges::all_of(pixels, [&](const glm::vec3& pixel) { return pixel == pixels.front(); }))
        throw Error("sample", source.empty() ? "has no pixels" : "is of one colour",
                    "choose a strip with strokes in it, since the metric compares strokes");
    const ChannelImage channels = channelImages(source);
    Bins bins;
    std::vector<std::int32_t> values(channels.pixelCount());
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = channels.pixels()[i][channel];
        std::ranges::sort(values);
        for (std::size_t k = 1; k < binCount; ++k) bins.edges[channel][k - 1] = quantileCeiling(values, k);
    }
    return bins;
}

BinImage binned(const ColorImage& picture, const Bins& bins) {
    const ChannelImage channels = channelImages(picture);
    BinImage result(picture.width(), picture.height());
    for (std::size_t i = 0; i < result.pixelCount(); ++i)
        for (std::size_t channel = 0; channel < channelCount; ++channel) {
            const std::int32_t value = channels.pixels()[i][channel];
            std::uint8_t bin = 0;
            for (const std::int32_t edge : bins.edges[channel]) bin = std::uint8_t(bin + (edge <= value));
            result.pixels()[i][channel] = bin;
        }
    return result;
}

Descriptor describe(const BinImage& bins, const Block& block) {
    Descriptor descriptor{};
    for (int x = block.corner.x; x < block.corner.x + block.size; ++x)
        count(descriptor, bins, x, block.corner.y, block.size, 1);
    return descriptor;
}

BlockCounter::BlockCounter(const BinImage& bins, glm::ivec2 corner, int size)
    : m_bins(bins), m_block(corner + size / 2, size), m_descriptor(describe(bins, m_block)) {}

void BlockCounter::advance() {
    count(m_descriptor, m_bins, m_block.corner.x, m_block.corner.y, m_block.size, -1);
    count(m_descriptor, m_bins, m_block.corner.x + m_block.size, m_block.corner.y, m_block.size, 1);
    ++m_block.corner.x;
}

double distance(const Descriptor& a, const Descriptor& b, int size) {
    double sum = 0;
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
        std::int64_t squares = 0;
        for (std::size_t i = channel * binCount; i < (channel + 1) * binCount; ++i) {
            const std::int64_t difference = std::int64_t(a[i]) - std::int64_t(b[i]);
            squares += difference * difference;
        }
        sum += std::sqrt(double(squares));
    }
    return sum / (channelCount * size * size);
}

}  // namespace chiaro::metrics
