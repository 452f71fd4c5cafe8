#include "app/cli/farm/farm_command.h"

#include "core/base/error.h"

namespace chiaro::cli {

namespace farm {

Job jobNamed(const std::string& name) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (fs::is_directory(name, ignored)) return readJob(name);
    if (name.find('#') != std::string::npos) return readJob(jobFolder(name));
    if (name.find_first_not_of("0123456789") == std::string::npos)
        for (const Engine& engine : engines())
            if (const fs::path folder = engine.find(name); !folder.empty()) return readJob(folder);
    throw Error(name, "is no job", "name the job's folder, name.####.png of its frames, or its number");
}

}  // namespace farm

void addFarmCommands(CLI::App& root, Session& session) {
    CLI::App* farm =
        root.add_subcommand("farm", "Paint an animation in chunks, by Slurm or by processes of this machine");
    farm->require_subcommand(1);
    farm::addSubmitCommand(*farm, session);
    farm::addStatusCommand(*farm, session);
    farm::addCollectCommand(*farm, session);
}

}  // namespace chiaro::cli
