#include "core/synthesis/quilting.h"

#include "core/base/error.h"
#include "core/synthesis/block_grid.h"
#include "core/synthesis/boundary_cut.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <atomic>
#include <optional>

namespace chiaro::synthesis {

namespace {

// A picture in the making. Blocks that overlap are placed one after the other, others at the same time.
class Quilter {
public:
    Quilter(const QuiltTask& task, const QuiltParams& params, const BlockGrid& grid)
        : m_task(task),
          m_params(params),
          m_grid(grid),
          m_own(task.prepared ? std::nullopt : std::optional<SearchTexture>(*task.source)),
          m_source(task.prepared ? *task.prepared : *m_own),
          m_made(task.width, task.height),
          m_placed(std::size_t(grid.count())) {
        m_result.texture = ColorImage(task.width, task.height, glm::vec3(0));
        m_result.origin = Image<glm::i16vec2>(task.width, task.height, glm::i16vec2(-1));
        if (task.filled) takeFilled();
    }

    void place(int index) {
        Workspace& work = m_workspaces.local();
        const BlockSite site = m_grid.site(index);
        if (!look(site, work)) return;
        const BlockMatch match = search(site, work);
        PlacedBlock placed{site, match.position, 0, 0};
        compare(placed, work);
        copy(placed, boundaryCut(work.under, work.error, m_grid.widestOverlap()));
        m_placed[std::size_t(index)] = placed;
    }

    QuiltResult finish() {
        for (const auto& placed : m_placed)
            if (placed) m_result.blocks.push_back(*placed);
        return std::move(m_result);
    }

private:
    struct Workspace {
        Image<Under> under;
        ScalarImage error;
        std::vector<SearchTemplate> templates;
        SearchMemory memory;
    };

    void takeFilled() {
        for (int y = 0; y < m_task.height; ++y)
            for (int x = 0; x < m_task.width; ++x) {
                if (!valid({x, y}) || !(*m_task.filledWhere)(x, y)) continue;
                m_result.texture(x, y) = (*m_task.filled)(x, y);
                m_made(x, y) = m_source.rounded((*m_task.filled)(x, y));
                m_made(x, y).counts = true;
            }
    }

    bool valid(glm::ivec2 pixel) const { return !m_task.valid || (*m_task.valid)(pixel.x, pixel.y) != 0; }

    glm::ivec2 pixelAt(const BlockSite& site, int x, int y) const {
        glm::ivec2 pixel = site.position + glm::ivec2(x, y);
        if (pixel.x >= m_task.width) pixel.x -= m_task.width;
        if (pixel.y >= m_task.height) pixel.y -= m_task.height;
        return pixel;
    }

    template <class Visit>
    void eachPixel(const BlockSite& site, Visit&& visit) const {
        for (int y = 0; y < site.size.y; ++y)
            for (int x = 0; x < site.size.x; ++x) visit(x, y, pixelAt(site, x, y));
    }

    // What lies under a block, and what of it the block should match; false when nothing is missing there.
    bool look(const BlockSite& site, Workspace& work) const {
        bool missing = false;
        work.under = Image<Under>(site.size.x, site.size.y);
        work.templates.resize(1);
        Image<SearchPixel>& goal = work.templates.front().pixels;
        goal = Image<SearchPixel>(site.size.x, site.size.y);
        eachPixel(site, [&](int x, int y, glm::ivec2 pixel) {
            const SearchPixel& made = m_made(pixel.x, pixel.y);
            goal(x, y) = made;
            missing |= !made.counts && valid(pixel);
            work.under(x, y) = made.counts ? Under::Texture : valid(pixel) ? Under::Nothing : Under::Outside;
        });
        return missing;
    }

