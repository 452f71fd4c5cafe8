#include "core/base/memory_reserve.h"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>

namespace chiaro {

namespace {

constexpr std::size_t reserveBytes = 4 << 20;

std::atomic<void*> sharedReserve{nullptr};

void giveReserveAway() {
    void* const reserve = sharedReserve.exchange(nullptr);
    if (!reserve) throw std::bad_alloc();
    std::free(reserve);  // `new` tries again
}

}  // namespace

void keepMemoryReserve() {
    std::set_new_handler(giveReserveAway);
    if (sharedReserve.load()) return;
    void* reserve = std::malloc(reserveBytes);
    if (!reserve) return;
    std::memset(reserve, 1, reserveBytes);  // pages that were never written to are not there yet
    void* none = nullptr;
    if (!sharedReserve.compare_exchange_strong(none, reserve)) std::free(reserve);
}

}  // namespace chiaro
