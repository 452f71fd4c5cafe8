#include "tests/fuzz/mutator.h"

#include "core/base/random.h"

#include <array>
#include <cctype>

namespace chiaro::test {

namespace {

constexpr std::size_t largest = 65536;

/// One file while it is spoiled.
class Spoiler {
public:
    Spoiler(std::string bytes, const std::vector<std::string>& seeds, Random& random)
        : m_bytes(std::move(bytes)), m_seeds(seeds), m_random(random) {}

    void change() {
        if (m_bytes.empty()) return;
        switch (m_random.below(10)) {
            case 0:
            case 1:
                return flipBit();
            case 2:
                return setByte();
            case 3:
                return truncate();
            case 4:
                return splice();
            case 5:
                return erase();
            case 6:
                return repeat();
            case 7:
            case 8:
                return setLength();
            default:
                return setNumber();
        }
    }

    std::string take() { return m_bytes.substr(0, largest); }

private:
    /// Lengths, offsets and types stand at the beginning more often than not.
    std::size_t place() {
        const std::size_t size = m_bytes.size();
        return m_random.below(2) == 0 ? m_random.below(std::min<std::size_t>(size, 200))
                                      : m_random.below(size);
    }
    std::size_t lengthFrom(std::size_t at, const std::string& bytes) {
        return 1 + m_random.below(std::min<std::size_t>(bytes.size() - at, 64));
    }

    void flipBit() {
        char& byte = m_bytes[place()];
        byte = char(byte ^ (1 << m_random.below(8)));
    }
    void setByte() { m_bytes[place()] = "\x00\xff\x7f\x80\x01\n \""[m_random.below(8)]; }
    void truncate() { m_bytes.resize(m_random.below(m_bytes.size())); }
    void splice() {
        const std::string& other = m_seeds[m_random.below(m_seeds.size())];
        const std::size_t from = m_random.below(other.size());
        const std::string part = other.substr(from, lengthFrom(from, other));
        const std::size_t to = place();
        if (m_random.below(2) == 0)
            m_bytes.insert(to, part);
        else
            m_bytes.replace(to, part.size(), part);
    }
    void erase() {
        const std::size_t from = place();
        m_bytes.erase(from, lengthFrom(from, m_bytes));
    }
    void repeat() {
        const std::size_t from = place();
        const std::string part = m_bytes.substr(from, lengthFrom(from, m_bytes));
        const std::size_t times = std::array{1, 2, 50, 300}[m_random.below(4)];
        std::string copies;
        for (std::size_t i = 0; i < times; ++i) copies += part;
        m_bytes.insert(from, copies);
    }

    /// Two or four bytes become a number that arithmetic trips over.
    void setLength() {
        static constexpr std::uint32_t numbers[] = {
            0,          1,          0x7f,       0xff,       0x7fff,     0xffff,     0x10000, 0x00ffffff,
            0x7fffffff, 0x80000000, 0xfffffffe, 0xffffffff, 0x40000000, 0x15555556, 100'000};
        const std::uint32_t number = numbers[m_random.below(std::size(numbers))];
        const std::size_t size = m_random.below(2) == 0 ? 2 : 4;
        const bool bigEndian = m_random.below(2) == 0;
        const std::size_t at = place();
        for (std::size_t i = 0; i < size && at + i < m_bytes.size(); ++i)
            m_bytes[at + i] = char(number >> (8 * (bigEndian ? size - 1 - i : i)));
    }

    /// The number that stands at or behind some place, in a text.
    void setNumber() {
        static constexpr const char* numbers[] = {"-1",
                                                  "0",
                                                  "99999999999999999999",
                                                  "1e308",
                                                  "-1e39",
                                                  "nan",
                                                  "inf",
                                                  "1e-45",
                                                  "4294967295",
                                                  "2147483648",
                                                  "0x10",
                                                  "1e",
                                                  "-",
                                                  "18446744073709551615",
                                                  "3.5",
                                                  "65536",
                                                  "\"7\"",
                                                  "null",
                                                  "[]"};
        const auto isDigit = [&](std::size_t i) {
            return std::isdigit(static_cast<unsigned char>(m_bytes[i])) != 0;
        };
        std::size_t from = m_random.below(m_bytes.size());
        while (from < m_bytes.size() && !isDigit(from)) ++from;
        std::size_t to = from;
        while (to < m_bytes.size() && (isDigit(to) || m_bytes[to] == '.')) ++to;
        m_bytes.replace(from, to - from, numbers[m_random.below(std::size(numbers))]);
    }

    std::string m_bytes;
    const std::vector<std::string>& m_seeds;
    Random& m_random;
};

}  // namespace

std::string Mutator::mutation(std::uint64_t number) const {
    Random random(number);
    Spoiler spoiler(m_seeds[random.below(m_seeds.size())], m_seeds, random);
    for (std::size_t changes = 1 + random.below(4); changes > 0; --changes) spoiler.change();
    return spoiler.take();
}

}  // namespace chiaro::test
