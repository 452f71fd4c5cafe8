#include "app/cli/child_process.h"
#include "app/cli/demo/demo.h"
#include "app/cli/sheet.h"
#include "core/base/error.h"
#include "core/gradient/gradient.h"
#include "core/project/render_method.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro::cli::demo {

namespace fs = std::filesystem;

namespace {

/// The page's own colour, so that pictures stand on it without a frame.
const std::string paper = "#fbfaf7";
const glm::vec3 paperColor = glm::vec3(0xfb, 0xfa, 0xf7) / 255.0f;

/// Half as large, each pixel the mean of four.
ColorImage halved(const ColorImage& picture) {
    ColorImage half(picture.width() / 2, picture.height() / 2);
    for (int y = 0; y < half.height(); ++y)
        for (int x = 0; x < half.width(); ++x)
            half(x, y) = (picture(2 * x, 2 * y) + picture(2 * x + 1, 2 * y) + picture(2 * x, 2 * y + 1) +
                          picture(2 * x + 1, 2 * y + 1)) /
                         4.0f;
    return half;
}

/// Values in [-1, 1] as a picture, grey where they are 0.
ColorImage shownDifferences(const ColorImage& differences) {
    ColorImage shown = differences;
    for (glm::vec3& pixel : shown.pixels()) pixel = glm::clamp(pixel + 0.5f, 0.0f, 1.0f);
    return shown;
}

std::string nameOf(const fs::path& file) {
    return file.stem().string();
}

/// What export says that it can write.
std::string exportHelp() {
    return runProgram({fs::read_symlink("/proc/self/exe").string(), "export", "--help"}).out;
}

std::string figureText(double value) {
    return fmt::format("{:.3f}", value);
}

}  // namespace

std::vector<Demo::Part> Demo::parts() {
    return {{"The scene",
             "The project that the studio opens with: a skull whose paint was scanned from one strip.", 4,
             &Demo::makeScene},
            {"Six strips of paint",
             "Each is painted from dark to light, once. Below it the gradient that was found in it: the path "
             "that its "
             "colours take.",
             5, &Demo::makeStrips},
            {"Colour and texture apart",
             "What the gradient leaves over is the brush: grey where the paint has just its colour. Laid "
             "over another "
             "gradient, it is the same hand with other paint.",
             3, &Demo::makeSeparation},
            {"More of the texture",
             "The texture is quilted into eight levels, dark to light. Each tile is shown twice each way: "
             "there are no "
             "seams.",
             12, &Demo::makeLevels},
            {"Three ways to lay it on",
             "Quilted into the picture, from levels that follow the view, or on the surface itself.", 12,
             &Demo::makeMethods},
            {"In motion", "The same three ways on a turntable, and a light that goes around.", 30,
             &Demo::makeAnimations},
            {"Every mesh in every paint", "Three meshes, six strips, one light.", 8, &Demo::makeEverything},
            {"The views that paint a surface",
             "For paint that stays on the object, a few views see every face of it as squarely as can be.", 3,
             &Demo::makeViews},
            {"How like the strip",
             "Similarity says how far each place is from the nearest like it in the strip, shading how well "
             "its light is "
             "told; less is better. The maps show where.",
             5, &Demo::makeMeasures},
            {"How the measure answers",
             "The same measure on textures that were turned, scaled and torn, by how much they were.", 6,
             &Demo::makeStudy},
            {"The three ways compared",
             "One animation by each, measured in likeness, shading and calm from frame to frame. A short "
             "run; more "
             "frames and seeds give steadier figures.",
             12, &Demo::makeComparison},
            {"To take along", "The painted mesh for other programs, and the data behind this page.", 8,
             &Demo::makeExports}};
}

Demo::Words Demo::scene(const std::string& size) const {
    return {"--mesh=" + input("meshes/skull.glb"), "--sample=" + input("samples/oil.png"), "--size=" + size,
            "--background=" + paper};
}

void Demo::makeScene() {
    chiaro({"render", input("demo.chiaro"), "-o", m_folder / "demo.png", "--size=1280x960",
            "--background=" + paper});
    m_page.picture("demo.png", "The demo project, in oil", Width::Full);
}

void Demo::makeStrips() {
    for (const fs::path& sample : m_set.samples()) {
        const std::string name = nameOf(sample);
        fs::create_directories(m_folder / "strips");
        fs::copy_file(sample, m_folder / "strips" / sample.filename(), fs::copy_options::overwrite_existing);
        const gradient::Separation& found = m_set.paint(sample, m_task).separation;
        m_page.strip("strips/" + sample.filename().string(), found.gradient,
                     fmt::format("{}: {} of {} colours lie on the path, {:.3f} beside it", name,
                                 found.order.size(), found.texture.width(), found.residue));
    }
}

