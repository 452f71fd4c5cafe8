#include "core/synthesis/levels.h"

#include "core/base/error.h"
#include "core/synthesis/tiling.h"

#include <spdlog/fmt/fmt.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace chiaro::synthesis {

namespace {

struct Columns {
    int begin, end;
};

// A section of the strip; where that is too narrow for a block and some choice, widened about its centre.
Columns sectionColumns(int width, int count, int index, int block) {
    const auto edge = [&](int i) { return int(std::int64_t(i) * width / count); };
    Columns columns{edge(index), edge(index + 1)};
    const int wanted = std::min(block + block / 2, width);
    const int missing = wanted - (columns.end - columns.begin);
    if (missing <= 0) return columns;
    columns.begin = std::clamp(columns.begin - missing / 2, 0, width - wanted);
    columns.end = columns.begin + wanted;
    return columns;
}

// The strip less the gradient, or less the mean colour of the section proper.
ColorImage sectionTexture(const ColorImage& strip, const std::vector<glm::vec3>& gradient,
                          const LevelParams& params, int index, Columns columns) {
    glm::dvec3 mean(0);
    if (params.base == LevelBase::Section) {
        const Columns section = sectionColumns(strip.width(), params.count, index, 1);
        for (int y = 0; y < strip.height(); ++y)
            for (int x = section.begin; x < section.end; ++x) mean += glm::dvec3(strip(x, y));
        mean /= double(strip.height()) * double(section.end - section.begin);
    }
    ColorImage texture(columns.end - columns.begin, strip.height());
    for (int y = 0; y < texture.height(); ++y)
        for (int x = 0; x < texture.width(); ++x) {
            const int column = columns.begin + x;
            texture(x, y) =
                strip(column, y) -
                (params.base == LevelBase::Section ? glm::vec3(mean) : gradient[std::size_t(column)]);
        }
    return texture;
}

// One slice in the making.
struct Level {
    const LevelSource& source;
    QuiltTask task;
};

std::vector<Level> prepareLevels(const std::vector<LevelSource>& sources, int size) {
    std::vector<Level> levels;
    for (const LevelSource& source : sources) {
        Level& level = levels.emplace_back(Level{source, {}});
        level.task.source = &source.texture;
        level.task.width = level.task.height = size;
        level.task.variety = levelVariety;
    }
    return levels;
}

QuiltResult quiltLevel(const Level& level, Tiling tiling, Task::Steps& steps) {
    if (tiling == Tiling::Seam) return quiltTileable(level.task, level.source.quilt, steps);
    QuiltResult result = quilt(level.task, level.source.quilt, steps);
    result.texture = tiledByMask(result.texture);
    return result;
}

std::size_t levelBlockCount(const Level& level, Tiling tiling) {
    return tiling == Tiling::Seam ? tileableBlockCount(level.task, level.source.quilt)
                                  : blockCount(level.task, level.source.quilt);
}

QuiltReport joined(const std::vector<QuiltResult>& results) {
    QuiltResult all;
    for (const QuiltResult& result : results)
        all.blocks.insert(all.blocks.end(), result.blocks.begin(), result.blocks.end());
    return all.report();
}

}  // namespace

const ParameterTable<LevelParams>& LevelParams::table() {
    static const auto table =
        ParameterTable<LevelParams>()
            .add(&LevelParams::count,
                 ParameterSpec::integer(
                     "count", "Levels", "", 2, 32,
                     "Sections the strip is divided into, from dark to light; each becomes a "
                     "level of texture."))
            .add(&LevelParams::size, ParameterSpec::integer("size", "Level size", "px", 64, 2048,
                                                            "Side of a level; larger repeats less often."))
            .add(&LevelParams::tiling,
                 ParameterSpec::choice("tiling", "Tiling", {"mask", "seam"},
                                       "How levels repeat: mixed by the report's round mask, which blurs, or "
                                       "cut along a seam, which does not."))
            .add(&LevelParams::base,
                 ParameterSpec::choice(
                     "base", "Base", {"section", "gradient"},
                     "What is taken off the paint before it becomes texture: a section's mean "
                     "colour, or the gradient."));
    return table;
}

std::vector<LevelSource> levelSources(const ColorImage& strip, const std::vector<glm::vec3>& gradient,
                                      const LevelParams& params) {
    if (strip.empty()) throw Error("strip", "is empty", "levels need a strip of paint");
    if (gradient.size() != std::size_t(strip.width()))
        throw Error("gradient", fmt::format("has {} colours", gradient.size()),
                    fmt::format("give one for each of the strip's {} columns", strip.width()));
    LevelParams::table().check(params);
    QuiltParams::table().check(params.quilt);
    std::vector<LevelSource> sources(std::size_t(params.count));
    const int block = std::min(params.quilt.block, strip.height());
    for (int i = 0; i < params.count; ++i) {
        LevelSource& source = sources[std::size_t(i)];
        source.quilt = params.quilt;
        source.quilt.seed = Random(params.quilt.seed, std::uint64_t(i)).bits();
        source.texture =
            sectionTexture(strip, gradient, params, i, sectionColumns(strip.width(), params.count, i, block));
    }
    return sources;
}

LevelStack makeLevels(const ColorImage& strip, const std::vector<glm::vec3>& gradient,
                      const LevelParams& params, const Task& task) {
    const std::vector<LevelSource> sources = levelSources(strip, gradient, params);
    const std::vector<Level> levels = prepareLevels(sources, params.size);
    std::size_t blocks = 0;
    for (const Level& level : levels) blocks += levelBlockCount(level, params.tiling);
    Task::Steps steps(task, blocks);

    std::vector<QuiltResult> results(levels.size());
    tbb::parallel_for(std::size_t(0), levels.size(),
                      [&](std::size_t i) { results[i] = quiltLevel(levels[i], params.tiling, steps); });
    LevelStack stack;
    stack.report = joined(results);
    for (QuiltResult& result : results) stack.levels.push_back(std::move(result.texture));
    return stack;
}

}  // namespace chiaro::synthesis
