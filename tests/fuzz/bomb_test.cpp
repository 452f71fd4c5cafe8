#include "core/base/error.h"
#include "core/base/image_import.h"
#include "core/project/animation.h"
#include "core/project/presets.h"
#include "core/scene/mesh_import.h"
#include "tests/core/base/raw_files.h"
#include "tests/fuzz/bombs.h"
#include "tests/fuzz/corpus.h"
#include "tests/support/support.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>

namespace chiaro {
namespace {

using namespace test;
using Clock = std::chrono::steady_clock;

/// The most memory that a process has had since it was last reset, MB.
class MemoryMark {
public:
    explicit MemoryMark(int process) : m_folder("/proc/" + std::to_string(process)) {
        std::ofstream(m_folder / "clear_refs") << 5;
        m_before = read("VmRSS:");
    }
    double growth() const { return (read("VmHWM:") - m_before) / 1024; }

private:
    double read(const std::string& key) const {
        std::ifstream status(m_folder / "status");
        for (std::string word; status >> word;)
            if (double kilobytes = 0; word == key && status >> kilobytes) return kilobytes;
        return NAN;
    }

    std::filesystem::path m_folder;
    double m_before = 0;
};

class Bombs : public testing::TestWithParam<Bomb> {
protected:
    void open(const std::filesystem::path& path) {
        switch (GetParam().as) {
            case Opened::Picture:
                importImage(*sharedHelpers, path, {}, {});
                break;
            case Opened::Mesh:
                scene::importModel(*sharedHelpers, path, {});
                break;
            case Opened::Project:
                project::readProject(path);
                break;
            case Opened::Path:
                project::readPath(path);
                break;
            case Opened::Preset:
                project::readPreset(path);
                break;
        }
    }

    /// One helper for all of them, with all its libraries loaded.
    static void SetUpTestSuite() {
        sharedHelpers = std::make_unique<helper::HelperPool>(ImportSettings{.seconds = 10});
        const TemporaryFolder folder;
        for (const Format& format : formats()) {
            const auto path = folder / ("sound" + format.extension);
            save(path, format.corpus().front());
            if (format.as == Opened::Picture) importImage(*sharedHelpers, path, {}, {});
            if (format.as == Opened::Mesh) scene::importModel(*sharedHelpers, path, {});
        }
    }
    static void TearDownTestSuite() { sharedHelpers.reset(); }

    static inline std::unique_ptr<helper::HelperPool> sharedHelpers;
    TemporaryFolder m_folder;
};

TEST_P(Bombs, AreRefusedAtOnceAndCostNoMemory) {
    const int helper = sharedHelpers->idleProcesses().front();
    const auto path = m_folder / ("bomb" + GetParam().extension);
    save(path, GetParam().bytes());
    const MemoryMark ours(::getpid()), theirs(helper);
    const auto start = Clock::now();
    std::string sentence = "was read";
    try {
        open(path);
    } catch (const Error& error) {
        sentence = error.what();
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    std::printf("%-32s %6.3f s, here %+6.1f MB, in the helper %+6.1f MB: %s\n", GetParam().name.c_str(),
                seconds, ours.growth(), theirs.growth(),
                sentence.substr(sentence.find(": ") == sentence.npos ? 0 : sentence.find(": ") + 2).c_str());
    EXPECT_TRUE(GetParam().mayBeRead || sentence.starts_with(path.string())) << sentence;
    EXPECT_EQ(sentence.find("its reader"), sentence.npos) << sentence;
    EXPECT_LT(seconds, 1);
    EXPECT_LT(ours.growth(), 200);
    EXPECT_LT(theirs.growth(), 200);
    EXPECT_EQ(sharedHelpers->idleProcesses(), std::vector<int>{helper}) << "the helper did not survive";
}

INSTANTIATE_TEST_SUITE_P(, Bombs, testing::ValuesIn(bombs()), [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace chiaro
