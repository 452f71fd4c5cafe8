#pragma once

#include "core/base/helper/file_handle.h"

#include <cstddef>
#include <span>

namespace chiaro::helper {

/// Bytes mapped into this process; unmapped with their owner.
class Mapping {
public:
    Mapping() = default;
    Mapping(int descriptor, std::size_t size, bool writable);
    ~Mapping();
    Mapping(Mapping&& other) noexcept;
    Mapping& operator=(Mapping&& other) noexcept;

    std::byte* data() const { return m_data; }
    std::size_t size() const { return m_size; }

private:
    std::byte* m_data = nullptr;
    std::size_t m_size = 0;
};

/// Memory that one process fills and then hands to another, for good: sealed, it can neither change nor
/// shrink, so what the other has checked stays true.
class SharedWriter {
public:
    /// Zeros. Throws std::bad_alloc.
    explicit SharedWriter(std::size_t size);
    std::byte* data() const { return m_mapping.data(); }
    /// To be sent; nothing is written any more.
    FileHandle seal();

private:
    FileHandle m_file;
    Mapping m_mapping;
};

/// What a SharedWriter sealed.
class SharedBytes {
public:
    SharedBytes() = default;
    /// Throws std::runtime_error when the handle isn't sealed memory; std::bad_alloc.
    explicit SharedBytes(const FileHandle& sealed);
    std::span<const std::byte> bytes() const { return {m_mapping.data(), m_mapping.size()}; }

private:
    Mapping m_mapping;
};

}  // namespace chiaro::helper
