#pragma once

#include "tests/support/support.h"

#include <sys/types.h>

#include <string>
#include <vector>

namespace chiaro::test {

/// A Slurm of one node on this machine: munged, slurmctld and slurmd on ports and in a folder of their own,
/// found by $SLURM_CONF while it lives. Its daemons end with it, or with the test program.
class SlurmCluster {
public:
    /// Starts it and waits until the node takes jobs; problem() says why it doesn't.
    SlurmCluster();
    /// Cancels what runs and ends the daemons.
    ~SlurmCluster();
    SlurmCluster(const SlurmCluster&) = delete;
    SlurmCluster& operator=(const SlurmCluster&) = delete;

    /// Empty when it runs.
    const std::string& problem() const { return m_problem; }

private:
    void writeConfiguration() const;
    void start(const std::vector<std::string>& words);
    bool isIdle() const;

    TemporaryFolder m_folder;
    std::vector<pid_t> m_daemons;
    std::string m_problem;
};

/// Runs a shell command without showing what it says; true when it succeeds.
bool succeeds(const std::string& command);

}  // namespace chiaro::test