    BlockMatch search(const BlockSite& site, Workspace& work) const {
        if (m_task.previous && m_task.previousWeight > 0) addPrevious(site, work);
        const CandidateArea area = candidates(site);
        const auto excluded = excludedAround(usedNearby(site), area, m_params.block);
        return findBlock(m_source, {work.templates, area, excluded, m_params.tolerance},
                         Random(m_params.seed, std::uint64_t(site.index)), work.memory);
    }

    std::vector<glm::ivec2> usedNearby(const BlockSite& site) const {
        std::vector<glm::ivec2> used;
        for (const int index : m_grid.earlier(site.index, m_task.variety))
            if (const auto& placed = m_placed[std::size_t(index)]) used.push_back(placed->source);
        return used;
    }

    void addPrevious(const BlockSite& site, Workspace& work) const {
        SearchTemplate previous;
        previous.pixels = Image<SearchPixel>(site.size.x, site.size.y);
        eachPixel(site, [&](int x, int y, glm::ivec2 pixel) {
            if (work.under(x, y) == Under::Outside) return;
            if (m_task.previousWhere && !(*m_task.previousWhere)(pixel.x, pixel.y)) return;
            previous.pixels(x, y) = m_source.rounded((*m_task.previous)(pixel.x, pixel.y));
            previous.pixels(x, y).counts = true;
        });
        const auto counted = [](const SearchTemplate& goal) {
            return double(std::ranges::count_if(goal.pixels.pixels(), &SearchPixel::counts));
        };
        const double overlapPixels = counted(work.templates.front()), previousPixels = counted(previous);
        if (previousPixels == 0) return;
        // Both errors are means over their pixels; only their ratio matters.
        previous.weight = overlapPixels > 0 ? m_task.previousWeight * overlapPixels / previousPixels : 1.0;
        work.templates.push_back(std::move(previous));
    }

    CandidateArea candidates(const BlockSite& site) const {
        const CandidateArea all{0, 0, m_source.width() - m_params.block + 1,
                                m_source.height() - m_params.block + 1};
        return m_task.candidates ? m_task.candidates(site) : all;
    }

    const glm::vec3& sourceAt(const PlacedBlock& placed, int x, int y) const {
        return (*m_task.source)(placed.source.x + x, placed.source.y + y);
    }

    void compare(PlacedBlock& placed, Workspace& work) const {
        work.error = ScalarImage(placed.site.size.x, placed.site.size.y, 0.0f);
        eachPixel(placed.site, [&](int x, int y, glm::ivec2 pixel) {
            if (work.under(x, y) != Under::Texture) return;
            const glm::vec3 difference = sourceAt(placed, x, y) - m_result.texture(pixel.x, pixel.y);
            work.error(x, y) = glm::dot(difference, difference);
            placed.overlapError += double(work.error(x, y));
            ++placed.overlapPixels;
        });
    }

    void copy(const PlacedBlock& placed, const Image<std::uint8_t>& stays) {
        eachPixel(placed.site, [&](int x, int y, glm::ivec2 pixel) {
            if (stays(x, y) || !valid(pixel)) return;
            const glm::ivec2 from = placed.source + glm::ivec2(x, y);
            m_result.texture(pixel.x, pixel.y) = (*m_task.source)(from.x, from.y);
            m_result.origin(pixel.x, pixel.y) = glm::i16vec2(from);
            m_made(pixel.x, pixel.y) = m_source.pixels()(from.x, from.y);
            m_made(pixel.x, pixel.y).counts = true;
        });
    }

