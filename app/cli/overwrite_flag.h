#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace chiaro::cli {

/// --overwrite: of the commands that work long or into folders full of other things, and so replace nothing
/// unasked.
class OverwriteFlag {
public:
    /// Adds the flag; this must outlive the parse.
    void addTo(CLI::App& command);

    bool isGiven() const { return m_isGiven; }
    /// Throws Error naming a file that is there already without the flag, or that can't be written. The
    /// sentence ends with what else would be right.
    void check(const std::vector<std::filesystem::path>& files, const std::string& orElse = {}) const;

private:
    bool m_isGiven = false;
};

}  // namespace chiaro::cli
