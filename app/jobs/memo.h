#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <unordered_map>

namespace chiaro::app {

/// Derived results under the content hash of what they came from, so that an undo finds its result still
/// there. Bounded: the least recently used go first. A hash names the kind of result too, so types never mix.
class Memo {
public:
    explicit Memo(std::size_t byteBudget) : m_budget(byteBudget) {}

    /// Null when it isn't there.
    template <class T>
    std::shared_ptr<const T> find(std::uint64_t key) {
        return std::static_pointer_cast<const T>(findAny(key));
    }
    template <class T>
    void insert(std::uint64_t key, std::shared_ptr<const T> value, std::size_t bytes) {
        insertAny(key, std::move(value), bytes);
    }
    std::size_t bytes() const { return m_bytes; }

private:
    struct Entry {
        std::uint64_t key;
        std::shared_ptr<const void> value;
        std::size_t bytes;
    };
    std::shared_ptr<const void> findAny(std::uint64_t key);
    void insertAny(std::uint64_t key, std::shared_ptr<const void> value, std::size_t bytes);

    std::size_t m_budget;
    std::size_t m_bytes = 0;
    std::list<Entry> m_entries;  ///< most recently used first
    std::unordered_map<std::uint64_t, std::list<Entry>::iterator> m_index;
};

}  // namespace chiaro::app
