#include "core/views/planning.h"

#include "core/base/error.h"
#include "core/views/candidates.h"
#include "core/views/visibility.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace chiaro::views {

namespace {

// Below these shares of the part's area another view, or another pass of the same kind, isn't worth it.
constexpr double improvementWorthAView = 1e-5;
constexpr double shareWorthAView = 0.25;
constexpr double shareWorthAPass = 0.05;
constexpr int viewsPerFurtherPass = 6;
constexpr int passesOfAKind = 4;
constexpr int vainTries = 6;  // views from which, against expectation, nothing new was seen
// The last resort can choose its directions freely, so it doesn't stretch.
constexpr double facingOfLastResort = 0.3;
// Faces that no view sees at 60 degrees or less are steep: what is painted from there is stretched by over 2.
constexpr double steepFacing = 0.5;
constexpr double steepShareWorthAPass = 0.002;  // of the object's area
constexpr int steepPasses = 6;

/// What the passes draw, one kind after the other.
Drawn after(Drawn drawn) {
    if (drawn == Drawn::All) return Drawn::Uncovered;
    return drawn == Drawn::Uncovered ? Drawn::UncoveredFronts : Drawn::EachAlone;
}

/// One plan in the making.
class Planner {
public:
    Planner(const Surface& surface, const ViewParams& params, const Task& task)
        : m_surface(surface),
          m_params(params),
          m_task(task),
          m_uncovered(surface.faceCount()),
          m_directions(candidateDirections()) {
        for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
            m_uncovered[face] = surface.area(face) > 0;
            if (m_uncovered[face] == 0) m_plan.unreachable.push_back(face);
        }
    }

    ViewPlan plan(const std::vector<View>& kept) {
        firstPass(kept);
        Drawn drawn = Drawn::Uncovered;
        int ofThisKind = 0;
        // Progress can't know how many passes there will be; each takes half of what is left of the bar.
        double done = 0.6;
        for (double before = uncoveredArea(); before > 0; before = uncoveredArea()) {
            m_task.report(done);
            done += (1 - done) / 2;
            const double facing =
                drawn == Drawn::EachAlone ? std::max(facingOfLastResort, m_params.epsilon) : m_params.epsilon;
            if (!furtherPass(drawn, facing, shareWorthAView) && drawn == Drawn::EachAlone) break;
            const bool worthIt = before - uncoveredArea() >= shareWorthAPass * before;
            if (worthIt && ++ofThisKind < passesOfAKind) continue;
            drawn = after(drawn);
            ofThisKind = 0;
        }
        // Nothing that a mesh may hold leads here; were it so, the faces would be told of all the same.
        for (std::uint32_t face = 0; face < m_surface.faceCount(); ++face)
            if (m_uncovered[face] != 0) m_plan.unreachable.push_back(face);
        std::ranges::sort(m_plan.unreachable);
        m_task.report(1);
        return std::move(m_plan);
    }

    /// Further passes for the faces that a plan shows steeply only.
    ViewPlan improved(ViewPlan plan) {
        m_plan = std::move(plan);
        markSteepFaces();
        const double worthIt = steepShareWorthAPass * m_surface.totalArea();
        for (const Drawn drawn : {Drawn::Uncovered, Drawn::UncoveredFronts})
            for (int pass = 0; pass < steepPasses; ++pass) {
                const double before = uncoveredArea();
                if (before <= worthIt || !furtherPass(drawn, steepFacing, worthIt / before)) break;
                if (before - uncoveredArea() <= worthIt) break;
            }
        return std::move(m_plan);
    }

private:
    void markSteepFaces() {
        for (const FaceGroup& group : m_plan.groups) {
            const Projector projector(group.view);
            for (const std::uint32_t face : group.faces)
                if (projector.facing(m_surface, face) >= steepFacing) m_uncovered[face] = 0;
        }
    }

    double uncoveredArea() const {
        double area = 0;
        for (std::uint32_t face = 0; face < m_surface.faceCount(); ++face)
            if (m_uncovered[face] != 0) area += m_surface.area(face);
        return area;
    }

    View viewFrom(const glm::dvec3& direction) const {
        View view;
        view.name = freeName();
        view.direction = direction;
        view.up = m_params.up;
        view.projection = m_params.projection;
        view.size = m_params.size;
        return framed(view, m_surface);
    }

    /// Kept views may have taken any number.
    std::string freeName() const {
        for (std::size_t number = m_plan.groups.size() + 1;; ++number) {
            std::string name = fmt::format("View {}", number);
            if (std::ranges::none_of(m_plan.groups,
                                     [&](const auto& group) { return group.view.name == name; }))
                return name;
        }
    }

