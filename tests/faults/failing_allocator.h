#pragma once

#include <cstddef>

/// Replaces malloc and its kin for the whole program, libraries included, so that a test can refuse memory.
namespace chiaro::test {

enum class Refused {
    Ours,      ///< only what our own code asks for, the standard library's containers in it included
    Anybodys,  ///< what any library asks for
};

/// While it lives, allocations of all threads are counted from 1, and the one of that number is refused.
class RefusedAllocation {
public:
    /// 0 refuses none.
    RefusedAllocation(long number, Refused whose);
    ~RefusedAllocation();
    RefusedAllocation(const RefusedAllocation&) = delete;
    RefusedAllocation& operator=(const RefusedAllocation&) = delete;

    long count() const;       ///< so far
    bool hasRefused() const;  ///< false when the number was not reached, or nobody's whose is refused
};

/// Blocks that the program holds now.
long heldBlocks();

}  // namespace chiaro::test
