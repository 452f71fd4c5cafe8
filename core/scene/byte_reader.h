#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
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

/// A number that should be a whole one, for a message: "7", "-1000000000000000" for all that is less, "nan".
inline std::string wholeNumberText(double value) {
    if (std::isnan(value)) return "nan";
    return std::to_string((long long)(std::clamp(value, -1e15, 1e15)));
}

}  // namespace chiaro::scene
