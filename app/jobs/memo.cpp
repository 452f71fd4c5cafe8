#include "app/jobs/memo.h"

namespace chiaro::app {

std::shared_ptr<const void> Memo::findAny(std::uint64_t key) {
    const auto found = m_index.find(key);
    if (found == m_index.end()) return nullptr;
    m_entries.splice(m_entries.begin(), m_entries, found->second);
    return found->second->value;
}

void Memo::insertAny(std::uint64_t key, std::shared_ptr<const void> value, std::size_t bytes) {
    if (const auto found = m_index.find(key); found != m_index.end()) {
        m_bytes -= found->second->bytes;
        m_entries.erase(found->second);
        m_index.erase(found);
    }
    m_entries.push_front({key, std::move(value), bytes});
    m_index.emplace(key, m_entries.begin());
    m_bytes += bytes;
    // The newest stays even when it alone is over the budget: it is about to be used.
    while (m_bytes > m_budget && m_entries.size() > 1) {
        m_bytes -= m_entries.back().bytes;
        m_index.erase(m_entries.back().key);
        m_entries.pop_back();
    }
}

}  // namespace chiaro::app
