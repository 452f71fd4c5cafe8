#pragma once

#include "core/methods/view_textures.h"

#include <filesystem>
#include <optional>

namespace chiaro::project {

/// Keeps the textures of objects' views on disk from one run to the next, because they are the slowest thing
/// to make: one file under the hash of what it was made from, the ones not used for longest removed first
/// when they outgrow the bound. What is there is never trusted: a file that is cut off, altered or of another
/// version counts as missing and is removed. Several programs may share a folder. Failing to write is no
/// error: the textures are made again next time.
class TextureCache {
public:
    /// `folder` may not exist yet; when it is empty nothing is kept.
    explicit TextureCache(std::filesystem::path folder, std::uintmax_t maximumBytes = std::uintmax_t(2)
                                                                                      << 30);

    std::optional<methods::ViewTextures> find(std::uint64_t key) const;
    void store(std::uint64_t key, const methods::ViewTextures& textures) const;

    /// The platform's place for what can be made again: $XDG_CACHE_HOME/chiaro, or ~/.cache/chiaro; empty
    /// when there is neither.
    static std::filesystem::path standardFolder();

private:
    std::filesystem::path fileOf(std::uint64_t key) const;
    void removeOldest() const;

    std::filesystem::path m_folder;
    std::uintmax_t m_maximumBytes;
};

}  // namespace chiaro::project
