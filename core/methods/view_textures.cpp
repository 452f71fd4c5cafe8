#include "core/methods/view_textures.h"

#include "core/base/random.h"
#include "core/methods/view_map.h"

#include <glm/gtc/noise.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <map>

namespace chiaro::methods {

namespace {

/// A view copies from another that sees the face at least as well: where the two meet, strokes are then
/// equally stretched on both sides, and run on. By this much, as the logarithm of the proportion, the border
/// swings to and fro, once in so many blocks, so that a change of the strokes' direction is not ruled along a
/// line.
constexpr float borderSwing = 0.4f;
constexpr float borderWave = 1.5f;

/// Texels a side of the map of a view along a needle.
constexpr int leastMapSize = 32;

/// Where a texel's texture comes from in a view that is done.
struct Copy {
    std::uint32_t group;
    glm::vec2 position;  ///< in that view's map
};

/// Views in the order of their synthesis (§4.3.5).
std::vector<std::size_t> synthesisOrder(const PlannedObject& object) {
    const views::CoverageReport report = views::measureCoverage(object.surface, object.plan);
    const std::size_t count = report.views.size();
    std::vector<double> attraction(count, 0);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            if (i != j) attraction[i] += report.views[i].overlap[j];
    std::vector<std::size_t> order;
    std::vector<bool> isDone(count, false);
    while (order.size() < count) {
        std::size_t next = count;
        for (std::size_t i = 0; i < count; ++i)
            if (!isDone[i] && (next == count || attraction[i] > attraction[next])) next = i;
        if (order.empty()) std::ranges::fill(attraction, 0.0);
        for (std::size_t i = 0; i < count; ++i) attraction[i] += report.views[next].overlap[i];
        isDone[next] = true;
        order.push_back(next);
    }
    return order;
}

/// Sums over the squares of 2 radius + 1 texels around each texel.
Image<int> boxSums(const Image<int>& image, int radius) {
    Image<int> rows(image.width(), image.height()), sums(image.width(), image.height());
    const auto run = [radius](int length, const auto& from, const auto& to) {
        int sum = 0;
        for (int i = 0; i < std::min(radius, length); ++i) sum += from(i);
        for (int i = 0; i < length; ++i) {
            if (i + radius < length) sum += from(i + radius);
            if (i - radius - 1 >= 0) sum -= from(i - radius - 1);
            to(i) = sum;
        }
    };
    for (int y = 0; y < image.height(); ++y)
        run(
            image.width(), [&](int x) { return image(x, y); }, [&](int x) -> int& { return rows(x, y); });
    for (int x = 0; x < image.width(); ++x)
        run(
            image.height(), [&](int y) { return rows(x, y); }, [&](int y) -> int& { return sums(x, y); });
    return sums;
}

class ViewSynthesis {
public:
    ViewSynthesis(const PlannedObject& object, const std::vector<synthesis::LevelSource>& sources,
                  bool propagate)
        : m_object(object), m_sources(sources), m_propagate(propagate), m_faceGroups(object) {
        for (const synthesis::LevelSource& source : sources) m_prepared.emplace_back(source.texture);
        m_textures.views.resize(object.plan.groups.size());
        m_maps.resize(object.plan.groups.size());
        m_isDone.resize(object.plan.groups.size(), false);
    }

    ViewTextures run(const Task& task) {
        const std::vector<std::size_t> order = synthesisOrder(m_object);
        for (std::size_t i = 0; i < order.size(); ++i) {
            task.checkpoint();
            make(order[i], task.part(double(i) / double(order.size()), double(i + 1) / double(order.size())));
        }
        synthesis::QuiltResult all;
        all.blocks = std::move(m_blocks);
        m_textures.report = all.report();
        return std::move(m_textures);
    }

private:
    void make(std::size_t group, const Task& task) {
        m_maps[group] = ViewMap::of(m_object, group);
        const ViewMap& map = m_maps[group];
        m_isDone[group] = true;
        if (map.face.empty()) return;
        const Image<std::optional<Copy>> copies =
            m_propagate ? copiesFor(group) : Image<std::optional<Copy>>();
        std::vector<synthesis::QuiltResult> made(m_sources.size());
        Task::Steps steps(task, m_sources.size());
        tbb::parallel_for(std::size_t(0), m_sources.size(), [&](std::size_t level) {
            made[level] = quilted(group, level, copies);
            steps.done();
        });
        ViewTexture& texture = m_textures.views[group];
        texture.origin = map.origin;
        for (synthesis::QuiltResult& result : made) {
            Image<PackedTexel>& texels =
                texture.levels.emplace_back(result.texture.width(), result.texture.height());
            std::ranges::transform(result.texture.pixels(), texels.pixels().begin(), packed);
            m_blocks.insert(m_blocks.end(), result.blocks.begin(), result.blocks.end());
        }
        if (m_propagate) copyBack(group, made);
    }

