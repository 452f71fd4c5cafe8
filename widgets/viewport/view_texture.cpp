#include "widgets/viewport/view_texture.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr int margin = 48;  // px around an object's pixels, for what the next views uncover

/// For each pixel of a mask the nearest that isn't 0.
Image<glm::ivec2> nearestCovered(const Image<std::uint8_t>& covered) {
    cv::Mat outside(covered.height(), covered.width(), CV_8U);
    for (int y = 0; y < covered.height(); ++y)
        for (int x = 0; x < covered.width(); ++x) outside.at<std::uint8_t>(y, x) = covered(x, y) == 0;
    cv::Mat distance;
    cv::Mat labels;
    cv::distanceTransform(outside, distance, labels, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    std::vector<glm::ivec2> places(covered.pixelCount() + 1);
    for (int y = 0; y < covered.height(); ++y)
        for (int x = 0; x < covered.width(); ++x)
            if (covered(x, y) != 0) places[std::size_t(labels.at<int>(y, x))] = {x, y};
    Image<glm::ivec2> nearest(covered.width(), covered.height());
    for (int y = 0; y < covered.height(); ++y)
        for (int x = 0; x < covered.width(); ++x) nearest(x, y) = places[std::size_t(labels.at<int>(y, x))];
    return nearest;
}

/// What lies as far inside the outline as `pixel` lies outside, or less far where the object is thin.
glm::ivec2 mirrored(glm::ivec2 pixel, glm::ivec2 outline, const Image<std::uint8_t>& covered) {
    for (glm::ivec2 inwards = outline - pixel; inwards != glm::ivec2(0); inwards /= 2) {
        const glm::ivec2 place = outline + inwards;
        if (covered.contains(place.x, place.y) && covered(place.x, place.y) != 0) return place;
    }
    return outline;
}

template <class Pixel>
Image<Pixel> padded(const Image<Pixel>& image) {
    Image<Pixel> result(image.width() + 2 * margin, image.height() + 2 * margin);
    for (int y = 0; y < image.height(); ++y)
        std::ranges::copy(image.row(y), result.row(y + margin).begin() + margin);
    return result;
}

Image<methods::DifferenceTexel> extended(const methods::ObjectTexture& made,
                                         const methods::DifferenceRange& range) {
    Image<methods::DifferenceTexel> texels(made.pixels.width(), made.pixels.height());
    methods::encodeDifferences(made.pixels, range, texels.pixels().data());
    texels = padded(texels);
    const Image<std::uint8_t> covered = padded(made.covered);
    const Image<glm::ivec2> nearest = nearestCovered(covered);
    for (int y = 0; y < texels.height(); ++y)
        for (int x = 0; x < texels.width(); ++x) {
            if (covered(x, y) != 0) continue;
            const glm::ivec2 place = mirrored({x, y}, nearest(x, y), covered);
            texels(x, y) = texels(place.x, place.y);
        }
    return texels;
}

/// The index that mirrored repetition has at any index, as GL_MIRRORED_REPEAT.
int mirroredIndex(int index, int size) {
    const int period = 2 * size;
    const int place = (index % period + period) % period;
    return place < size ? place : period - 1 - place;
}

}  // namespace

glm::vec3 ViewTexture::difference(std::size_t object, glm::vec2 position) const {
    if (object >= objects.size() || objects[object].texels.empty()) return glm::vec3(0);
    const Image<methods::DifferenceTexel>& texels = objects[object].texels;
    const glm::vec2 corner = position - glm::vec2(objects[object].origin) - 0.5f;
    const glm::vec2 base = glm::floor(corner);
    const glm::vec2 t = corner - base;
    const auto at = [&](int dx, int dy) {
        return range.difference(texels(mirroredIndex(int(base.x) + dx, texels.width()),
                                       mirroredIndex(int(base.y) + dy, texels.height())));
    };
    return glm::mix(glm::mix(at(0, 0), at(1, 0), t.x), glm::mix(at(0, 1), at(1, 1), t.x), t.y);
}

std::vector<methods::TexturePlacement> ViewTexture::motions(const scene::Scene& scene,
                                                            const scene::Camera& now, int nowWidth,
                                                            int nowHeight) const {
    std::vector<methods::TexturePlacement> motions(scene.objects.size());
    const bool isSameView = now == camera && nowWidth == width && nowHeight == height;
    methods::ViewAlignedParams scaled;
    scaled.followZoom = true;
    for (std::size_t i = 0; i < std::min(motions.size(), objects.size()); ++i) {
        const scene::Object& object = scene.objects[i];
        if (!object.mesh || (isSameView && object.transform == objects[i].transform)) continue;
        motions[i] = methods::follow(
            {}, *object.mesh,
            {camera.view() * objects[i].transform, camera.projection(width, height), width, height},
            {now.view() * object.transform, now.projection(nowWidth, nowHeight), nowWidth, nowHeight},
            scaled);
    }
    return motions;
}

std::size_t ViewTexture::bytes() const {
    std::size_t bytes = 0;
    for (const Object& object : objects)
        bytes += object.texels.pixelCount() * sizeof(methods::DifferenceTexel);
    return bytes;
}

ViewTexture viewTexture(const methods::ImageBasedTexture& made, const scene::Scene& scene,
                        const scene::Camera& camera, int width, int height, const Task& task) {
    ViewTexture texture;
    texture.camera = camera;
    texture.width = width;
    texture.height = height;
    float largest = 0;
    for (const methods::ObjectTexture& object : made.objects)
        largest = std::max(largest, methods::largestDifference(object.pixels));
    texture.range = methods::DifferenceRange::of(largest);
    for (std::size_t i = 0; i < made.objects.size(); ++i) {
        task.checkpoint();
        texture.objects.push_back({made.objects[i].origin - margin, {}, scene.objects[i].transform});
        if (made.objects[i].pixels.empty()) continue;
        texture.objects.back().texels = extended(made.objects[i], texture.range);
    }
    return texture;
}

}  // namespace chiaro::widgets
