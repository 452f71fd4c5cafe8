#include "core/base/codec/image_decode.h"

#include "core/base/codec/claimed_sizes.h"
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
        if (m_format == ImageFormat::Png && !pngChunksFit(path)) throw damaged("it ends within a chunk");
        if (m_format == ImageFormat::OpenExr && !openExrHeaderFits(path))
            throw damaged("it is smaller than its header says");
        m_input = OIIO::ImageInput::create(codecName(m_format));
        if (!m_input)
            throw Error(path.string(), fmt::format("{} can't be read on this machine", displayName(m_format)),
                        "convert the picture to PNG");
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        if (!m_input->open(path.string(), m_spec, config)) throw damaged(m_input->geterror());
    }

    const OIIO::ImageSpec& spec() const { return m_spec; }

    StoredImage read(const AllocateValues& allocate) {
        checkImageSize(m_path, m_spec.width, m_spec.height, m_limits);
        checkTiles();
        if (m_spec.deep || m_spec.depth > 1)
            throw Error(m_path.string(), "holds several values in depth at each pixel",
                        "save it as a flat picture");
        const bool isOpenExr = m_format == ImageFormat::OpenExr;
        StoredImage stored = decode(choose(), allocate);
        stored.isPremultiplied =
            !m_limits.asVectors && m_spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
        stored.isLinear = isOpenExr;
        stored.orientation = m_spec.get_int_attribute("Orientation", 1);
        if (isOpenExr) placeInDisplayWindow(stored);
        return stored;
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

    /// Even a blank JPEG is a two-hundredth of its pixels; only what was made to fill memory packs a large
    /// picture tighter. And neither PNG nor TIFF packs three thousand bytes into one: there the file is cut
    /// off.
    void checkExpansion(std::size_t bytes, std::string_view what) const {
        constexpr std::size_t harmless = 192 << 20, small = 16 << 20;
        std::error_code ignored;
        const std::uintmax_t size = fs::file_size(m_path, ignored);
        const bool isBomb = bytes > harmless && bytes / 250 > size;
        const bool isCutOff = m_format != ImageFormat::OpenExr && bytes > small && bytes / 3000 > size;
        if (!isBomb && !isCutOff) return;
        throw Error(
            m_path.string(),
            fmt::format("is {} kB large but its pixels{} would fill {} MB", size >> 10, what, bytes >> 20),
            "a picture of that size is never so small; save a smaller one");
    }

    /// Tiles are decoded as a whole, whatever the picture's size.
    void checkTiles() const {
        const auto pixels =
            std::uint64_t(std::max(m_spec.tile_width, 0)) * std::uint64_t(std::max(m_spec.tile_height, 0));
        if (pixels > m_limits.maximumPixels || pixels * m_spec.pixel_bytes(true) > (std::uint64_t(1) << 30) ||
            (pixels > 1 << 24 && pixels > 4 * m_spec.image_pixels()))
            throw Error(m_path.string(),
                        fmt::format("has tiles of {} x {} pixels", m_spec.tile_width, m_spec.tile_height),
                        "save it with tiles that are no larger than the picture, or with none");
    }

    StoredImage decode(const ChannelChoice& channels, const AllocateValues& allocate) {
        const auto [firstChannel, lastChannel] = std::minmax_element(channels.begin(), channels.end());
        const int first = *firstChannel;
        StoredImage stored;
        stored.width = stored.canvasWidth = m_spec.width;
        stored.height = stored.canvasHeight = m_spec.height;
        stored.stride = *lastChannel - first + 1;
        stored.channelCount = int(channels.size());
        for (std::size_t k = 0; k < channels.size(); ++k) stored.channels[k] = channels[k] - first;
        OIIO::TypeDesc type = OIIO::TypeDesc::FLOAT;
        stored.type = StoredImage::Values::Float;
        if (m_spec.format.basetype == OIIO::TypeDesc::UINT8) {
            type = OIIO::TypeDesc::UINT8;
            stored.type = StoredImage::Values::Bits8;
        } else if (m_spec.format.basetype == OIIO::TypeDesc::UINT16) {
            type = OIIO::TypeDesc::UINT16;
            stored.type = StoredImage::Values::Bits16;
        }
        checkExpansion(stored.byteCount(), "");
        const bool complete =
            m_input->read_image(0, 0, first, first + stored.stride, type, allocate(stored.byteCount()));
        const std::string complaint = m_input->geterror();
        if (!complete || !complaint.empty()) throw damaged(complaint);
        return stored;
    }

    void placeInDisplayWindow(StoredImage& stored) const {
        checkImageSize(m_path, m_spec.full_width, m_spec.full_height, m_limits);
        const auto pixels = std::size_t(m_spec.full_width) * std::size_t(m_spec.full_height);
        checkExpansion(pixels * std::size_t(stored.channelCount) * sizeof(float), " and its display window");
        stored.x = m_spec.x - m_spec.full_x;
        stored.y = m_spec.y - m_spec.full_y;
        stored.canvasWidth = m_spec.full_width;
        stored.canvasHeight = m_spec.full_height;
    }

    fs::path m_path;
    ImageLimits m_limits;
    ImageFormat m_format;
    std::optional<QuietStandardError> m_quiet;
    std::unique_ptr<OIIO::ImageInput> m_input;
    OIIO::ImageSpec m_spec;
};

}  // namespace

StoredImage decodeImage(const fs::path& path, const ImageLimits& limits, const AllocateValues& allocate) {
    try {
        return PictureReader(path, limits).read(allocate);
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
