#include "core/base/atomic_file.h"
#include "tests/cli/program.h"
#include "tests/support/support.h"

namespace chiaro::test {
namespace {

TEST(Compare, MakesTheReportsTableForEveryMethod) {
    const TemporaryFolder folder;
    const Outcome outcome = chiaro({"compare",
                                    "--mesh",
                                    resource("demo/meshes/shell.ply").string(),
                                    "--sample",
                                    resource("demo/samples/oil.png").string(),
                                    "--size",
                                    "120x120",
                                    "--frames",
                                    "2",
                                    "--seeds",
                                    "2",
                                    "--pixels",
                                    "40",
                                    "--level-size",
                                    "64",
                                    "--level-count",
                                    "3",
                                    "--view-size",
                                    "96",
                                    "--view-count",
                                    "4",
                                    "--block",
                                    "16",
                                    "-o",
                                    folder / "c",
                                    "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    for (const char* method : {"image-based", "view-aligned", "view-dependent"})
        for (const char* key :
             {"similarity", "shading_mae", "shading_mse", "temporal_image", "temporal_object"}) {
            const double value = outcome.json()["methods"][method][key].get<double>();
            EXPECT_GT(value, 0) << method << " " << key;
            EXPECT_LT(value, 1.5) << method << " " << key;
            EXPECT_GT(outcome.json()["methods"][method][std::string(key) + "_se"].get<double>(), 0);
        }
    // The report's own figures stand beside ours.
    EXPECT_NE(readFile(folder / "c/table.md", 1 << 16).find("0.07539"), std::string::npos);
    EXPECT_EQ(filesIn(folder / "c").size(), 5u);  // three tables and two frames
}

}  // namespace
}  // namespace chiaro::test
