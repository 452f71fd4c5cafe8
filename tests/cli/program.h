#pragma once

#include <nlohmann/json.hpp>
#include <sys/types.h>

#include <memory>
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

/// A run of `chiaro` that goes on meanwhile; one that isn't waited for is killed.
class RunningChiaro {
public:
    explicit RunningChiaro(const std::vector<std::string>& arguments);
    ~RunningChiaro();
    void signal(int number) const;
    Outcome wait();

private:
    struct Files;
    std::unique_ptr<Files> m_files;
    pid_t m_process = -1;
};

/// Runs `chiaro` with these arguments and waits for it.
Outcome chiaro(const std::vector<std::string>& arguments);

/// Starts it, sends SIGINT after `milliseconds`, and waits for it.
Outcome interruptedChiaro(const std::vector<std::string>& arguments, int milliseconds);

}  // namespace chiaro::test
