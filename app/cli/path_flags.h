#pragma once

#include "app/cli/session.h"
#include "core/scene/path.h"

namespace chiaro::cli {

/// --path and --period: what moves in an animation.
class PathFlags {
public:
    explicit PathFlags(std::string standard) : m_standard(std::move(standard)) {}
    /// Adds the flags; these must outlive the parse. `standardText` says what is followed without --path.
    void addTo(CLI::App& command, const std::string& standardText);
    void addTo(CLI::App& command) { addTo(command, m_standard); }

    bool isGiven() const { return !m_path.empty(); }
    /// Throws CLI::ValidationError when --period is given and nothing goes around in it: when `followsKeys`
    /// tells that the project's own keys are followed, or along another path than turntable and light.
    void checkPeriod(bool followsKeys = false) const;
    /// Throws Error when it is a file that can't be used.
    scene::Path path() const;
    /// Its name, or its file.
    const std::string& name() const { return isGiven() ? m_path : m_standard; }
    /// For metadata.
    nlohmann::json parameters() const;

private:
    std::string m_standard;
    std::string m_path;
    int m_period = 48;
    const CLI::Option* m_periodFlag = nullptr;
};

}  // namespace chiaro::cli
