#pragma once

#include "app/cli/session.h"
#include "core/scene/path.h"

namespace chiaro::cli {

/// --path and --period: what moves in an animation.
class PathFlags {
public:
    explicit PathFlags(std::string standard) : m_path(std::move(standard)) {}
    /// Adds the flags; these must outlive the parse.
    void addTo(CLI::App& command);

    /// Throws Error when it is a file that can't be used.
    scene::Path path() const;
    /// Its name, or its file.
    const std::string& name() const { return m_path; }
    /// For metadata.
    nlohmann::json parameters() const;

private:
    std::string m_path;
    int m_period = 48;
};

}  // namespace chiaro::cli
