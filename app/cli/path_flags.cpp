#include "app/cli/path_flags.h"

#include "core/project/animation.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro::cli {

void PathFlags::addTo(CLI::App& command) {
    command.add_option(
        "--path", m_path,
        fmt::format("turntable (the camera goes around, from the project's view on), light (the lights go "
                    "around +Y), approach (the camera comes nearer by 4% of its distance each frame), or a "
                    "JSON file of camera and light keys (default {})",
                    m_path));
    command.add_option("--period", m_period, "Frames in which a turn goes around once (default 48)")
        ->check(CLI::Range(1, 100000));
}

scene::Path PathFlags::path() const {
    if (m_path == "turntable") return scene::Path::turntable(m_period);
    if (m_path == "light") return scene::Path::lightSweep(m_period);
    if (m_path == "approach") return scene::Path::approaching();
    return project::readPath(m_path);
}

nlohmann::json PathFlags::parameters() const {
    return {{"path", std::filesystem::path(m_path).filename().string()}, {"period", m_period}};
}

}  // namespace chiaro::cli