void Demo::makeSeparation() {
    const std::string oil = input("samples/oil.png");
    const nlohmann::json info = chiaro({"sample", "info", oil});
    chiaro({"sample", "gradient", oil, "-o", m_folder / "gradient.csv", "--averages",
            m_folder / "averages.csv", "--order", m_folder / "order.csv"});
    chiaro({"sample", "texture", oil, "-o", m_folder / "texture.exr"});
    chiaro({"sample", "recolor", oil, "--stops", "0 #201040, 0.5 #c04020, 1 #fff0b0", "-o",
            m_folder / "recolor-warm.png"});
    chiaro({"sample", "recolor", oil, "--stops", "0 #0b1f2a, 0.5 #3b8a7a, 1 #f2f0dc", "--space", "oklab",
            "-o", m_folder / "recolor-cool.png"});
    write("texture.png", shownDifferences(m_set.paint(oil).separation.texture), "texture");
    m_page.picture("texture.png", "The brush of the oil alone", Width::Third);
    m_page.picture("recolor-warm.png", "Violet to straw", Width::Third);
    m_page.picture("recolor-cool.png", "Sea, mixed in Oklab", Width::Third);
    m_page.table({"strip", "size", "kept", "residue"},
                 {{"oil", fmt::format("{} x {} px", info.value("width", 0), info.value("height", 0)),
                   std::to_string(info.value("kept", 0)), figureText(info.value("residue", 0.0))}},
                 "kept: colours in the sorted list; residue: RMS of column averages minus gradient");
}

void Demo::makeLevels() {
    chiaro({"levels", input("samples/oil.png"), "-o", m_folder / "levels", "--size=256"});
    for (const fs::path& sample : m_set.samples()) {
        const std::string name = nameOf(sample), file = "levels-" + name + ".png";
        const project::Paint& paint = m_set.paint(sample, m_task);
        write(file, halved(halved(levelSheet(paint.levels, paint.shown))), "levels of " + name);
        m_page.picture(file, name, Width::Half);
    }
}

void Demo::makeMethods() {
    for (const project::RenderMethod& method : project::renderMethods()) {
        Words words{"render"};
        for (const std::string& word : scene("768x768")) words.push_back(word);
        for (const std::string& word :
             {"--method=" + method.key, std::string("-o"), (m_folder / (method.key + ".png")).string()})
            words.push_back(word);
        if (method.takesGuides) words.push_back("--aux=" + (m_folder / "values").string());
        const nlohmann::json json = chiaro(words);
        m_page.picture(method.key + ".png",
                       fmt::format("{}, {:.1f} s", method.label, json["seconds"].value("total", 0.0)),
                       Width::Third);
    }
    chiaro({"render", "--guide", m_folder / "values/light.exr", "--ids", m_folder / "values/id.png",
            "--sample=" + input("samples/watercolour.png"), "--background=" + paper, "-o",
            m_folder / "guide.png"});
    m_page.picture("guide.png", "From a picture of light alone, in watercolour", Width::Third);
}

void Demo::animate(const std::string& file, const std::string& caption, const Words& how) {
    Words words{"animate"};
    for (const std::string& word : scene("400x400")) words.push_back(word);
    words.insert(words.end(), how.begin(), how.end());
    for (const std::string& word :
         {std::string("--overwrite"), std::string("-o"), (m_folder / file).string()})
        words.push_back(word);
    const nlohmann::json json = chiaro(words);
    if (!file.ends_with(".mp4")) return;
    const double perFrame = json.value("seconds", 0.0) / json.value("frames", 1);
    m_page.video(file, fmt::format("{}, {:.2f} s a frame", caption, perFrame), Width::Half);
}

void Demo::makeAnimations() {
    const Words turn{"--frames=1-24", "--period=96", "--fps=12"};
    const auto also = [&turn](Words words) {
        words.insert(words.end(), turn.begin(), turn.end());
        return words;
    };
    animate("turn-image-based.mp4", "Image-based, its texture moved with the surface",
            also({"--method=image-based", "--coherence=reprojected", "--every=8"}));
    animate("turn-view-aligned.mp4", "View-aligned", also({"--method=view-aligned"}));
    animate("turn-view-dependent.mp4", "View-dependent", also({"--method=view-dependent"}));
    animate("light.mp4", "View-aligned, the light goes around",
            {"--method=view-aligned", "--path=light", "--frames=1-24", "--period=24", "--fps=12"});
    animate("frames/turn.####.png", "", {"--method=view-aligned", "--frames=1-4", "--period=16"});
    for (int frame = 1; frame <= 4; ++frame)
        m_page.picture(fmt::format("frames/turn.{:04}.png", frame), fmt::format("frame {}", frame),
                       Width::Small);
}

void Demo::makeEverything() {
    constexpr int side = 480;
    for (const fs::path& mesh : m_set.meshes())
        for (const fs::path& sample : m_set.samples()) {
            const std::string file = nameOf(mesh) + "-" + nameOf(sample) + ".png";
            const std::string caption = nameOf(mesh) + " in " + nameOf(sample);
            write(file, methods::over(m_set.painted(mesh, sample, side, m_task), paperColor), caption);
            m_page.picture(file, caption, Width::Third);
        }
}