    synthesis::QuiltResult quilted(std::size_t group, std::size_t level,
                                   const Image<std::optional<Copy>>& copies) const {
        const ViewMap& map = m_maps[group];
        synthesis::QuiltTask task;
        task.source = &m_sources[level].texture;
        task.prepared = &m_prepared[level];
        task.width = map.face.width();
        task.height = map.face.height();
        task.valid = &map.covered;
        task.variety = synthesis::levelVariety;
        ColorImage filled;
        synthesis::PixelMask filledWhere;
        if (!copies.empty()) {
            filled = ColorImage(task.width, task.height);
            filledWhere = synthesis::PixelMask(task.width, task.height);
            for (std::size_t i = 0; i < copies.pixelCount(); ++i)
                if (const auto& copy = copies.pixels()[i]) {
                    filled.pixels()[i] = m_textures.views[copy->group].at(level, copy->position);
                    filledWhere.pixels()[i] = 1;
                }
            task.filled = &filled;
            task.filledWhere = &filledWhere;
        }
        synthesis::QuiltParams params = m_sources[level].quilt;
        params.seed = Random(params.seed, group).bits();
        return synthesis::quilt(task, synthesis::fittedBlock(params, task));
    }

    /// Where each texel of a view is to be copied from: from the view that sees its face best among those
    /// that are done, where that one sees it as well. Single texels follow most of their neighbours.
    Image<std::optional<Copy>> copiesFor(std::size_t group) const {
        const ViewMap& map = m_maps[group];
        std::map<std::size_t, ViewMapping> ways;
        for (std::size_t other = 0; other < m_maps.size(); ++other)
            if (isPainted(other, group)) ways.try_emplace(other, m_object, group, other);
        Image<std::optional<Copy>> copies(map.face.width(), map.face.height());
        Image<int> covered(map.face.width(), map.face.height()), wanted = covered;
        tbb::parallel_for(0, map.face.height(), [&](int y) {
            for (int x = 0; x < map.face.width(); ++x) {
                if (!map.covered(x, y)) continue;
                covered(x, y) = 1;
                float ratio = 0;
                copies(x, y) = bestCopy(group, map.face(x, y), map.center(x, y), ways, ratio);
                wanted(x, y) = copies(x, y) && ratio >= leastRatio(map.center(x, y));
            }
        });
        const int radius = std::max(m_sources.front().quilt.block / 4, 1);
        const Image<int> coveredSums = boxSums(covered, radius), wantedSums = boxSums(wanted, radius);
        for (std::size_t i = 0; i < copies.pixelCount(); ++i)
            if (2 * wantedSums.pixels()[i] < coveredSums.pixels()[i]) copies.pixels()[i].reset();
        return copies;
    }

    /// How well another view must see the place for its texture to be taken.
    float leastRatio(glm::vec2 position) const {
        const float wave = borderWave * float(m_sources.front().quilt.block);
        return std::exp(borderSwing * glm::perlin(position / wave));
    }

    /// `ratio` tells how well that view sees the face in proportion to this one.
    std::optional<Copy> bestCopy(std::size_t group, std::uint32_t face, glm::vec2 position,
                                 const std::map<std::size_t, ViewMapping>& ways, float& ratio) const {
        const FaceGroups::Membership* best = nullptr;
        float own = 0;
        for (const FaceGroups::Membership& one : m_faceGroups.of(face)) {
            if (one.group == group)
                own = one.facing;
            else if (ways.contains(one.group) && (!best || one.facing > best->facing))
                best = &one;
        }
        if (!best) return {};
        const auto there = ways.at(best->group).map(face, position);
        if (!there || !m_maps[best->group].covers(*there)) return {};
        ratio = best->facing / own;
        return Copy{best->group, *there};
    }

