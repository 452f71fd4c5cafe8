#include "core/base/codec/image_decode.h"

#include "core/base/error.h"
#include "core/base/image_format.h"
#include "core/base/image_layout.h"

#include <OpenImageIO/imageio.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <fcntl.h>
#include <mutex>
#include <new>
#include <optional>
#include <unistd.h>

namespace chiaro {

namespace fs = std::filesystem;

namespace {

/// libpng prints its complaints on stderr behind the library's back; they come again as our own sentence.
class QuietStandardError {
public:
    QuietStandardError() {
        const std::lock_guard lock(sharedMutex);
        if (sharedDepth++ > 0) return;
        sharedHandle = ::dup(STDERR_FILENO);
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (sharedHandle >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
        if (nowhere >= 0) ::close(nowhere);
    }
    ~QuietStandardError() {
        const std::lock_guard lock(sharedMutex);
        if (--sharedDepth > 0 || sharedHandle < 0) return;
        ::dup2(sharedHandle, STDERR_FILENO);
        ::close(sharedHandle);
    }
    QuietStandardError(const QuietStandardError&) = delete;
    QuietStandardError& operator=(const QuietStandardError&) = delete;

private:
    static inline std::mutex sharedMutex;
    static inline int sharedDepth = 0;
    static inline int sharedHandle = -1;
};

/// One picture file while it is read: every failure becomes an Error that names it.
class PictureReader {
public:
    PictureReader(const fs::path& path, const ImageLimits& limits)
        : m_path(path), m_limits(limits), m_format(sniffImageFormat(path)) {
        if (m_format == ImageFormat::Png) m_quiet.emplace();
        m_input = OIIO::ImageInput::create(codecName(m_format));
        if (!m_input)
            throw Error(path.string(), fmt::format("{} can't be read on this machine", displayName(m_format)),
                        "convert the picture to PNG");
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        if (!m_input->open(path.string(), m_spec, config)) throw damaged(m_input->geterror());
    }

    const OIIO::ImageSpec& spec() const { return m_spec; }

    DecodedImage read() {
        checkSize(m_spec.width, m_spec.height);
        if (m_spec.deep || m_spec.depth > 1)
            throw Error(m_path.string(), "holds several values in depth at each pixel",
                        "save it as a flat picture");
        const ChannelChoice channels = choose();
        DecodedImage image = decode(channels);
        if (!m_limits.mayBeNotFinite && !allFinite(image.values))
            throw Error(m_path.string(), "has pixels that are not finite numbers",
                        "replace the NaN and infinite pixels and save it again");
        const bool associated =
            !m_limits.asVectors && m_spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
        if (associated) unpremultiply(image);
        image.linear = m_format == ImageFormat::OpenExr;
        if (m_format == ImageFormat::OpenExr) image = withinDisplayWindow(std::move(image));
        return upright(std::move(image), m_spec.get_int_attribute("Orientation", 1));
    }

private:
    /// The library's reason: its first line, without the file's name, which stands in front already.
    Error damaged(std::string reason) const {
        const std::string name = m_path.string();
        reason = reason.substr(0, reason.find('\n'));
        for (const std::string& mention : {" (\"" + name + "\")", " \"" + name + "\"", name})
            if (const auto at = reason.find(mention); at != std::string::npos)
                reason.erase(at, mention.size());
        while (!reason.empty() && reason.back() == '.') reason.pop_back();
        return Error(name,
                     fmt::format("the {} file can't be decoded{}", displayName(m_format),
                                 reason.empty() ? "" : " (" + reason.substr(0, 160) + ")"),
                     "it may be damaged or cut off, so copy it or save it again");
    }

    void checkSize(int width, int height) const {
        const auto pixels = std::uint64_t(std::max(width, 0)) * std::uint64_t(std::max(height, 0));
        if (pixels > 0 && pixels <= m_limits.maximumPixels && width <= m_limits.maximumSide &&
            height <= m_limits.maximumSide)
            return;
        throw Error(m_path.string(), fmt::format("is {} x {} pixels", width, height),
                    fmt::format("pictures may be up to {} pixels wide or high and {} megapixels",
                                m_limits.maximumSide, m_limits.maximumPixels / 1'000'000));
    }

    ChannelChoice chooseForVectors() const {
        const bool isOpenExr = m_format == ImageFormat::OpenExr;
        const ChannelChoice channels = isOpenExr ? chooseVectors(m_spec.channelnames) : ChannelChoice{};
        if (channels.empty())
            throw Error(m_path.string(),
                        isOpenExr ? fmt::format("has no X and Y channels, but {}",
                                                fmt::join(m_spec.channelnames, ", "))
                                  : "is no OpenEXR file",
                        "save two float channels, X and Y, as OpenEXR");
        return channels;
    }

