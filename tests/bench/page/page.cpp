#include "tests/bench/page/page.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace chiaro::bench {

namespace {

/// The processor's name and the memory, as the system tells them.
std::string systemValue(const char* file, const std::string& key) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
        if (const auto colon = line.find(':'); line.starts_with(key) && colon != std::string::npos)
            return line.substr(line.find_first_not_of(" \t", colon + 1));
    return {};
}

std::string machineLine(const Results& results, const PageOptions& options) {
    const Results::Machine& machine = results.machine();
    std::string processor = systemValue("/proc/cpuinfo", "model name");
    if (processor.empty()) processor = "a processor without a name";
    double kilobytes = 0;
    std::istringstream(systemValue("/proc/meminfo", "MemTotal")) >> kilobytes;
    std::string line = fmt::format(
        "Measured on {} on {}: {} processors, {:.0f} GB of memory, instructions of {}",
        machine.date.substr(0, 10), processor, machine.processors, kilobytes / 1e6, options.instructionSet);
    if (!machine.renderer.empty()) line += ", OpenGL by " + machine.renderer;
    line += fmt::format(". The machine's load before the first benchmark was {:.1f}", machine.load);
    line += machine.load > 0.5 * machine.processors
                ? ", so **others were using it and times are longer than they need be**."
                : ".";
    if (options.isQuick)
        line +=
            " **This was the short form (`./dev bench --quick`): figures are rough and some are missing.**";
    return line;
}

std::string goalOf(const Figure& figure) {
    if (figure.goal == Goal::None) return "";
    return (figure.goal == Goal::AtMost ? "at most " : "at least ") + inWords(figure.target, figure.unit);
}

std::string verdictOf(const Figure& figure, double value) {
    if (figure.goal == Goal::None) return "";
    const bool met = figure.goal == Goal::AtMost ? value <= figure.target : value >= figure.target;
    return met ? "met" : "**missed**";
}

void writeSection(std::string& page, const Section& section, const Results& results) {
    std::string rows;
    for (const Figure& figure : section.figures) {
        const std::optional<double> value = measured(figure, results);
        if (!value && figure.isOptional && !results.has(figure.value.program)) continue;
        std::string command =
            fmt::format("`{} {}`", figure.value.program, results.named(figure.value.benchmark));
        if (!figure.over.program.empty() && figure.over.benchmark != figure.value.benchmark)
            command += fmt::format(" / `{} {}`", figure.over.program, results.named(figure.over.benchmark));
        rows += fmt::format("| {} | {} | {} | {} | {} |\n", figure.what,
                            value ? inWords(*value, figure.unit) : "not measured", goalOf(figure),
                            value ? verdictOf(figure, *value) : "", command);
    }
    if (rows.empty()) return;
    page += fmt::format("## {}\n\n{}\n\n", section.title, section.introduction);
    page += "| what | measured | target | verdict | by |\n| --- | --- | --- | --- | --- |\n" + rows + "\n";
}

void writeCurves(std::string& page, const std::vector<Curves>& all, const PageOptions& options) {
    if (all.empty()) return;
    page += "## How it grows\n\nAxes with equal factors equally far apart show powers as straight lines.\n\n";
    for (const Curves& curves : all)
        page += fmt::format("{}\n\n![{}]({}/{})\n\n", curves.words, curves.chart.title, options.pictures,
                            curves.file);
}

constexpr const char* introduction =
    R"(Every figure here comes from one run of `./dev bench`, which writes this page; none is typed by hand. Peers and bounds
are measured in the same run on the same machine, since times alone say little about other machines. A row's own
command is `build/release/bin/bench_PROGRAM --benchmark_filter=NAME`, both from its last column. Times are those of a
clock, all threads at work, unless the row says otherwise.
)";

constexpr const char* lessons = R"(## What was learned

- **The search is multiply-adds.** A block's error is the template's squares, plus the place's squares, which an integral
  image knows, less twice their product: only the product is work. In 8-bit integers it runs near what the processor can
  do and stays exact, so every instruction set paints the same picture. More speed must come from looking at fewer
  places, as drafts do.
- **A float library call for each block loses twice**: in arithmetic that is wider than the values, and in copies.
- **What only the light or the colours change costs no search.** Texture is kept apart from colour; shading it anew takes
  a small part of a synthesis.
- **Memory follows the picture, not the search**: the errors of one block at a time are all that a thread keeps.
- **Views are cheap, texels are not.** Planning half a million faces takes less than painting the skull's maps; so
  textures are kept on disk between runs, and reading them is bound by checking that they are whole.
- **In the viewport a software renderer counts texture reads**: each further texture that a pixel blends costs about
  the same, whatever the mesh.
- **A pruned exact scan beats trees at 150 dimensions**: cheap lower bounds reject nearly all of the strip before a whole
  distance is computed.
)";

}  // namespace

std::string performancePage(const Results& results, const std::vector<Curves>& curves,
                            const PageOptions& options) {
    std::string page =
        fmt::format("# Performance\n\n{}\n{}\n\n", introduction, machineLine(results, options));
    for (const Section& section : sections()) writeSection(page, section, results);
    writeCurves(page, curves, options);
    page += lessons;
    if (!results.failures().empty()) {
        page += "\n## What failed\n\n";
        for (const std::string& failure : results.failures()) page += "- " + failure + "\n";
    }
    return page;
}

}  // namespace chiaro::bench
