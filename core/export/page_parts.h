#pragma once

#include "core/base/task.h"
#include "core/methods/difference_texels.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiaro::exporting {

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// What a page holds besides its text: bytes that its script asks for by their number.
class PageParts {
public:
    /// `path` is only named in errors.
    explicit PageParts(std::filesystem::path path) : m_path(std::move(path)) {}

    /// Adds bytes, made smaller (zlib). Their number.
    std::size_t add(std::string_view bytes);
    template <class Value>
    std::size_t add(const std::vector<Value>& values) {
        return add(
            std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)));
    }
    /// Adds pictures of width x height texels each, one after the other in `texels`, as JPEG of
    /// this quality, 1..100. Their numbers.
    std::vector<std::size_t> addPictures(std::span<const methods::DifferenceTexel> texels, int width,
                                         int height, int quality, const Task& task = {});
    /// An element for each, to stand in a page.
    std::string html() const;

private:
    std::filesystem::path m_path;
    std::vector<std::string> m_parts;
};

}  // namespace chiaro::exporting
