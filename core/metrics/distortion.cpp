#include "core/metrics/distortion.h"

#include "core/base/error.h"
#include "core/base/opencv_memory.h"
#include "core/base/random.h"
#include "core/synthesis/quilting.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <numbers>

namespace chiaro::metrics {

namespace {

/// The pixels as OpenCV sees them; it takes no const ones, but only reads these.
cv::Mat viewOf(const ColorImage& picture) {
    return cv::Mat(picture.height(), picture.width(), CV_32FC3,
                   const_cast<glm::vec3*>(picture.pixels().data()));
}

/// Lanczos may overshoot.
ColorImage clipped(const cv::Mat& image) {
    ColorImage picture(image.cols, image.rows);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x) {
            const auto& pixel = image.at<cv::Vec3f>(y, x);
            picture(x, y) = glm::clamp(glm::vec3(pixel[0], pixel[1], pixel[2]), 0.0f, 1.0f);
        }
    return picture;
}

/// The place in 0..length - 1 that a place beyond is the mirror image of.
int mirrored(int place, int length) {
    const int period = 2 * length;
    const int within = (place % period + period) % period;
    return within < length ? within : period - 1 - within;
}

/// One axis resized; the other keeps its length.
cv::Mat resizedAlong(const cv::Mat& image, double factorX, double factorY) {
    const cv::Size size(std::max(int(std::lround(image.cols * factorX)), 1),
                        std::max(int(std::lround(image.rows * factorY)), 1));
    if (size == image.size()) return image;
    cv::Mat result;
    cv::resize(image, result, size, 0, 0,
               std::min(factorX, factorY) < 1 ? cv::INTER_AREA : cv::INTER_LANCZOS4);
    return result;
}

}  // namespace

ColorImage rotated(const ColorImage& picture, double degrees) {
    const cv::Point2f centre(float(picture.width() - 1) / 2, float(picture.height() - 1) / 2);
    return withOpenCv([&] {
        cv::Mat result;
        cv::warpAffine(viewOf(picture), result, cv::getRotationMatrix2D(centre, -degrees, 1),
                       cv::Size(picture.width(), picture.height()), cv::INTER_LANCZOS4,
                       cv::BORDER_REFLECT_101);
        return clipped(result);
    });
}

ColorImage scaled(const ColorImage& picture, double factorX, double factorY) {
    for (const double factor : {factorX, factorY})
        if (!(factor >= 0.1 && factor <= 10))
            throw Error("scale", fmt::format("is {:g}", factor), "choose 0.1..10");
    const cv::Mat image =
        withOpenCv([&] { return resizedAlong(resizedAlong(viewOf(picture), factorX, 1), 1, factorY); });
    const int left = (image.cols - picture.width()) / 2, top = (image.rows - picture.height()) / 2;
    const ColorImage whole = clipped(image);
    ColorImage result(picture.width(), picture.height());
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x)
            result(x, y) = whole(mirrored(x + left, image.cols), mirrored(y + top, image.rows));
    return result;
}

ColorImage torn(const ColorImage& picture, int block, std::uint64_t seed, const Task& task) {
    synthesis::QuiltParams params;
    params.block = block;
    params.seed = seed;
    synthesis::QuiltParams::table().check(params);
    const int lastX = picture.width() - block, lastY = picture.height() - block;
    if (lastX < 0 || lastY < 0)
        throw Error("picture", fmt::format("is {} x {} px", picture.width(), picture.height()),
                    fmt::format("blocks of {} px must fit into it", block));
    synthesis::QuiltTask quilt;
    quilt.source = &picture;
    quilt.width = picture.width();
    quilt.height = picture.height();
    quilt.candidates = [=](const synthesis::BlockSite& site) {
        Random random(seed, std::uint64_t(site.index));
        const int centre = site.position.x + block / 2;
        const int first = std::clamp(centre - block, 0, lastX), last = std::clamp(centre, 0, lastX);
        const int x = first + int(random.below(std::uint64_t(last - first + 1)));
        return synthesis::CandidateArea{x, int(random.below(std::uint64_t(lastY + 1))), 1, 1};
    };
    return synthesis::quilt(quilt, params, task).texture;
}

