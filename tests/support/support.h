#pragma once

#include "core/base/image.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace chiaro::test {

/// The project's own demo files.
std::filesystem::path resource(const std::string& relative);

/// Real meshes, scans and broken files that lie beside the project on some machines and are never part of it.
std::filesystem::path sharedData();
bool haveSharedData();
/// The real samples whose size is still the one that the data's own list, SOURCES.md, gives; the others are
/// damaged and are named on stderr.
std::vector<std::filesystem::path> intactSamples();
/// Regular files right inside a folder, sorted by name.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder);

/// A folder of its own that goes away with it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
    const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

}  // namespace chiaro::test

/// First line of a test that needs the real data: skips, saying so, where it is absent.
#define CHIARO_NEEDS_SHARED_DATA() \
    if (!chiaro::test::haveSharedData()) GTEST_SKIP() << "no real data beside the project"