    ChannelChoice choose() const {
        if (m_limits.asVectors) return chooseForVectors();
        const ChannelChoice channels = m_format == ImageFormat::OpenExr
                                           ? chooseByName(m_spec.channelnames)
                                           : chooseByCount(m_spec.nchannels, m_spec.alpha_channel);
        if (channels.empty())
            throw Error(
                m_path.string(),
                fmt::format("has no R, G, B or Y channels, but {}", fmt::join(m_spec.channelnames, ", ")),
                "save a picture with colour or grey channels");
        const auto [first, last] = std::minmax_element(channels.begin(), channels.end());
        if (std::uint64_t(*last - *first + 1) * m_spec.image_pixels() > 4 * m_limits.maximumPixels)
            throw Error(m_path.string(), fmt::format("has {} channels", m_spec.nchannels),
                        "save a picture with red, green and blue alone");
        return channels;
    }

    DecodedImage decode(const ChannelChoice& channels) {
        switch (m_spec.format.basetype) {
            case OIIO::TypeDesc::UINT8:
                return decodeAs<std::uint8_t>(channels, OIIO::TypeDesc::UINT8);
            case OIIO::TypeDesc::UINT16:
                return decodeAs<std::uint16_t>(channels, OIIO::TypeDesc::UINT16);
            default:
                return decodeAs<float>(channels, OIIO::TypeDesc::FLOAT);
        }
    }

    /// Integers are divided here, since the library multiplies by a rounded reciprocal.
    template <class Value>
    DecodedImage decodeAs(const ChannelChoice& channels, OIIO::TypeDesc type) {
        const auto [firstChannel, lastChannel] = std::minmax_element(channels.begin(), channels.end());
        const int first = *firstChannel;
        const std::size_t stride = std::size_t(*lastChannel - first + 1);
        const std::size_t pixels = m_spec.image_pixels();
        std::vector<Value> stored(pixels * stride);
        const bool complete = m_input->read_image(0, 0, first, first + int(stride), type, stored.data());
        const std::string complaint = m_input->geterror();
        if (!complete || !complaint.empty()) throw damaged(complaint);

        DecodedImage image{m_spec.width, m_spec.height, int(channels.size()), false, {}, 0};
        if (std::is_integral_v<Value>) image.bits = int(8 * sizeof(Value));
        image.values.resize(pixels * channels.size());
        float* to = image.values.data();
        for (std::size_t pixel = 0; pixel < pixels; ++pixel)
            for (const int channel : channels)
                *to++ = unitValue(stored[pixel * stride + std::size_t(channel - first)]);
        return image;
    }

    static float unitValue(std::uint8_t value) { return float(value) / 255.0f; }
    static float unitValue(std::uint16_t value) { return float(value) / 65535.0f; }
    static float unitValue(float value) { return value; }

    DecodedImage withinDisplayWindow(DecodedImage image) const {
        if (m_spec.full_width == m_spec.width && m_spec.full_height == m_spec.height &&
            m_spec.x == m_spec.full_x && m_spec.y == m_spec.full_y)
            return image;
        checkSize(m_spec.full_width, m_spec.full_height);
        return placed(image, m_spec.x - m_spec.full_x, m_spec.y - m_spec.full_y, m_spec.full_width,
                      m_spec.full_height);
    }

    fs::path m_path;
    ImageLimits m_limits;
    ImageFormat m_format;
    std::optional<QuietStandardError> m_quiet;
    std::unique_ptr<OIIO::ImageInput> m_input;
    OIIO::ImageSpec m_spec;
};

}  // namespace

DecodedImage decodeImage(const fs::path& path, const ImageLimits& limits) {
    try {
        return PictureReader(path, limits).read();
    } catch (const std::bad_alloc&) {
        throw Error(path.string(), "takes more memory than there is", "make the picture smaller");
    }
}

ImageMetadata decodeMetadata(const fs::path& path) {
    const PictureReader reader(path, {});
    ImageMetadata metadata;
    for (const OIIO::ParamValue& attribute : reader.spec().extra_attribs)
        if (attribute.type() == OIIO::TypeDesc::STRING)
            metadata[attribute.name().string()] = attribute.get_string();
    // TIFF and JPEG have no place for entries of our own: they stand as lines in the description.
    const std::string description = metadata.contains("ImageDescription") ? metadata["ImageDescription"] : "";
    for (std::size_t begin = 0; begin < description.size();) {
        const std::size_t end = std::min(description.find('\n', begin), description.size());
        const std::string line = description.substr(begin, end - begin);
        if (const auto colon = line.find(": "); colon != std::string::npos)
            metadata.emplace(line.substr(0, colon), line.substr(colon + 2));
        begin = end + 1;
    }
    return metadata;
}

}  // namespace chiaro
