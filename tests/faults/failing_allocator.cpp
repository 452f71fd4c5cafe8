#include "tests/faults/failing_allocator.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <dlfcn.h>
#include <execinfo.h>
#include <optional>
#include <string_view>

// What glibc calls its own.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace {

std::atomic<bool> isCounting{false};
std::atomic<long> counted{0};
std::atomic<long> refused{0};
std::atomic<bool> refusedToUsAlone{false};
std::atomic<bool> wasRefused{false};
std::atomic<long> held{0};

constexpr std::array<std::string_view, 6> ownNames{"malloc",   "calloc",        "realloc",
                                                   "memalign", "aligned_alloc", "posix_memalign"};

/// Whether our own code asks for memory here: the first caller outside the C and C++ libraries is of this
/// program or of one of its modules, and no library that is compiled into it. (Where nlohmann's JSON is
/// refused memory it may end the program, since its destructor allocates.)
bool isOurs() {
    std::array<void*, 24> calls{};
    const int count = backtrace(calls.data(), int(calls.size()));
    std::optional<bool> ours;
    for (int i = 2; i < count; ++i) {  // after this function and its caller
        Dl_info info{};
        if (dladdr(calls[std::size_t(i)], &info) == 0 || !info.dli_fname) break;
        const std::string_view name = info.dli_sname ? info.dli_sname : "", file = info.dli_fname;
        if (name.find("nlohmann") != name.npos || name.find("tinygltf") != name.npos) return false;
        const bool isStandard = file.find("libstdc++") != file.npos || file.find("libc.so") != file.npos ||
                                name.starts_with("_ZNSt") || name.starts_with("_ZSt") ||
                                std::ranges::find(ownNames, name) != ownNames.end();
        if (!ours && !isStandard)
            ours = file.ends_with("/test_refused_memory") || file.find("/chiaro_") != file.npos;
    }
    return ours.value_or(false);
}

bool isRefused() {
    if (!isCounting.load(std::memory_order_relaxed)) return false;
    if (++counted != refused.load(std::memory_order_relaxed)) return false;
    if (refusedToUsAlone && !isOurs()) return false;
    wasRefused = true;
    errno = ENOMEM;
    return true;
}

void* taken(void* block) {
    if (block) held.fetch_add(1, std::memory_order_relaxed);
    return block;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept {
    return isRefused() ? nullptr : taken(__libc_malloc(size));
}

void* calloc(std::size_t count, std::size_t size) noexcept {
    return isRefused() ? nullptr : taken(__libc_calloc(count, size));
}

void* realloc(void* block, std::size_t size) noexcept {
    if (size > 0 && isRefused()) return nullptr;
    void* moved = __libc_realloc(block, size);
    if (!block) return taken(moved);
    if (size == 0) held.fetch_sub(1, std::memory_order_relaxed);
    return moved;
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return isRefused() ? nullptr : taken(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
    void* found = memalign(alignment, size);
    if (!found) return ENOMEM;
    *block = found;
    return 0;
}

void free(void* block) noexcept {
    if (block) held.fetch_sub(1, std::memory_order_relaxed);
    __libc_free(block);
}

}  // extern "C"

namespace chiaro::test {

RefusedAllocation::RefusedAllocation(long number, Refused whose) {
    isOurs();  // what looking at callers loads, it loads now
    counted = 0;
    refused = number;
    refusedToUsAlone = whose == Refused::Ours;
    wasRefused = false;
    isCounting = true;
}

RefusedAllocation::~RefusedAllocation() {
    isCounting = false;
}

long RefusedAllocation::count() const {
    return counted;
}

bool RefusedAllocation::hasRefused() const {
    return wasRefused;
}

long heldBlocks() {
    return held;
}

}  // namespace chiaro::test
