#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

namespace chiaro {

/// Content hash under which derived results are memoised. Stable within a version, not across machines of
/// different byte order; not cryptographic.
class Hasher {
public:
    Hasher& bytes(const void* data, std::size_t size);

    template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T> Hasher& add(T value) {
        return bytes(&value, sizeof value);
    }
    Hasher& add(std::string_view text) { return add(text.size()).bytes(text.data(), text.size()); }
    /// Pixels and other padding-free values.
    template <class T>
    Hasher& add(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        return add(values.size()).bytes(values.data(), values.size_bytes());
    }

    std::uint64_t value() const;

private:
    std::uint64_t m_state = 0x243F6A8885A308D3ULL;
};

}  // namespace chiaro