    void firstPass(const std::vector<View>& kept) {
        std::vector<View> views = kept;
        for (View& view : views) {
            view.size = m_params.size;
            view = framed(view, m_surface);
            add(view, Drawn::All);
        }
        if (!(m_surface.totalArea() > 0)) return;
        m_plan.passes = 1;
        const Occluders drawn(m_surface, m_uncovered, Occluders::Sides::Both, 0);
        const Task planning = m_task.part(0, 0.3);
        CandidateScores scores(m_surface, m_uncovered, &drawn, m_params.epsilon, samplesOfAll, m_directions,
                               planning);
        for (const View& view : views) scores.take(glm::normalize(view.direction));
        while (int(m_plan.groups.size()) < m_params.count) {
            const int best = scores.best(improvementWorthAView);
            if (best < 0) break;
            const glm::dvec3& direction = m_directions[std::size_t(best)];
            scores.take(direction);
            scores.drop(best);
            add(viewFrom(direction), Drawn::All);
        }
        const Task looking = m_task.part(0.3, 0.6);
        Task::Steps steps(looking, std::max<std::size_t>(m_plan.groups.size(), 1));
        for (FaceGroup& group : m_plan.groups) {
            group.faces = visibleFaces(drawn, group.view, {m_params.epsilon, nullptr}, looking);
            steps.done();
        }
        for (const FaceGroup& group : m_plan.groups) cover(group.faces);
    }

    void add(const View& view, Drawn drawn) {
        m_plan.groups.push_back({view, std::max(m_plan.passes, 1), drawn, {}});
    }

    void cover(const std::vector<std::uint32_t>& faces) {
        for (const std::uint32_t face : faces) m_uncovered[face] = 0;
    }

    /// Adds views of what is uncovered, from where it is seen with n.v above `facing`, until another one
    /// would show less than `leastShare` of it; false if there are none.
    bool furtherPass(Drawn drawnFaces, double facing, double leastShare) {
        const FaceMask wanted = m_uncovered;
        const bool alone = drawnFaces == Drawn::EachAlone;
        const Occluders drawn(
            m_surface, alone ? FaceMask(wanted.size()) : wanted,
            drawnFaces == Drawn::Uncovered ? Occluders::Sides::Both : Occluders::Sides::Fronts, facing);
        CandidateScores scores(m_surface, wanted, alone ? nullptr : &drawn, facing, samplesOfRest,
                               m_directions, m_task.part(0, 0));
        ++m_plan.passes;
        const std::size_t first = m_plan.groups.size();
        FaceMask covered(wanted.size());
        int vain = 0;
        while (m_plan.groups.size() < first + viewsPerFurtherPass) {
            const int best = scores.best(m_plan.groups.size() > first ? leastShare : 0);
            if (best < 0) break;
            scores.drop(best);
            const View view = viewFrom(m_directions[std::size_t(best)]);
            std::vector<std::uint32_t> faces = visibleFaces(drawn, view, {facing, &wanted}, m_task);
            const auto isNew = [&](std::uint32_t face) { return covered[face] == 0; };
            if (std::ranges::none_of(faces, isNew)) {
                if (++vain == vainTries && !alone) break;
                continue;
            }
            for (const std::uint32_t face : faces) covered[face] = 1;
            scores.settle(covered);
            add(view, drawnFaces);
            m_plan.groups.back().faces = std::move(faces);
        }
        if (m_plan.groups.size() == first) {
            --m_plan.passes;
            return false;
        }
        for (std::size_t i = first; i < m_plan.groups.size(); ++i) cover(m_plan.groups[i].faces);
        return true;
    }

    const Surface& m_surface;
    const ViewParams& m_params;
    const Task& m_task;
    FaceMask m_uncovered;
    std::vector<glm::dvec3> m_directions;
    ViewPlan m_plan;
};

void check(const glm::dvec3& direction, const char* what) {
    const double length = glm::length(direction);
    if (!(length > 0) || !std::isfinite(length))
        throw Error(what, "has no length", "a direction is three numbers, not all of them 0");
}

}  // namespace

const ParameterTable<ViewParams>& ViewParams::table() {
    static const auto table =
        ParameterTable<ViewParams>()
            .add(&ViewParams::count,
                 ParameterSpec::integer("count", "Views", "", 1, 64,
                                        "Viewpoints around the object; hidden parts get further ones."))
            .add(&ViewParams::size, ParameterSpec::integer("size", "Map size", "px", 64, 2048,
                                                           "Side of each view's square map of texture."))
            .add(&ViewParams::projection,
                 ParameterSpec::choice("projection", "Projection", {"orthographic", "perspective"},
                                       "How views flatten the object; orthographic keeps strokes of one size "
                                       "and carries them exactly from view to view."))
            .add(&ViewParams::epsilon,
                 ParameterSpec::real("epsilon", "Flattest angle", "", 0.01, 0.5, 0.01,
                                     "Cosine of the angle beyond which a view does not paint a face; also "
                                     "the least weight of a view."));
    return table;
}

ViewPlan planViews(const Surface& surface, const ViewParams& params, const std::vector<View>& kept,
                   const Task& task) {
    ViewParams::table().check(params);
    check(params.up, "up");
    for (const View& view : kept) {
        check(view.direction, "the direction of a view");
        check(view.up, "the up of a view");
        if (!(view.fieldOfView >= 1 && view.fieldOfView <= 120))
            throw Error("the field of view", fmt::format("is {}", view.fieldOfView), "choose 1..120 degrees");
    }
    return Planner(surface, params, task).plan(kept);
}

ViewPlan withSteepFacesSeen(const Surface& surface, ViewPlan plan, const ViewParams& params,
                            const Task& task) {
    return Planner(surface, params, task).improved(std::move(plan));
}

}  // namespace chiaro::views
