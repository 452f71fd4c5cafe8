#include "app/cli/session.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/scene/mesh_io.h"
#include "core/views/coverage.h"
#include "core/views/thumbnail.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace chiaro::cli {

namespace {

const char* nameOf(views::Drawn drawn) {
    switch (drawn) {
        case views::Drawn::All:
            return "all";
        case views::Drawn::Uncovered:
            return "uncovered";
        case views::Drawn::UncoveredFronts:
            return "uncovered fronts";
        case views::Drawn::EachAlone:
            return "each alone";
    }
    return "";
}

/// Column by column.
nlohmann::json numbersOf(const glm::dmat4& matrix) {
    nlohmann::json numbers = nlohmann::json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) numbers.push_back(matrix[column][row]);
    return numbers;
}

nlohmann::json jsonOf(const views::FaceGroup& group, const views::ViewCoverage& coverage) {
    return {{"name", group.view.name},
            {"view", numbersOf(group.view.viewMatrix())},
            {"projection", numbersOf(group.view.projectionMatrix())},
            {"width", group.view.size},
            {"height", group.view.size},
            {"pass", group.pass},
            {"drawn", nameOf(group.drawn)},
            {"area", coverage.area},
            {"mean_angle", coverage.meanAngle},
            {"overlap", coverage.overlap},
            {"faces", group.faces}};
}

struct ViewsCommand {
    std::filesystem::path mesh;
    std::filesystem::path folder;
    views::ViewParams params;

    void run(Session& session) const {
        session.start();
        const Task task = session.task("views");
        const scene::Model model = scene::readModel(mesh, task.part(0, 0.2));
        const views::Surface surface(std::make_shared<const scene::Mesh>(scene::merged(model.meshes)));
        if (!(surface.totalArea() > 0))
            throw Error(mesh.string(), "has no face with area", "views need a surface to look at");
        Stopwatch stopwatch;
        const views::ViewPlan plan = views::planViews(surface, params, {}, task.part(0.2, 0.8));
        const double seconds = stopwatch.lap();
        const views::CoverageReport report = views::measureCoverage(surface, plan);
        const nlohmann::json json = jsonOf(plan, report);
        writeThumbnails(surface, plan, task.part(0.8, 1));
        writeFileAtomically(folder / "views.json", json.dump() + "\n");
        session.finish(json, text(plan, report, seconds));
    }

    static nlohmann::json jsonOf(const views::ViewPlan& plan, const views::CoverageReport& report) {
        nlohmann::json json{{"faces", report.faces},
                            {"coverage", report.covered},
                            {"unreachable", plan.unreachable},
                            {"passes", plan.passes},
                            {"faces_per_pass", report.facesPerPass},
                            {"views", nlohmann::json::array()}};
        for (std::size_t i = 0; i < plan.groups.size(); ++i)
            json["views"].push_back(cli::jsonOf(plan.groups[i], report.views[i]));
        return json;
    }

    void writeThumbnails(const views::Surface& surface, const views::ViewPlan& plan, const Task& task) const {
        const std::vector<ColorImage> pictures = views::drawThumbnails(surface, plan, {}, task);
        nlohmann::json parameters = parametersToJson(params);
        parameters["mesh"] = mesh.filename().string();
        parameters["up"] = {params.up.x, params.up.y, params.up.z};
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            parameters["view"] = plan.groups[i].view.name;
            writeImage(folder / fmt::format("view_{:02}.png", i + 1), pictures[i],
                       pictureMetadata("views", parameters));
        }
    }

    std::string text(const views::ViewPlan& plan, const views::CoverageReport& report, double seconds) const {
        std::string lines = fmt::format(
            "{}: {} views in {} {} cover {:.6g} % of the area of {} faces, {} without area; {:.2f} s",
            folder.string(), plan.groups.size(), plan.passes, plan.passes == 1 ? "pass" : "passes",
            report.covered * 100, report.faces, report.unreachable, seconds);
        for (std::size_t i = 0; i < plan.groups.size(); ++i) {
            const views::ViewCoverage& view = report.views[i];
            double shared = 0;
            for (std::size_t j = 0; j < plan.groups.size(); ++j)
                if (j != i) shared = std::max(shared, view.overlap[j]);
            lines += fmt::format(
                "\n{:<8} pass {}  {:>7} faces, {:5.1f} % of the area, at {:2.0f}° on average, shares up to "
                "{:.1f} % with another",
                plan.groups[i].view.name, plan.groups[i].pass, view.faces, view.area * 100, view.meanAngle,
                shared * 100);
        }
        return lines;
    }
};

}  // namespace

void addViewsCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand(
        "views",
        "Plan the views that paint a mesh, and tell the faces of each; the file's objects are taken "
        "as one (§4.3)");
    auto state = std::make_shared<ViewsCommand>();
    command->add_option("MESH", state->mesh, "OBJ, PLY, OFF, STL, GLB or glTF")->required();
    command->add_option("-o,--output", state->folder, "Folder for views.json and view_01.png ...")
        ->required();
    addParameterFlags(*command, state->params);
    command->add_option_function<std::string>(
        "--up",
        [state](const std::string& text) {
            const std::vector<float> v = numbersFrom("--up", text, 3);
            state->params.up = {v[0], v[1], v[2]};
            if (state->params.up == glm::dvec3(0))
                throw CLI::ValidationError("--up: is 0,0,0; write a direction that is not zero");
        },
        "x,y,z: what stands upright in the views, any length but zero (default 0,1,0)");
    session.addCommonFlags(*command);
    command->callback([state, &session] { state->run(session); });
}

}  // namespace chiaro::cli
