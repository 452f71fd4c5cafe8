#include "app/cli/path_flags.h"

#include "core/project/animation.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro::cli {

void PathFlags::addTo(CLI::App& command, const std::string& standardText) {
    command.add_option(
        "--path", m_path,
        fmt::format("turntable (the camera goes around, from the project's view on), light (the lights go "
                    "around +Y), approach (the camera comes nearer by 4% of its distance each frame), or a "
                    "JSON file of camera and light keys (default {})",
                    standardText));
    m_periodFlag = command
                       .add_option("--period", m_period,
                                   "Frames in which --path turntable or light goes around once (default 48)")
                       ->check(CLI::Range(1, 100000));
}

void PathFlags::checkPeriod(bool followsKeys) const {
    if (m_periodFlag == nullptr || m_periodFlag->count() == 0) return;
    if (followsKeys)
        throw CLI::ValidationError(
            "--period: means nothing to the keys of the project's timeline, which are followed; add --path "
            "turntable or --path light");
    if (name() != "turntable" && name() != "light")
        throw CLI::ValidationError("--period: means nothing to --path " + name() +
                                   "; it is for --path turntable and --path light");
}

scene::Path PathFlags::path() const {
    const std::string& chosen = name();
    if (chosen == "turntable") return scene::Path::turntable(m_period);
    if (chosen == "light") return scene::Path::lightSweep(m_period);
    if (chosen == "approach") return scene::Path::approaching();
    return project::readPath(chosen);
}

nlohmann::json PathFlags::parameters() const {
    return {{"path", std::filesystem::path(name()).filename().string()}, {"period", m_period}};
}

}  // namespace chiaro::cli
