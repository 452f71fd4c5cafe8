#include "tests/support/support.h"

#include "core/base/atomic_file.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace chiaro::test {

namespace fs = std::filesystem;

fs::path resource(const std::string& relative) {
    return fs::path(CHIARO_TEST_RESOURCES) / relative;
}

fs::path sharedData() {
    return fs::path(CHIARO_TEST_DATA);
}

bool haveSharedData() {
    return fs::is_directory(sharedData());
}

std::vector<fs::path> intactSamples() {
    const std::string list = readFile(sharedData() / "SOURCES.md", 1 << 24);
    std::vector<fs::path> samples;
    for (const auto& entry : fs::recursive_directory_iterator(sharedData() / "samples")) {
        if (!entry.is_regular_file()) continue;
        const std::string row =
            fmt::format("`{}` | {} |", fs::relative(entry.path(), sharedData()).string(), entry.file_size());
        if (list.find(row) != std::string::npos)
            samples.push_back(entry.path());
        else
            std::cerr << "left out, since its size is not the listed one: " << entry.path() << std::endl;
    }
    std::sort(samples.begin(), samples.end());
    return samples;
}

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "chiaro-test-XXXXXX").string();
    m_path = mkdtemp(pattern.data());
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

}  // namespace chiaro::test