IdImage centralDisc(int width, int height, double radius) {
    IdImage disc(width, height, 0);
    const glm::dvec2 centre((width - 1) / 2.0, (height - 1) / 2.0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) disc(x, y) = glm::length(glm::dvec2(x, y) - centre) <= radius;
    return disc;
}

namespace {

constexpr glm::vec3 darkPaint{0.22f, 0.16f, 0.30f}, lightPaint{0.93f, 0.80f, 0.52f};

/// Smooth values about 0 with deviation 1.
cv::Mat noise(int size, double sigma, Random random) {
    const int margin = int(std::ceil(4 * sigma));
    cv::Mat values(size + 2 * margin, size + 2 * margin, CV_32FC1);
    for (int y = 0; y < values.rows; ++y)
        for (int x = 0; x < values.cols; ++x) values.at<float>(y, x) = float(random.uniform()) - 0.5f;
    cv::GaussianBlur(values, values, cv::Size(0, 0), sigma, sigma);
    values = values(cv::Rect(margin, margin, size, size)).clone();
    cv::Scalar mean, deviation;
    cv::meanStdDev(values, mean, deviation);
    return (values - mean[0]) / deviation[0];
}

/// Shades of paint, 0 dark and 1 light.
ColorImage paintOf(const cv::Mat& shades) {
    ColorImage picture(shades.cols, shades.rows);
    for (int y = 0; y < shades.rows; ++y)
        for (int x = 0; x < shades.cols; ++x)
            picture(x, y) = glm::mix(darkPaint, lightPaint, std::clamp(shades.at<float>(y, x), 0.0f, 1.0f));
    return picture;
}

}  // namespace

ColorImage randomTexture(int size, std::uint64_t seed) {
    return paintOf(noise(size, 1.8, Random(seed)) * 0.2 + 0.5);
}

ColorImage diagonalTexture(int size, std::uint64_t seed) {
    constexpr float period = 9;  // px across a dark and a light stripe
    const float root = std::numbers::sqrt2_v<float>;
    // Stripes differ in width and strength, and their edges waver a little.
    const cv::Mat differences = noise(2 * size, 4, Random(seed)), waver = noise(size, 4, Random(seed, 1));
    cv::Mat shades(size, size, CV_32FC1);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float across =
                float(x + y) / root + 1.0f * differences.at<float>(0, x + y) + 0.25f * waver.at<float>(y, x);
            const float strength = 0.38f + 0.05f * differences.at<float>(1, x + y);
            shades.at<float>(y, x) =
                0.5f + strength * std::sin(across * 2 * std::numbers::pi_v<float> / period);
        }
    return paintOf(shades);
}

ColorImage symmetricTexture(int size, std::uint64_t seed) {
    constexpr float radius = 3.6f;
    Random random(seed);
    // A ground that is nowhere flat, since what is flat stays so under no distortion that resamples it.
    cv::Mat shades = noise(size, 2, Random(seed, 1)) * 0.04 + 0.25;
    for (int i = 0; i < size * size / 60; ++i) {
        const glm::vec2 centre = glm::vec2(random.uniform(), random.uniform()) * float(size);
        const float height = 0.3f + 0.35f * float(random.uniform());
        const int reach = int(3 * radius);
        for (int y = std::max(int(centre.y) - reach, 0); y <= std::min(int(centre.y) + reach, size - 1); ++y)
            for (int x = std::max(int(centre.x) - reach, 0); x <= std::min(int(centre.x) + reach, size - 1);
                 ++x) {
                const float away = glm::distance(glm::vec2(x, y), centre) / radius;
                shades.at<float>(y, x) += height * std::exp(-away * away * 2);
            }
    }
    return paintOf(shades);
}

}  // namespace chiaro::metrics
