// What it costs to read a file in the helper instead of here: a large scan, a large mesh and a small strip.
// The two take turns, so that what else the machine does disturbs both alike.

#include "core/base/image_import.h"
#include "core/scene/mesh_import.h"
#include "tests/support/support.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <unistd.h>

namespace {

using namespace chiaro;

double millisecondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Processor time of this process and of the helpers that wait for work, ms.
double cpuMilliseconds(const helper::HelperPool& helpers) {
    double ticks = double(std::clock()) / double(CLOCKS_PER_SEC) * double(::sysconf(_SC_CLK_TCK));
    for (const int process : helpers.idleProcesses()) {
        std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
        std::string word;
        for (int field = 1; field <= 15 && stat >> word; ++field)
            if (field >= 14) ticks += std::stod(word);
    }
    return ticks / double(::sysconf(_SC_CLK_TCK)) * 1000;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

void compare(const helper::HelperPool& helpers, const char* what, int times,
             const std::function<void()>& here, const std::function<void()>& there) {
    here();
    there();
    std::vector<double> hereTimes, thereTimes, differences;
    double cpuHere = 0, cpuThere = 0;
    for (int i = 0; i < times; ++i) {
        const double begin = cpuMilliseconds(helpers);
        hereTimes.push_back(millisecondsOf(here));
        const double middle = cpuMilliseconds(helpers);
        thereTimes.push_back(millisecondsOf(there));
        cpuHere += middle - begin;
        cpuThere += cpuMilliseconds(helpers) - middle;
        differences.push_back(thereTimes.back() - hereTimes.back());
    }
    std::printf(
        "%-24s in process %8.1f ms   in the helper %8.1f ms   difference %+7.1f ms (median of %d pairs); "
        "processor time %+7.1f ms (mean)\n",
        what, median(hereTimes), median(thereTimes), median(differences), times,
        (cpuThere - cpuHere) / times);
}

ColorImage noise(int width, int height) {
    ColorImage image(width, height);
    unsigned state = 1;
    for (glm::vec3& pixel : image.pixels()) {
        state = state * 1664525u + 1013904223u;
        pixel = glm::vec3(float(state >> 24), float(state >> 16 & 255), float(state >> 27 << 3)) / 255.0f;
    }
    return image;
}

/// A wavy sheet of 2 * side^2 triangles, as binary PLY.
void writeSheet(const std::filesystem::path& path, int side) {
    std::ofstream file(path, std::ios::binary);
    file << "ply\nformat binary_little_endian 1.0\nelement vertex " << (side + 1) * (side + 1)
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << 2 * side * side
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    const auto put = [&](const auto& value) {
        file.write(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x)
            put(glm::vec3(x, y, 10 * std::sin(float(x) * 0.1f) * std::cos(float(y) * 0.1f)));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int corner = y * (side + 1) + x;
            for (const auto& triangle : {glm::ivec3(0, 1, side + 1), glm::ivec3(1, side + 2, side + 1)}) {
                put(std::uint8_t(3));
                put(triangle + corner);
            }
        }
}

}  // namespace

int main() {
    const test::TemporaryFolder folder;
    helper::HelperPool helpers(ImportSettings::fromEnvironment());
    const auto scan = folder / "scan.png", sheet = folder / "sheet.ply";
    writeImage(scan, noise(4096, 4096));
    writeSheet(sheet, 500);
    const auto strip = test::resource("demo/samples/oil.png");
    compare(
        helpers, "PNG, 4096 x 4096", 7, [&] { readImage(scan); },
        [&] { importImage(helpers, scan, {}, {}); });
    compare(
        helpers, "PLY, 500,000 triangles", 7, [&] { scene::readModel(sheet); },
        [&] { scene::importModel(helpers, sheet, {}); });
    compare(
        helpers, "PNG, the demo's strip", 15, [&] { readImage(strip); },
        [&] { importImage(helpers, strip, {}, {}); });
}
