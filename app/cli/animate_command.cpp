#include "app/cli/animation_flags.h"

#include <spdlog/fmt/fmt.h>

#include <memory>

namespace chiaro::cli {

namespace {

struct AnimateCommand {
    AnimationFlags flags;

    void run(Session& session) const {
        session.start();
        flags.check();
        const Task task = session.task("animate");
        project::Project project = flags.load();
        project::AnimationOutput output = flags.output(project);
        const scene::Path path = flags.path(project.animation);
        flags.checkFiles(project, output);
        Stopwatch stopwatch;
        const LoadedProject loaded = loadProject(std::move(project), task.part(0, 0.1));
        const project::TextureCache cache(project::TextureCache::standardFolder());
        const project::WornPaints worn =
            project::wornPaints(loaded.project, loaded.scene, loaded.paints, task.part(0.1, 0.3), &cache);
        const glm::ivec2 size = flags.size();
        const project::Shot shot{loaded.project, loaded.scene, worn, path, size.x, size.y};
        flags.describe(output, shot);
        const int resumed = project::writeAnimation(shot, output, task.part(0.3, 1));
        const double seconds = stopwatch.lap();
        const int frames = output.range.count();
        session.finish({{"frames", frames}, {"seconds", seconds}, {"resumed", resumed}},
                       fmt::format("{}: {} frames{}{}, {:.2f} s", output.path.string(), frames,
                                   resumed > 0 ? fmt::format(", {} of them finished before", resumed) : "",
                                   padding(size), seconds));
    }

    /// Videos take even sides only.
    std::string padding(glm::ivec2 size) const {
        const glm::ivec2 even = (size + 1) / 2 * 2;
        if (!flags.makesVideo() || even == size) return {};
        return fmt::format(", padded to {} x {} px, since videos have even sides", even.x, even.y);
    }
};

}  // namespace

void addAnimateCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand(
        "animate", "Paint the frames of a moving view as a sequence of pictures or a video (§4.1)");
    auto state = std::make_shared<AnimateCommand>();
    state->flags.addTo(*command);
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
