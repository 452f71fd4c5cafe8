#pragma once

#include "tests/bench/page/curves.h"
#include "tests/bench/page/figures.h"

#include <filesystem>

namespace chiaro::bench {

struct PageOptions {
    std::string pictures;        ///< the folder of the plots, relative to the page
    std::string instructionSet;  ///< that the search ran with
    bool isQuick = false;        ///< told on the page: its figures are rough
};

/// The page as Markdown.
std::string performancePage(const Results& results, const std::vector<Curves>& curves,
                            const PageOptions& options);

}  // namespace chiaro::bench