void Demo::makeViews() {
    const nlohmann::json json = chiaro({"views", input("meshes/skull.glb"), "-o", m_folder / "views"});
    for (std::size_t i = 0; i < json["views"].size(); ++i)
        m_page.picture(fmt::format("views/view_{:02}.png", i + 1),
                       fmt::format("{} faces", json["views"][i]["faces"].size()), Width::Small);
    m_page.table({"views", "faces", "coverage", "unreachable"},
                 {{std::to_string(json["views"].size()), std::to_string(json.value("faces", 0)),
                   fmt::format("{:.2f} %", json.value("coverage", 0.0) * 100),
                   std::to_string(json["unreachable"].size())}},
                 "coverage: share of the surface that some view paints");
}

void Demo::makeMeasures() {
    const fs::path folder = m_folder / "measured";
    std::vector<std::vector<std::string>> rows;
    for (const project::RenderMethod& method : project::renderMethods()) {
        const std::string name = "measured/" + method.key;
        Words words{"render"};
        for (const std::string& word : scene("192x192")) words.push_back(word);
        for (const std::string& word : {"--method=" + method.key, "--aux=" + folder.string(),
                                        std::string("-o"), (m_folder / (name + ".png")).string()})
            words.push_back(word);
        chiaro(words);
        const nlohmann::json json =
            chiaro({"measure", "--sample=" + input("samples/oil.png"), m_folder / (name + ".png"), "--light",
                    folder / "light.exr", "--mask", folder / "id.png", "--heatmap",
                    m_folder / (name + "-heat.png")});
        rows.push_back({method.label, figureText(json.value("similarity", 0.0)),
                        figureText(json.value("shading_mae", 0.0)),
                        figureText(json.value("shading_mse", 0.0))});
        m_page.picture(name + "-heat.png", method.label, Width::Third);
    }
    m_page.table({"method", "similarity", "shading, mean error", "shading, squared"}, rows,
                 "Of pictures of 192 x 192 px, 100 pixels each.");
}

void Demo::makeStudy() {
    chiaro({"measure", "study", "--sample=" + input("samples/oil.png"), "-o", m_folder / "study"});
    for (const char* curve : {"rotation", "scale", "discontinuity"})
        m_page.picture(fmt::format("study/{}.svg", curve), curve, Width::Half);
    m_page.picture("study/distortions.png",
                   "What was measured: as it is, turned, halved, doubled, torn twice", Width::Half);
}

void Demo::makeComparison() {
    const nlohmann::json json =
        chiaro({"compare", "--mesh=" + input("meshes/skull.glb"), "--sample=" + input("samples/oil.png"),
                "-o", m_folder / "compare", "--size=256x256", "--frames=3", "--seeds=1", "--pixels=400"});
    std::vector<std::vector<std::string>> rows;
    for (const project::RenderMethod& method : project::renderMethods()) {
        const nlohmann::json& one = json.at("methods").at(method.key);
        std::vector<std::string> row{method.label};
        for (const char* key : {"similarity", "shading_mae", "temporal_image", "temporal_object"})
            row.push_back(figureText(one.value(key, 0.0)));
        rows.push_back(row);
    }
    m_page.table({"method", "similarity", "shading", "in the picture", "on the object"}, rows,
                 "Errors; the last two from frame to frame.");
    m_page.picture("compare/frame.0001.png", "Image-based, view-aligned and view-dependent", Width::Full);
}

void Demo::makeExports() {
    Words kinds{"glb", "obj", "ply"};
    if (exportHelp().find(".html") != std::string::npos) kinds.push_back("html");
    for (const std::string& kind : kinds)
        chiaro({"export", "--mesh=" + input("meshes/skull.glb"), "--sample=" + input("samples/oil.png"),
                "--method=view-dependent", "--atlas=1024", "--overwrite", "-o",
                m_folder / ("skull." + kind)});
    if (kinds.back() == "html")
        m_page.file("skull.html", "a page of its own, in which the paint takes other light");
    m_page.file("skull.glb", "one file with its texture");
    m_page.file("skull.obj", "for programs that read OBJ, with");
    m_page.file("skull.mtl", "its material and");
    m_page.file("skull.png", "its texture");
    m_page.file("skull.ply", "a colour a vertex");
    m_page.file("gradient.csv", "the oil's gradient, a row a column");
    m_page.file("averages.csv", "its column averages");
    m_page.file("order.csv", "its colours as they were sorted");
    m_page.file("texture.exr", "its texture, 32-bit float");
    m_page.file("levels/level_0.exr", "the darkest of eight levels, 32-bit float");
    m_page.file("values/light.exr", "the light of the pictures above");
    m_page.file("views/views.json", "the planned views and their faces");
    m_page.file("study/study.csv", "the curves of the measure");
    m_page.file("compare/table.csv", "the comparison");
    m_page.file("compare/frames.csv", "the comparison frame by frame");
}

}  // namespace chiaro::cli::demo
