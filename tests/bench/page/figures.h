#pragma once

#include "tests/bench/page/results.h"

#include <span>
#include <string>

namespace chiaro::bench {

enum class Unit {
    Milliseconds,
    Seconds,
    Times,
    Percent,
    Megabytes,
    Gigabytes,
    GigabytesASecond,
    GigaOperations,
    Number
};
enum class Goal { None, AtMost, AtLeast };

/// A row of the page: a figure, or one figure over another of the same run, and what it should be.
struct Figure {
    std::string what;
    Unit unit = Unit::Seconds;
    Reading value;
    Reading over;  ///< what the value is divided by; without a program nothing
    Goal goal = Goal::None;
    double target = 0;        ///< in the row's unit
    bool isOptional = false;  ///< left out where its program was not run, instead of told as missing
};

struct Section {
    std::string title;
    std::string introduction;
    std::vector<Figure> figures;
};

/// What the page shows, in order: the project's targets, with the peer or the bound of each beside it.
const std::vector<Section>& sections();

/// The figure in its row's unit; nothing when it was not measured.
std::optional<double> measured(const Figure& figure, const Results& results);
/// "12.3 ms".
std::string inWords(double value, Unit unit);

}  // namespace chiaro::bench
