#include "core/project/presets.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "tests/support/support.h"

namespace chiaro::project {
namespace {

using Space = gradient::ColorPath::Space;

MethodPreset methodPresetOf(const std::string& method) {
    Project project;
    project.method = method;
    project.levels.count = 6;
    project.levels.quilt.block = 24;
    project.viewAligned.density = 0.75;
    project.imageBased.window = 7;
    project.imageBased.quilt.seed = 9;
    project.coherence.every = 5;
    project.viewDependent.propagate = !project.viewDependent.propagate;
    project.views.count = 9;
    project.views.up = {0, 0, 1};
    return MethodPreset::of(project);
}

TEST(Presets, ComeBackAsTheyWereWritten) {
    const test::TemporaryFolder folder;
    const gradient::ColorPath path{{{0, {0.1f, 0.2f, 0.3f}}, {0.25f, {1, 0, 0}}, {1, {1, 1, 1}}},
                                   Space::Oklab};
    const ViewPlanPreset plan{methodPresetOf("view-dependent").params.views,
                              {{{1, 2, 3}, {0, 0, 1}}, {{0, 1, 0}, {1, 0, 0}}}};
    writePreset(folder / "path.json", path);
    writePreset(folder / "plan.json", plan);
    EXPECT_EQ(std::get<gradient::ColorPath>(readPreset(folder / "path.json")), path);
    EXPECT_EQ(std::get<ViewPlanPreset>(readPreset(folder / "plan.json")), plan);
}

TEST(Presets, OfAMethodSayNothingOfTheOthers) {
    const test::TemporaryFolder folder;
    for (const char* method : {"image-based", "view-aligned", "view-dependent"}) {
        SCOPED_TRACE(method);
        const MethodPreset preset = methodPresetOf(method);
        writePreset(folder / "a.json", preset);
        const auto read = std::get<MethodPreset>(readPreset(folder / "a.json"));
        EXPECT_EQ(read.method, method);
        MethodParams fromFile, fromMemory;
        read.applyTo(fromFile);
        preset.applyTo(fromMemory);
        EXPECT_EQ(fromFile, fromMemory);
        EXPECT_NE(fromFile, MethodParams());
        const bool isImageBased = preset.method == "image-based";
        EXPECT_EQ(fromFile.imageBased == MethodParams().imageBased, !isImageBased);
        EXPECT_EQ(fromFile.levels == MethodParams().levels, isImageBased);
        EXPECT_EQ(fromFile.views == MethodParams().views, preset.method != "view-dependent");
    }
}

TEST(Presets, SayWhatIsWrongWithAFile) {
    const test::TemporaryFolder folder;
    const auto refusal = [&](const std::string& text) {
        writeFileAtomically(folder / "broken.json", text);
        try {
            readPreset(folder / "broken.json");
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("broken.json"), std::string::npos);
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    for (const auto& [text, expected] : std::vector<std::pair<std::string, std::string>>{
             {"", "is not JSON"},
             {"[]", "is not an object"},
             {"{}", "has no \"chiaro-preset\""},
             {R"({"chiaro-preset": 2})", "newer Chiaro (format 2)"},
             {R"({"chiaro-preset": 1})", "says nothing"},
             {R"({"chiaro-preset": 1, "gradient": 3})", "is not an object"},
             {R"({"chiaro-preset": 1, "gradient": {"stops": []}})", "at least one stop"},
             {R"({"chiaro-preset": 1, "gradient": {"stops": [{"position": 2}]}})", "from 0 to 1"},
             {R"({"chiaro-preset": 1, "method": {"method": "oil"}})", "\"image-based\""},
             {R"({"chiaro-preset": 1, "method": {"method": "image-based"}})", "has no \"image-based\""},
             {R"({"chiaro-preset": 1, "method": {"method": "image-based", "image-based": {"window": 65}}})",
              "0..64"},
             {R"({"chiaro-preset": 1, "view-plan": {"count": "many"}})", "count"},
             {R"({"chiaro-preset": 1, "view-plan": {"placed": [{"direction": [0, 0, 0]}]}})", "not zero"}})
        EXPECT_NE(refusal(text).find(expected), std::string::npos) << text << "\n" << refusal(text);
}

TEST(Presets, BrokenOnesAreListedWithTheirSentence) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(listPresets(folder / "nothing", PresetKind::Gradient).empty());
    writePreset(presetFile(folder.path(), "b dusk"), gradient::ColorPath{{{0, {0, 0, 0}}}, Space::Rgb});
    writePreset(presetFile(folder.path(), "c other"), methodPresetOf("image-based"));
    writeFileAtomically(folder / "a broken.json", "{");
    writeFileAtomically(folder / "notes.txt", "{");
    const auto listed = listPresets(folder.path(), PresetKind::Gradient);
    ASSERT_EQ(listed.size(), 3u);
    EXPECT_EQ(listed[0].name, "a broken");
    EXPECT_NE(listed[0].problem.find("is not JSON"), std::string::npos);
    EXPECT_EQ(listed[1].name, "b dusk");
    EXPECT_TRUE(listed[1].preset && listed[1].problem.empty());
    EXPECT_NE(listed[2].problem.find("is a method preset"), std::string::npos);
}

TEST(Presets, NamesAreThoseOfFilesOnEverySystem) {
    EXPECT_EQ(presetFile("/p", "Öl, warm (2)"), "/p/Öl, warm (2).json");
    for (const std::string name : {"", "  ", "..", ".hidden", "a/b", "../a", "a:b", "a\nb", "a "})
        EXPECT_THROW(presetFile("/p", name), Error) << name;
    EXPECT_THROW(presetFile("/p", std::string(300, 'a')), Error);
}

TEST(Presets, RenamingReplacesNone) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a", "b"})
        writePreset(presetFile(folder.path(), name), gradient::ColorPath{{{0, {0, 0, 0}}}, Space::Rgb});
    EXPECT_THROW(renamePreset(folder / "a.json", "b"), Error);
    EXPECT_NO_THROW(renamePreset(folder / "a.json", "a"));
    renamePreset(folder / "a.json", "c");
    const auto listed = listPresets(folder.path(), PresetKind::Gradient);
    ASSERT_EQ(listed.size(), 2u);
    EXPECT_EQ(listed[1].name, "c");
}

}  // namespace
}  // namespace chiaro::project
