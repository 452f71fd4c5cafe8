#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace chiaro::test {

/// Spoils files the way that disks, downloads, careless writers and malice do: bits and bytes that differ, a
/// file cut off, parts moved, doubled or swapped with another file's, lengths and offsets out of all
/// proportion, numbers in text that no writer would write. The same seeds and number give the same bytes, on
/// every machine.
class Mutator {
public:
    /// At least one seed, none empty.
    explicit Mutator(std::vector<std::string> seeds) : m_seeds(std::move(seeds)) {}

    /// One to four changes to one of the seeds, at most 64 kB.
    std::string mutation(std::uint64_t number) const;

private:
    std::vector<std::string> m_seeds;
};

}  // namespace chiaro::test
