#pragma once

#include <bit>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace chiaro::scene {

/// A value at an offset of a binary file, which must hold it; in the file's byte order, wherever it lies.
template <class T>
T valueAt(std::string_view bytes, std::size_t offset, std::endian order = std::endian::little) {
    static_assert(std::is_arithmetic_v<T>);
    char buffer[sizeof(T)];
    std::memcpy(buffer, bytes.data() + offset, sizeof(T));
    if (order != std::endian::native)
        for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(buffer[i], buffer[sizeof(T) - 1 - i]);
    T value;
    std::memcpy(&value, buffer, sizeof(T));
    return value;
}

}  // namespace chiaro::scene