    /// Copies what was quilted anew into the views that were done before.
    void copyBack(std::size_t group, const std::vector<synthesis::QuiltResult>& made) {
        for (std::size_t other = 0; other < m_maps.size(); ++other) {
            if (!isPainted(other, group)) continue;
            const ViewMapping way(m_object, other, group);
            const ViewMap& map = m_maps[other];
            tbb::parallel_for(0, map.face.height(), [&](int y) {
                for (int x = 0; x < map.face.width(); ++x)
                    if (map.covered(x, y))
                        if (const auto there = way.map(map.face(x, y), map.center(x, y)))
                            copyTexel(group, *there, made, m_textures.views[other], {x, y});
            });
        }
    }

    void copyTexel(std::size_t group, glm::vec2 from, const std::vector<synthesis::QuiltResult>& made,
                   ViewTexture& into, glm::ivec2 texel) {
        if (!m_maps[group].covers(from)) return;
        const glm::ivec2 source = glm::ivec2(glm::floor(from)) - m_maps[group].origin;
        for (std::size_t level = 0; level < made.size(); ++level)
            if (made[level].origin(source.x, source.y).x >= 0)
                into.levels[level](texel.x, texel.y) = packed(m_textures.views[group].at(level, from));
    }

    /// Whether another view than this one is done and has texels.
    bool isPainted(std::size_t other, std::size_t group) const {
        return other != group && m_isDone[other] && !m_maps[other].face.empty();
    }

    const PlannedObject& m_object;
    const std::vector<synthesis::LevelSource>& m_sources;
    bool m_propagate;
    FaceGroups m_faceGroups;
    std::vector<synthesis::SearchTexture> m_prepared;
    std::vector<ViewMap> m_maps;
    std::vector<bool> m_isDone;
    std::vector<synthesis::PlacedBlock> m_blocks;
    ViewTextures m_textures;
};

/// Makes the maps of views that come closer smaller, so that strokes are of one size all over the object.
void evenDensity(views::ViewPlan& plan) {
    double widest = 0;
    for (const views::FaceGroup& group : plan.groups) widest = std::max(widest, group.view.halfExtent);
    for (views::FaceGroup& group : plan.groups) {
        const double share = group.view.halfExtent / widest;
        group.view.size = std::max(int(std::lround(group.view.size * share)), leastMapSize);
    }
}

}  // namespace

std::shared_ptr<const PlannedObject> planObject(std::shared_ptr<const scene::Mesh> mesh,
                                                const views::ViewParams& params,
                                                const std::vector<views::View>& kept, const Task& task) {
    views::Surface surface(std::move(mesh));
    views::ViewPlan plan = views::withSteepFacesSeen(
        surface, views::planViews(surface, params, kept, task.part(0, 0.8)), params, task.part(0.8, 1));
    evenDensity(plan);
    return std::make_shared<const PlannedObject>(PlannedObject{std::move(surface), std::move(plan)});
}

PackedTexel packed(glm::vec3 difference) {
    return PackedTexel(glm::round(glm::clamp(difference, -1.0f, 1.0f) * 32767.0f));
}

glm::vec3 unpacked(PackedTexel texel) {
    return glm::vec3(texel) / 32767.0f;
}

glm::vec3 ViewTexture::at(std::size_t level, glm::vec2 position) const {
    const Image<PackedTexel>& texels = levels[level];
    const glm::vec2 last(texels.width() - 1, texels.height() - 1);
    const glm::vec2 place = glm::clamp(position - glm::vec2(origin) - 0.5f, glm::vec2(0), last);
    const glm::ivec2 base(place);
    const glm::vec2 t = place - glm::vec2(base);
    const glm::ivec2 next = glm::min(base + 1, glm::ivec2(last));
    const auto row = [&](int y) {
        return glm::mix(glm::vec3(texels(base.x, y)), glm::vec3(texels(next.x, y)), t.x);
    };
    return glm::mix(row(base.y), row(next.y), t.y) * (1 / 32767.0f);  // unpacks once what it reads four times
}

ViewTextures synthesizeViews(const PlannedObject& object, const std::vector<synthesis::LevelSource>& sources,
                             bool propagate, const Task& task) {
    return ViewSynthesis(object, sources, propagate).run(task);
}

}  // namespace chiaro::methods
