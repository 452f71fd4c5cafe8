#include "tests/soak/usage.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <malloc.h>
#include <string>
#include <unistd.h>

namespace chiaro::test {

namespace {

int entriesOf(const char* folder) {
    return int(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

Usage Usage::now(double seconds) {
    Usage usage;
    usage.seconds = seconds;
    const struct mallinfo2 heap = mallinfo2();
    usage.heap = double(heap.uordblks + heap.hblkhd);
    double total = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> total >> resident;
    usage.resident = resident * double(sysconf(_SC_PAGESIZE));
    usage.files = entriesOf("/proc/self/fd");
    usage.threads = entriesOf("/proc/self/task");
    return usage;
}

double slopeOf(const std::vector<Usage>& usage, double Usage::*figure) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < usage.size(); ++i)
        for (std::size_t j = i + 1; j < usage.size(); ++j)
            if (usage[j].seconds > usage[i].seconds)
                slopes.push_back((usage[j].*figure - usage[i].*figure) /
                                 (usage[j].seconds - usage[i].seconds));
    if (slopes.empty()) return 0;
    const auto middle = slopes.begin() + std::ptrdiff_t(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return *middle;
}

}  // namespace chiaro::test
