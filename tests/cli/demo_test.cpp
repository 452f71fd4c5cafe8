#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

#include <regex>
#include <set>

namespace chiaro::test {
namespace {

namespace fs = std::filesystem;

/// What every attribute of this name says.
std::vector<std::string> valuesOf(const std::string& html, const std::string& attribute) {
    const std::regex pattern(" " + attribute + "=\"([^\"]*)\"");
    std::vector<std::string> values;
    for (auto one = std::sregex_iterator(html.begin(), html.end(), pattern); one != std::sregex_iterator();
         ++one)
        values.push_back((*one)[1]);
    return values;
}

/// Whether every element that needs it is closed in the order in which it was opened; names the first that
/// isn't.
std::string unbalanced(const std::string& html) {
    static const std::set<std::string> empty{"meta", "img", "br", "hr", "link", "input"};
    static const std::regex tag("<(/?)([a-z][a-z0-9]*)[^<>]*>");
    std::vector<std::string> open;
    for (auto one = std::sregex_iterator(html.begin(), html.end(), tag); one != std::sregex_iterator();
         ++one) {
        const std::string name = (*one)[2];
        if (empty.contains(name)) continue;
        if ((*one)[1].length() == 0) {
            open.push_back(name);
            continue;
        }
        if (open.empty() || open.back() != name) return "</" + name + ">";
        open.pop_back();
    }
    return open.empty() ? "" : "<" + open.back() + ">";
}

TEST(Demo, ShowsEveryCommandOnAPageWhoseLinksAllLead) {
    const TemporaryFolder folder;
    const Outcome outcome = chiaro({"demo", "-o", folder / "demo", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_TRUE(outcome.json()["problems"].empty()) << outcome.out;
    const std::string html = readFile(folder / "demo/index.html", 1 << 20);
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
    EXPECT_EQ(unbalanced(html), "");
    EXPECT_EQ(html.find("http"), std::string::npos) << "reaches beyond its folder";

    const std::vector<std::string> ids = valuesOf(html, "id");
    const std::set<std::string> places(ids.begin(), ids.end());
    EXPECT_EQ(places.size(), ids.size()) << "an id stands twice";
    std::set<std::string> linked;
    for (const char* attribute : {"src", "href"})
        for (const std::string& link : valuesOf(html, attribute)) {
            if (link.starts_with("#")) {
                EXPECT_TRUE(places.contains(link.substr(1))) << link;
            } else {
                EXPECT_TRUE(fs::is_regular_file(folder / "demo" / link)) << link;
            }
            linked.insert(link);
        }
    for (const std::string& link : linked)
        if (link.ends_with(".png")) {
            EXPECT_NO_THROW(readImage(folder / "demo" / link)) << link;
        }
    for (const char* made :
         {"demo.png", "recolor-warm.png", "levels-oil.png", "image-based.png", "view-aligned.png",
          "view-dependent.png", "turn-view-dependent.mp4", "still_life-impasto.png", "views/view_01.png",
          "measured/view-aligned-heat.png", "study/rotation.svg", "compare/frame.0001.png", "skull.glb",
          "skull.obj", "skull.ply", "gradient.csv"})
        EXPECT_TRUE(linked.contains(made)) << made;
    for (const char* command :
         {"sample info", "sample gradient", "sample texture", "sample recolor", "levels", "render", "animate",
          "views", "measure", "measure study", "compare", "export"})
        EXPECT_NE(html.find(std::string("<code>chiaro ") + command), std::string::npos) << command;
}

TEST(Demo, SaysWhereItCannotWrite) {
    const Outcome outcome = chiaro({"demo", "-o", "/proc/none"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.error.find("/proc/none"), std::string::npos) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
}

}  // namespace
}  // namespace chiaro::test
