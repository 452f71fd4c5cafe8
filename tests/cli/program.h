#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace chiaro::test {

/// How a run of the program ended.
struct Outcome {
    int status = -1;  ///< exit status; -1 when a signal ended it
    std::string out;
    std::string error;
    nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// Runs `chiaro` with these arguments and waits for it.
Outcome chiaro(const std::vector<std::string>& arguments);

/// Starts it, sends SIGINT after `milliseconds`, and waits for it.
Outcome interruptedChiaro(const std::vector<std::string>& arguments, int milliseconds);

}  // namespace chiaro::test
