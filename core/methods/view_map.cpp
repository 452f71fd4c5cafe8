#include "core/methods/view_map.h"

namespace chiaro::methods {

FaceGroups::FaceGroups(const PlannedObject& object) : m_first(object.surface.faceCount() + 1, 0) {
    const auto& groups = object.plan.groups;
    for (const views::FaceGroup& group : groups)
        for (const std::uint32_t face : group.faces) ++m_first[face + 1];
    for (std::size_t face = 1; face < m_first.size(); ++face) m_first[face] += m_first[face - 1];
    m_memberships.resize(m_first.back());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
        const views::Projector projector(groups[g].view);
        for (const std::uint32_t face : groups[g].faces)
            m_memberships[next[face]++] = {g, std::max(float(projector.facing(object.surface, face)), 1e-3f)};
    }
}

namespace {

/// Lets faces grow into empty texels, one texel in each direction.
Image<std::uint32_t> grown(const Image<std::uint32_t>& faces) {
    Image<std::uint32_t> result = faces;
    for (int y = 0; y < faces.height(); ++y)
        for (int x = 0; x < faces.width(); ++x) {
            if (faces(x, y) != views::noFace) continue;
            for (const glm::ivec2 step :
                 {glm::ivec2(-1, 0), {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
                const glm::ivec2 beside = glm::ivec2(x, y) + step;
                if (!faces.contains(beside.x, beside.y) || faces(beside.x, beside.y) == views::noFace)
                    continue;
                result(x, y) = faces(beside.x, beside.y);
                break;
            }
        }
    return result;
}

/// Which face of a group each texel of its map shows. Where nothing else is, a face too small to cover a
/// texel's centre has the texel it lies in.
Image<std::uint32_t> drawnFaces(const views::Surface& surface, const views::FaceGroup& group) {
    Image<std::uint32_t> drawn = views::drawGroup(surface, group).face;
    const views::Projector projector(group.view);
    const glm::ivec2 last(group.view.size - 1);
    for (const std::uint32_t face : group.faces) {
        const glm::dvec3 middle =
            (surface.corner(face, 0) + surface.corner(face, 1) + surface.corner(face, 2)) / 3.0;
        const glm::dvec2 place(projector.project(middle));
        const glm::ivec2 texel = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), last);
        if (drawn(texel.x, texel.y) == views::noFace) drawn(texel.x, texel.y) = face;
    }
    return drawn;
}

}  // namespace

ViewMap ViewMap::of(const PlannedObject& object, std::size_t group) {
    const Image<std::uint32_t> drawn = drawnFaces(object.surface, object.plan.groups[group]);
    glm::ivec2 low(drawn.width(), drawn.height()), high(-1);
    for (int y = 0; y < drawn.height(); ++y)
        for (int x = 0; x < drawn.width(); ++x) {
            if (drawn(x, y) == views::noFace) continue;
            low = glm::min(low, glm::ivec2(x, y));
            high = glm::max(high, glm::ivec2(x, y));
        }
    ViewMap map;
    if (high.x < 0) return map;
    map.origin = low - margin;
    const glm::ivec2 size = high - low + 1 + 2 * margin;
    map.face = Image<std::uint32_t>(size.x, size.y, views::noFace);
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) map.face(x - map.origin.x, y - map.origin.y) = drawn(x, y);
    for (int i = 0; i < margin; ++i) map.face = grown(map.face);
    map.covered = synthesis::PixelMask(size.x, size.y);
    for (std::size_t i = 0; i < map.face.pixelCount(); ++i)
        map.covered.pixels()[i] = map.face.pixels()[i] != views::noFace;
    return map;
}

bool ViewMap::covers(glm::vec2 position) const {
    const glm::ivec2 base = glm::ivec2(glm::floor(position - 0.5f)) - origin;
    for (const glm::ivec2 step : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        const glm::ivec2 texel = base + step;
        if (!covered.contains(texel.x, texel.y) || !covered(texel.x, texel.y)) return false;
    }
    return true;
}

ViewMapping::ViewMapping(const PlannedObject& object, std::size_t from, std::size_t to) {
    const views::FaceGroup &here = object.plan.groups[from], &there = object.plan.groups[to];
    const views::Projector fromMap(here.view), toMap(there.view);
    for (const std::uint32_t face : views::sharedFaces(here, there))
        if (const auto map = views::triangleMap(object.surface, face, fromMap, toMap))
            m_maps.emplace(face, *map);
}

std::optional<glm::vec2> ViewMapping::map(std::uint32_t face, glm::vec2 position) const {
    const auto known = m_maps.find(face);
    if (known == m_maps.end()) return {};
    return glm::vec2(known->second(glm::dvec2(position)));
}

}  // namespace chiaro::methods
