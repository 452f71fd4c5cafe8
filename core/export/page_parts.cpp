#include "core/export/page_parts.h"

#include "core/base/codec/codec.h"
#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>
#include <tbb/parallel_for.h>

#include <zlib.h>

namespace chiaro::exporting {

std::string base64(std::string_view bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? std::uint8_t(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::size_t PageParts::add(std::string_view bytes) {
    uLongf size = compressBound(bytes.size());
    std::string deflated(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(deflated.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9) != Z_OK)
        throw Error(m_path.string(), "could not be compressed", "choose a simpler mesh");
    deflated.resize(size);
    m_parts.push_back(std::move(deflated));
    return m_parts.size() - 1;
}

std::vector<std::size_t> PageParts::addPictures(std::span<const methods::DifferenceTexel> texels, int width,
                                                int height, int quality, const Task& task) {
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < texels.size() / pixels; ++i) numbers.push_back(m_parts.size() + i);
    m_parts.resize(m_parts.size() + numbers.size());
    Task::Steps steps(task, numbers.size());
    tbb::parallel_for(std::size_t(0), numbers.size(), [&](std::size_t i) {
        std::vector<std::uint8_t> values;
        values.reserve(3 * pixels);
        for (const methods::DifferenceTexel& texel : texels.subspan(i * pixels, pixels))
            values.insert(values.end(), texel.begin(), texel.begin() + 3);
        m_parts[numbers[i]] = imageCodec().encode({m_path,
                                                   ImageFormat::Jpeg,
                                                   width,
                                                   height,
                                                   3,
                                                   EncodeRequest::Values::Bits8,
                                                   values.data(),
                                                   {},
                                                   quality});
        steps.done();
    });
    return numbers;
}

std::string PageParts::html() const {
    std::string html;
    for (std::size_t i = 0; i < m_parts.size(); ++i)
        html +=
            fmt::format("<script type=\"text/plain\" id=\"part-{}\">{}</script>\n", i, base64(m_parts[i]));
    return html;
}

}  // namespace chiaro::exporting
