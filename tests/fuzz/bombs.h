#pragma once

#include "tests/fuzz/corpus.h"

#include <functional>

namespace chiaro::test {

/// A small file that would cost much to believe.
struct Bomb {
    std::string name;
    std::string extension;
    Opened as = Opened::Picture;
    std::function<std::string()> bytes;
    bool mayBeRead = false;  ///< what explodes is nothing that is needed of it
};

std::vector<Bomb> imageBombs();
std::vector<Bomb> meshBombs();
std::vector<Bomb> jsonBombs();
/// All of them.
std::vector<Bomb> bombs();

}  // namespace chiaro::test
