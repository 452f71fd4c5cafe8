#include "core/project/texture_cache.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/hash.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdlib>

namespace chiaro::project {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t magic = 0x3153574549564843;  // "CHVIEWS1", little endian: another layout gets another
constexpr int largestSide = 1 << 14;
constexpr std::uint64_t mostParts = 4096;  ///< views, and levels of a view
const char* const extension = ".views";

/// What stands before the values.
struct Header {
    std::uint64_t magic;
    std::uint64_t key;
    std::uint64_t bytes;  ///< of the values
    std::uint64_t hash;   ///< of the values
};

class Writer {
public:
    template <class Value>
    void add(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void addTexels(const Image<methods::PackedTexel>& image) {
        add(image.width());
        add(image.height());
        m_bytes.append(reinterpret_cast<const char*>(image.pixels().data()), image.pixels().size_bytes());
    }
    const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

/// Reads values one after the other and throws Damaged beyond the end or at an impossible number.
class Damaged {};
class Reader {
public:
    explicit Reader(std::string_view bytes) : m_bytes(bytes) {}

    template <class Value>
    Value take() {
        Value value;
        std::memcpy(&value, next(sizeof value), sizeof value);
        return value;
    }
    std::uint64_t takeCount() {
        const auto count = take<std::uint64_t>();
        if (count > mostParts) throw Damaged();
        return count;
    }
    Image<methods::PackedTexel> takeTexels() {
        const int width = take<int>(), height = take<int>();
        if (width < 1 || height < 1 || width > largestSide || height > largestSide) throw Damaged();
        const std::size_t bytes = std::size_t(width) * std::size_t(height) * sizeof(methods::PackedTexel);
        const char* texels = next(bytes);
        Image<methods::PackedTexel> image(width, height);
        std::memcpy(image.pixels().data(), texels, bytes);
        return image;
    }
    bool atEnd() const { return m_bytes.empty(); }

private:
    const char* next(std::size_t count) {
        if (count > m_bytes.size()) throw Damaged();
        const char* here = m_bytes.data();
        m_bytes.remove_prefix(count);
        return here;
    }
    std::string_view m_bytes;
};

std::string valuesOf(const methods::ViewTextures& textures) {
    Writer writer;
    writer.add(std::uint64_t(textures.report.blocks));
    writer.add(textures.report.overlapError);
    writer.add(std::uint64_t(textures.views.size()));
    for (const methods::ViewTexture& view : textures.views) {
        writer.add(view.origin);
        writer.add(std::uint64_t(view.levels.size()));
        for (const auto& level : view.levels) writer.addTexels(level);
    }
    return writer.bytes();
}

methods::ViewTextures texturesFrom(std::string_view values) {
    Reader reader(values);
    methods::ViewTextures textures;
    textures.report.blocks = std::size_t(reader.take<std::uint64_t>());
    textures.report.overlapError = reader.take<double>();
    textures.views.resize(reader.takeCount());
    for (methods::ViewTexture& view : textures.views) {
        view.origin = reader.take<glm::ivec2>();
        const std::uint64_t levels = reader.takeCount();
        for (std::uint64_t i = 0; i < levels; ++i) view.levels.push_back(reader.takeTexels());
    }
    if (!reader.atEnd()) throw Damaged();
    return textures;
}

std::uint64_t hashOf(std::string_view bytes) {
    return Hasher().bytes(bytes.data(), bytes.size()).value();
}

}  // namespace

TextureCache::TextureCache(fs::path folder, std::uintmax_t maximumBytes)
    : m_folder(std::move(folder)), m_maximumBytes(maximumBytes) {}

fs::path TextureCache::standardFolder() {
    const char* const cache = std::getenv("XDG_CACHE_HOME");
    if (cache && fs::path(cache).is_absolute()) return fs::path(cache) / "chiaro";
    const char* const home = std::getenv("HOME");
    return home && *home ? fs::path(home) / ".cache" / "chiaro" : fs::path();
}

fs::path TextureCache::fileOf(std::uint64_t key) const {
    return m_folder / fmt::format("{:016x}{}", key, extension);
}

std::optional<methods::ViewTextures> TextureCache::find(std::uint64_t key) const {
    if (m_folder.empty()) return {};
    std::error_code ignored;
    const fs::path path = fileOf(key);
    if (!fs::exists(path, ignored)) return {};
    try {
        const std::string file = readFile(path, m_maximumBytes);
        if (file.size() < sizeof(Header)) throw Damaged();
        Header header;
        std::memcpy(&header, file.data(), sizeof header);
        const std::string_view values = std::string_view(file).substr(sizeof header);
        if (header.magic != magic || header.key != key || header.bytes != values.size() ||
            header.hash != hashOf(values))
            throw Damaged();
        methods::ViewTextures textures = texturesFrom(values);
        fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
        return textures;
    } catch (const Damaged&) {
    } catch (const Error&) {
    } catch (const std::bad_alloc&) {
    }
    fs::remove(path, ignored);
    return {};
}

void TextureCache::store(std::uint64_t key, const methods::ViewTextures& textures) const {
    if (m_folder.empty()) return;
    try {
        const std::string values = valuesOf(textures);
        if (values.size() + sizeof(Header) > m_maximumBytes) return;
        const Header header{magic, key, values.size(), hashOf(values)};
        writeFileAtomically(fileOf(key),
                            std::string(reinterpret_cast<const char*>(&header), sizeof header) + values);
        removeOldest();
    } catch (const std::exception&) {
        // No room, no right to write: the next run makes them again.
    }
}

void TextureCache::removeOldest() const {
    struct File {
        fs::file_time_type used;
        fs::path path;
        std::uintmax_t bytes;
    };
    std::vector<File> files;
    std::uintmax_t total = 0;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(m_folder, ignored)) {
        if (entry.path().extension() != extension) continue;
        files.push_back({entry.last_write_time(ignored), entry.path(), entry.file_size(ignored)});
        total += files.back().bytes;
    }
    std::ranges::sort(files, {}, &File::used);
    for (const File& file : files) {
        if (total <= m_maximumBytes) return;
        fs::remove(file.path, ignored);
        total -= file.bytes;
    }
}

}  // namespace chiaro::project
