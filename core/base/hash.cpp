#include "core/base/hash.h"

namespace chiaro {

namespace {

/// Folded 64 x 64 multiplication, the mixing step of wyhash (Wang Yi, public domain).
std::uint64_t fold(std::uint64_t a, std::uint64_t b) {
    __extension__ using Wide = unsigned __int128;
    const Wide product = Wide(a) * b;
    return std::uint64_t(product) ^ std::uint64_t(product >> 64);
}

}  // namespace

Hasher& Hasher::bytes(const void* data, std::size_t size) {
    const auto* at = static_cast<const unsigned char*>(data);
    for (; size > 0;) {
        std::uint64_t word = 0;
        const std::size_t taken = std::min<std::size_t>(size, sizeof word);
        std::memcpy(&word, at, taken);
        m_state = fold(m_state ^ word ^ 0x9E3779B97F4A7C15ULL, 0xD6E8FEB86659FD93ULL ^ (taken << 56));
        at += taken;
        size -= taken;
    }
    return *this;
}

std::uint64_t Hasher::value() const {
    return fold(m_state ^ 0xA0761D6478BD642FULL, 0xE7037ED1A0B428DBULL);
}

}  // namespace chiaro
