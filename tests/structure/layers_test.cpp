#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path source = CHIARO_SOURCE_DIR;

struct Include {
    fs::path file;     ///< relative to the project
    std::string what;  ///< between the quotes or brackets
};

std::vector<Include> includesBelow(const std::string& folder) {
    static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    std::vector<Include> includes;
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        std::ifstream stream(entry.path());
        std::smatch match;
        for (std::string line; std::getline(stream, line);)
            if (std::regex_search(line, match, pattern))
                includes.push_back({fs::relative(entry.path(), source), match[1].str()});
    }
    return includes;
}

/// "core/scene/mesh.h" -> "scene"; empty for anything outside core.
std::string coreFolder(const fs::path& path) {
    auto part = path.begin();
    if (part == path.end() || *part != "core" || ++part == path.end()) return {};
    return part->string();
}

const std::vector<std::string> order{"base",  "sample",  "gradient", "synthesis", "scene",
                                     "views", "methods", "metrics",  "export",    "project"};

std::ptrdiff_t rank(const std::string& folder) {
    return std::find(order.begin(), order.end(), folder) - order.begin();
}

TEST(Layers, EveryFolderOfCoreHasItsPlace) {
    for (const auto& entry : fs::directory_iterator(source / "core")) {
        if (!entry.is_directory()) continue;
        EXPECT_LT(rank(entry.path().filename().string()), std::ptrdiff_t(order.size())) << entry.path();
        EXPECT_TRUE(fs::exists(entry.path() / "README.md")) << entry.path();
    }
}

// A formatter for C++ that meets Markdown makes one run of it.
TEST(Layers, EveryFolderOfCoreIsDescribedInMarkdown) {
    for (const std::string& folder : order) {
        std::ifstream stream(source / "core" / folder / "README.md");
        std::string title, blank;
        std::getline(stream, title);
        std::getline(stream, blank);
        EXPECT_TRUE(title.starts_with("# " + folder)) << folder << ": " << title;
        EXPECT_TRUE(blank.empty()) << folder << ": " << blank;
    }
}

TEST(Layers, CoreIncludesOnlyFoldersAboveItself) {
    std::size_t seen = 0;
    for (const Include& include : includesBelow("core")) {
        const std::string to = coreFolder(include.what);
        if (to.empty()) continue;
        ++seen;
        EXPECT_LE(rank(to), rank(coreFolder(include.file))) << include.file << " includes " << include.what;
    }
    EXPECT_GT(seen, 20u);
}

TEST(Layers, CoreKnowsNoQtNoOpenGlAndNothingAboveIt) {
    static const std::regex forbidden(R"(^(Q[A-Z]|Qt|GL/|widgets/|app/))");
    for (const Include& include : includesBelow("core"))
        EXPECT_FALSE(std::regex_search(include.what, forbidden))
            << include.file << " includes " << include.what;
}

TEST(Layers, WidgetsKnowNoDocument) {
    for (const Include& include : includesBelow("widgets"))
        EXPECT_FALSE(include.what.starts_with("app/")) << include.file << " includes " << include.what;
}

TEST(Layers, NothingIncludesTheApp) {
    for (const char* folder : {"core", "widgets"})
        for (const Include& include : includesBelow(folder))
            EXPECT_FALSE(include.what.starts_with("app/")) << include.file << " includes " << include.what;
}

TEST(Layers, TheCommandLineKnowsNoQt) {
    for (const Include& include : includesBelow("app/cli"))
        EXPECT_FALSE(std::regex_search(include.what, std::regex("^(Q[A-Z]|widgets/)")))
            << include.file << " includes " << include.what;
}

}  // namespace
