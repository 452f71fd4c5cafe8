#include "core/base/image_layout.h"

#include <algorithm>
#include <cctype>

namespace chiaro {

namespace {

int indexOf(const std::vector<std::string>& names, const std::string& name) {
    const auto same = [&](const std::string& other) {
        return std::equal(name.begin(), name.end(), other.begin(), other.end(), [](char a, char b) {
            return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
        });
    };
    const auto found = std::find_if(names.begin(), names.end(), same);
    return found == names.end() ? -1 : int(found - names.begin());
}

ChannelChoice chooseInLayer(const std::vector<std::string>& names, const std::string& layer) {
    ChannelChoice channels{indexOf(names, layer + "R"), indexOf(names, layer + "G"),
                           indexOf(names, layer + "B")};
    if (std::count(channels.begin(), channels.end(), -1) > 0) channels = {indexOf(names, layer + "Y")};
    if (channels.front() < 0) return {};
    if (const int alpha = indexOf(names, layer + "A"); alpha >= 0) channels.push_back(alpha);
    return channels;
}

}  // namespace

ChannelChoice chooseByName(const std::vector<std::string>& names) {
    if (const ChannelChoice channels = chooseInLayer(names, ""); !channels.empty()) return channels;
    if (names.size() == 1) return {0};
    for (const std::string& name : names) {
        const std::size_t dot = name.rfind('.');
        if (dot == std::string::npos) continue;
        if (const ChannelChoice channels = chooseInLayer(names, name.substr(0, dot + 1)); !channels.empty())
            return channels;
    }
    return {};
}

ChannelChoice chooseVectors(const std::vector<std::string>& names) {
    for (const auto& [first, second] : {std::pair("X", "Y"), std::pair("R", "G")}) {
        if (const ChannelChoice pair{indexOf(names, first), indexOf(names, second)};
            pair[0] >= 0 && pair[1] >= 0)
            return pair;
        for (const std::string& name : names) {
            const std::string layer = name.substr(0, name.rfind('.') + 1);
            if (layer.empty()) continue;
            const ChannelChoice pair{indexOf(names, layer + first), indexOf(names, layer + second)};
            if (pair[0] >= 0 && pair[1] >= 0) return pair;
        }
    }
    return {};
}

ChannelChoice chooseByCount(int count, int alpha) {
    if (count <= 0) return {};
    ChannelChoice channels = count < 3 ? ChannelChoice{0} : ChannelChoice{0, 1, 2};
    if (count == 2 && alpha < 0) alpha = 1;
    if (alpha >= int(channels.size())) channels.push_back(alpha);
    return channels;
}

bool allFinite(std::span<const float> values) {
    return std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
}

void unpremultiply(DecodedImage& image) {
    if (image.channels % 2 != 0) return;
    const std::size_t channels = std::size_t(image.channels);
    for (std::size_t i = 0; i < image.values.size(); i += channels) {
        const float alpha = image.values[i + channels - 1];
        if (alpha <= 0 || alpha == 1) continue;
        for (std::size_t channel = 0; channel + 1 < channels; ++channel) image.values[i + channel] /= alpha;
    }
}

DecodedImage upright(DecodedImage image, int orientation) {
    if (orientation < 2 || orientation > 8) return image;
    // Orientation 5..8 store rows as columns; the others differ in which end of each comes first.
    const bool transposed = orientation >= 5;
    const bool fromRight = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool fromBottom = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    DecodedImage turned{image.width, image.height, image.channels, image.linear, {}, image.bits};
    if (transposed) std::swap(turned.width, turned.height);
    turned.values.resize(image.values.size());
    const std::size_t channels = std::size_t(image.channels);
    float* to = turned.values.data();
    for (int y = 0; y < turned.height; ++y) {
        for (int x = 0; x < turned.width; ++x) {
            int column = transposed ? y : x;
            int row = transposed ? x : y;
            if (fromRight) column = image.width - 1 - column;
            if (fromBottom) row = image.height - 1 - row;
            const std::size_t pixel = std::size_t(row) * std::size_t(image.width) + std::size_t(column);
            to = std::copy_n(image.values.data() + pixel * channels, channels, to);
        }
    }
    return turned;
}

DecodedImage placed(const DecodedImage& image, int x, int y, int width, int height) {
    DecodedImage canvas{width, height, image.channels, image.linear, {}, image.bits};
    const std::size_t channels = std::size_t(image.channels);
    canvas.values.resize(std::size_t(width) * std::size_t(height) * channels, 0.0f);
    const int left = std::max(x, 0);
    const int right = int(std::min<std::int64_t>(std::int64_t(x) + image.width, width));
    if (left >= right) return canvas;
    for (int row = std::max(y, 0); row < std::min<std::int64_t>(std::int64_t(y) + image.height, height);
         ++row) {
        const std::size_t from = std::size_t(row - y) * std::size_t(image.width) + std::size_t(left - x);
        const std::size_t to = std::size_t(row) * std::size_t(width) + std::size_t(left);
        std::copy_n(image.values.data() + from * channels, std::size_t(right - left) * channels,
                    canvas.values.data() + to * channels);
    }
    return canvas;
}

}  // namespace chiaro
