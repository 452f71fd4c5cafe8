// performance_page RESULTS PAGE PICTURES [--quick]: makes the page and its plots of what the benchmarks
// wrote. performance_page --instruction-set: the name of the best one that this processor runs.

#include "core/base/atomic_file.h"
#include "core/synthesis/search_kernels.h"
#include "tests/bench/page/page.h"

#include <cstdio>
#include <exception>
#include <string_view>

namespace {

namespace fs = std::filesystem;
using namespace chiaro;

void write(const fs::path& folder, const fs::path& page, const fs::path& pictures, bool isQuick) {
    const std::string instructionSet = synthesis::kernels::supportedTargets().front();
    const bench::Results results(folder, instructionSet);
    const auto curves = bench::scalingCurves(results);
    for (const bench::Curves& curve : curves)
        writeFileAtomically(pictures / curve.file, metrics::svgOf({curve.chart}, 1));
    writeFileAtomically(page, bench::performancePage(
                                  results, curves,
                                  {fs::relative(pictures, fs::absolute(page).parent_path()).generic_string(),
                                   instructionSet, isQuick}));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 2 && std::string_view(argv[1]) == "--instruction-set") {
            std::puts(synthesis::kernels::supportedTargets().front());
            return 0;
        }
        if (argc < 4) {
            std::fputs("performance_page RESULTS PAGE PICTURES [--quick] | --instruction-set\n", stderr);
            return 2;
        }
        write(argv[1], argv[2], argv[3], argc > 4 && std::string_view(argv[4]) == "--quick");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "performance_page: %s\n", error.what());
        return 1;
    }
}
