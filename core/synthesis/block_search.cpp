#include "core/synthesis/block_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace chiaro::synthesis {

namespace {

// A draft looks closely at so many places, the best of at least so many choices.
constexpr std::size_t draftPlaces = 16;
constexpr std::size_t draftChoices = 4 * draftPlaces;

// What an area holds of every second position in each direction.
std::optional<CandidateArea> halfArea(const CandidateArea& area) {
    const int left = (area.x + 1) / 2, top = (area.y + 1) / 2;
    const CandidateArea half{left, top, (area.x + area.width + 1) / 2 - left,
                             (area.y + area.height + 1) / 2 - top};
    return half.width > 0 && half.height > 0 ? std::optional(half) : std::nullopt;
}

CandidateArea common(const CandidateArea& a, const CandidateArea& b) {
    const int left = std::max(a.x, b.x), top = std::max(a.y, b.y);
    return {left, top, std::min(a.x + a.width, b.x + b.width) - left,
            std::min(a.y + a.height, b.y + b.height) - top};
}

glm::ivec2 positionOf(const CandidateArea& area, std::uint64_t place) {
    return {area.x + int(place) % area.width, area.y + int(place) / area.width};
}

BlockMatch anyCandidate(const CandidateArea& area, Random random) {
    const std::size_t choices = std::size_t(area.width) * std::size_t(area.height);
    return {positionOf(area, random.below(choices)), choices};
}

BlockMatch findExactly(CandidateErrors& errors, const SearchQuery& query, Random random) {
    errors.compute(query.candidates, query.excluded);
    const std::vector<std::uint32_t>& places = errors.best(query.tolerance);
    return {positionOf(query.candidates, places[random.below(places.size())]), places.size()};
}

// Searches at half the size and looks closely where that is good.
class DraftSearch {
public:
    DraftSearch(const SearchTexture& source, const SearchQuery& query, SearchMemory& memory)
        : m_query(query), m_half(source.half(), memory.halfPacked, memory) {}

    // None where there is too little to search for a draft to save anything. `exact` has the templates.
    std::optional<BlockMatch> find(CandidateErrors& exact, Random random) {
        const auto area = halfArea(m_query.candidates);
        if (!area || std::size_t(area->width) * std::size_t(area->height) < 4 * draftPlaces)
            return std::nullopt;
        for (const glm::ivec2& place : promising(*area, random)) lookAround(place, exact);
        const double smallest = std::ranges::min(m_found, {}, &Found::error).error;
        if (std::isinf(smallest)) return std::nullopt;
        std::erase_if(m_found, [limit = smallest * (1 + m_query.tolerance)](const Found& found) {
            return found.error > limit;
        });
        return BlockMatch{m_found[random.below(m_found.size())].position, m_found.size()};
    }

private:
    struct Found {
        double error;
        glm::ivec2 position;
    };

    // The best places at half the size, best first, at least a look apart.
    std::vector<glm::ivec2> promising(const CandidateArea& area, Random random) {
        for (const SearchTemplate& goal : m_query.templates) m_half.add(halved(goal.pixels), goal.weight);
        std::vector<CandidateArea> excluded;
        for (const CandidateArea& full : m_query.excluded)
            if (const auto half = halfArea(full)) excluded.push_back(*half);
        m_half.compute(area, excluded);
        std::vector<Found> places;
        for (const std::uint32_t place : bestOfHalf(random)) {
            const glm::ivec2 position = positionOf(area, place);
            places.push_back({m_half.at(position.x - area.x, position.y - area.y), 2 * position});
        }
        std::ranges::stable_sort(places, {}, &Found::error);
        std::vector<glm::ivec2> chosen;
        for (const Found& place : places) {
            const bool seen = std::ranges::any_of(chosen, [&](const glm::ivec2& other) {
                const glm::ivec2 apart = glm::abs(place.position - other);
                return apart.x <= 2 && apart.y <= 2;
            });
            if (seen) continue;
            chosen.push_back(place.position);
            if (chosen.size() == draftPlaces) break;
        }
        return chosen;
    }

    // At least draftChoices places when there are so many.
    std::vector<std::uint32_t>& bestOfHalf(Random random) {
        if (auto& places = m_half.best(0.125); places.size() >= draftChoices) {
            thinOut(places, random);
            return places;
        }
        for (double tolerance = 0.25; tolerance < 4; tolerance *= 2)
            if (auto& places = m_half.best(tolerance); places.size() >= draftChoices) return places;
        return m_half.best(4);
    }

    // Where very many are about as good, as in a flat texture, a few from everywhere stand for all.
    static void thinOut(std::vector<std::uint32_t>& places, Random random) {
        const std::size_t step = std::max<std::size_t>(places.size() / (4 * draftChoices), 1);
        const std::size_t first = random.below(step);
        std::size_t kept = 0;
        for (std::size_t i = first; i < places.size(); i += step) places[kept++] = places[i];
        places.resize(kept);
    }

    void lookAround(const glm::ivec2& place, CandidateErrors& exact) {
        const CandidateArea look = common({place.x - 3, place.y - 2, 8, 6}, m_query.candidates);
        std::vector<CandidateArea> excluded;
        for (const CandidateArea& area : m_query.excluded) {
            const CandidateArea part = common(area, look);
            if (part.width > 0 && part.height > 0) excluded.push_back(part);
        }
        exact.compute(look, excluded);
        for (int y = 0; y < look.height; ++y)
            for (int x = 0; x < look.width; ++x)
                m_found.push_back({exact.at(x, y), {look.x + x, look.y + y}});
    }

    const SearchQuery& m_query;
    CandidateErrors m_half;
    std::vector<Found> m_found;
};

}  // namespace

std::vector<CandidateArea> excludedAround(std::span<const glm::ivec2> used, const CandidateArea& candidates,
                                          int block) {
    std::vector<CandidateArea> excluded;
    if (used.empty()) return excluded;
    const glm::ivec2 first(candidates.x, candidates.y),
        end = first + glm::ivec2(candidates.width, candidates.height);
    const double budget = 0.5 * candidates.width * candidates.height;
    const int side = int(std::sqrt(budget / double(used.size())));
    const int reach = std::clamp((side - 1) / 2, 0, block / 4);
    double spent = 0;
    for (const glm::ivec2& place : used) {
        const glm::ivec2 corner = glm::max(place - reach, first);
        const glm::ivec2 size = glm::min(place + reach + 1, end) - corner;
        if (size.x <= 0 || size.y <= 0) continue;
        spent += double(size.x) * size.y;
        if (spent > budget) break;
        excluded.push_back({corner.x, corner.y, size.x, size.y});
    }
    return excluded;
}

BlockMatch findBlock(const SearchTexture& source, const SearchQuery& query, Random random,
                     SearchMemory& memory) {
    CandidateErrors errors(source, memory.packed, memory);
    for (const SearchTemplate& goal : query.templates) errors.add(goal.pixels, goal.weight);
    if (errors.empty()) return anyCandidate(query.candidates, random);
    if (query.draft)
        if (const auto match = DraftSearch(source, query, memory).find(errors, random)) return *match;
    return findExactly(errors, query, random);
}

}  // namespace chiaro::synthesis