    const QuiltTask& m_task;
    const QuiltParams& m_params;
    const BlockGrid& m_grid;
    std::optional<SearchTexture> m_own;  // where the task has none
    const SearchTexture& m_source;
    Image<SearchPixel> m_made;  // the picture as the search compares it; counts where there is something
    QuiltResult m_result;
    std::vector<std::optional<PlacedBlock>> m_placed;
    tbb::enumerable_thread_specific<Workspace> m_workspaces;
};

// Places each block as soon as those that it overlaps with and that come earlier are in place.
void placeAll(Quilter& quilter, const BlockGrid& grid, Task::Steps& steps) {
    const auto successors = grid.successors();
    std::vector<std::atomic<int>> waiting(successors.size());
    for (const auto& later : successors)
        for (const int other : later) ++waiting[std::size_t(other)];
    std::vector<int> ready;
    for (int index = 0; index < grid.count(); ++index)
        if (waiting[std::size_t(index)] == 0) ready.push_back(index);
    tbb::parallel_for_each(ready, [&](int index, tbb::feeder<int>& feeder) {
        quilter.place(index);
        steps.done();
        for (const int other : successors[std::size_t(index)])
            if (--waiting[std::size_t(other)] == 0) feeder.add(other);
    });
}

BlockGrid gridOf(const QuiltTask& task, const QuiltParams& fitted) {
    return BlockGrid(task.width, task.height, fitted.block, fitted.overlapPixels(), task.wrap);
}

}  // namespace

const ParameterTable<QuiltParams>& QuiltParams::table() {
    static const auto table =
        ParameterTable<QuiltParams>()
            .add(&QuiltParams::block,
                 ParameterSpec::integer(
                     "block", "Block", "px", 4, 256,
                     "Side of the pieces the texture is cut into; larger keeps longer strokes "
                     "whole, smaller follows the light more closely."))
            .add(&QuiltParams::overlap,
                 ParameterSpec::integer("overlap", "Overlap", "px", 0, 128,
                                        "How far pieces overlap to hide their seams; 0 takes a sixth of the "
                                        "block."))
            .add(&QuiltParams::tolerance,
                 ParameterSpec::real(
                     "tolerance", "Tolerance", "", 0, 1, 0.05,
                     "How much worse than the best fit a piece may be: more gives more variety, "
                     "less gives better seams."))
            .add(&QuiltParams::seed,
                 ParameterSpec::integer("seed", "Seed", "", 0, 0x1p53,
                                        "Another number gives another arrangement of the same paint."));
    return table;
}

int QuiltParams::overlapPixels() const {
    const int wanted = overlap > 0 ? overlap : std::max(int(std::lround(block / 6.0)), 2);
    return std::min(wanted, block / 2);
}

QuiltReport QuiltResult::report() const {
    QuiltReport report{blocks.size(), 0};
    std::size_t pixels = 0;
    for (const PlacedBlock& block : blocks) {
        report.overlapError += block.overlapError;
        pixels += block.overlapPixels;
    }
    if (pixels > 0) report.overlapError /= double(pixels);
    return report;
}

QuiltParams fittedBlock(const QuiltParams& params, const QuiltTask& task) {
    QuiltParams fitted = params;
    const int side = std::min(task.source->width(), task.source->height());
    if (fitted.block > side) fitted.block = std::max(3 * side / 4, 1);
    if (task.wrap)
        fitted.block = std::clamp(fitted.block, 1, std::max(std::min(task.width, task.height) / 2, 1));
    return fitted;
}

std::size_t blockCount(const QuiltTask& task, const QuiltParams& params) {
    return std::size_t(gridOf(task, fittedBlock(params, task)).count());
}

QuiltResult quilt(const QuiltTask& task, const QuiltParams& params, Task::Steps& steps) {
    if (!task.source || task.source->empty())
        throw Error("texture", "is empty", "quilting needs a strip with at least one pixel");
    const QuiltParams fitted = fittedBlock(params, task);
    const BlockGrid grid = gridOf(task, fitted);
    Quilter quilter(task, fitted, grid);
    placeAll(quilter, grid, steps);
    return quilter.finish();
}

QuiltResult quilt(const QuiltTask& task, const QuiltParams& params, const Task& progress) {
    progress.checkpoint();
    Task::Steps steps(progress, task.source && !task.source->empty() ? blockCount(task, params) : 1);
    return quilt(task, params, steps);
}

}  // namespace chiaro::synthesis
