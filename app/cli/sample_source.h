#pragma once

#include "app/cli/session.h"
#include "core/project/project.h"

namespace chiaro::cli {

/// The positional STRIP and the flags that say how a scan becomes a strip and a strip a gradient (§3).
class SampleSource {
public:
    /// Adds the flags; the source must outlive the parse.
    void addTo(CLI::App& command);
    /// Adds the strip under another name, "--sample", and no flags of the gradient; not required yet.
    CLI::Option* addStripTo(CLI::App& command, const std::string& name);

    /// The strip that the flags describe. Throws Error.
    ColorImage readStrip() const;
    const std::filesystem::path& path() const { return m_sample.scan; }
    const project::Sample& sample() const { return m_sample; }
    bool given() const { return !m_sample.scan.empty(); }
    /// For a picture's metadata.
    nlohmann::json parameters() const;

private:
    project::Sample m_sample;
};

}  // namespace chiaro::cli
