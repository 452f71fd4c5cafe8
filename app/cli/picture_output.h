#pragma once

#include "app/cli/session.h"
#include "core/export/painted_files.h"

namespace chiaro::cli {

/// The flags that say how the pictures of a command look: their size, what lies behind the objects, and
/// whether the values they were shaded from are written too.
class PictureOutput {
public:
    /// Adds the flags; the output must outlive the parse.
    void addTo(CLI::App& command);
    /// Throws CLI::ValidationError when a flag's value is no such thing.
    void check() const;

    glm::ivec2 size() const;
    bool isTransparent() const { return m_background == "transparent"; }
    /// What lies behind the objects; none when it is transparent.
    std::optional<glm::vec3> background() const;
    /// Where the values that a picture was shaded from are to go.
    exporting::AuxiliaryFolder auxiliary() const { return exporting::AuxiliaryFolder(m_auxiliary); }
    /// For metadata.
    nlohmann::json parameters() const;

private:
    std::string m_size = "1024x1024";
    std::string m_background = "#ffffff";
    std::filesystem::path m_auxiliary;
};

}  // namespace chiaro::cli
