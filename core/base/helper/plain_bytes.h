#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace chiaro::helper {

/// Plain values one behind the other, as they lie in this machine's memory: never for files.
class PlainWriter {
public:
    template <class Value>
    void add(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void addText(const std::string& text) {
        add(text.size());
        m_bytes += text;
    }
    std::string take() { return std::move(m_bytes); }

private:
    std::string m_bytes;
};

/// Reads what a PlainWriter wrote, and trusts nothing in it. Throws std::runtime_error past the end.
class PlainReader {
public:
    explicit PlainReader(std::span<const std::byte> bytes) : m_rest(bytes) {}
    explicit PlainReader(const std::string& bytes) : m_rest(std::as_bytes(std::span(bytes))) {}

    template <class Value>
    Value take() {
        static_assert(std::is_trivially_copyable_v<Value>);
        Value value;
        std::memcpy(&value, part(sizeof value).data(), sizeof value);
        return value;
    }
    std::string takeText() {
        const auto bytes = part(take<std::size_t>());
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    /// So many values.
    template <class Value>
    std::vector<Value> takeList(std::size_t count) {
        static_assert(std::is_trivially_copyable_v<Value>);
        if (count > m_rest.size() / sizeof(Value)) throw std::runtime_error("the answer ends too early");
        std::vector<Value> values(count);
        if (count > 0) std::memcpy(values.data(), part(count * sizeof(Value)).data(), count * sizeof(Value));
        return values;
    }
    bool atEnd() const { return m_rest.empty(); }

private:
    std::span<const std::byte> part(std::size_t size) {
        if (size > m_rest.size()) throw std::runtime_error("the answer ends too early");
        const auto part = m_rest.first(size);
        m_rest = m_rest.subspan(size);
        return part;
    }

    std::span<const std::byte> m_rest;
};

}  // namespace chiaro::helper
