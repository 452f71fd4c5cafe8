#include "core/synthesis/block_search.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace chiaro::synthesis {

namespace {

constexpr int largestStep = 63;
// Makes the bytes positive: the multiply-add instructions take one signed and one unsigned factor.
constexpr int byteOffset = 64;

std::ptrdiff_t roundedUp(std::ptrdiff_t value, std::ptrdiff_t step) {
    return (value + step - 1) / step * step;
}

// Rows that are an odd number of cache lines apart spread over the whole first-level cache.
std::ptrdiff_t oddLines(std::ptrdiff_t entries) {
    constexpr std::ptrdiff_t line = 64 / sizeof(std::uint32_t);
    return (roundedUp(entries, line) / line | 1) * line;
}

std::array<int, 3> channels(const SearchPixel& pixel) {
    return {pixel.r, pixel.g, pixel.b};
}

std::uint32_t squared(const SearchPixel& pixel) {
    return std::uint32_t(pixel.r * pixel.r + pixel.g * pixel.g + pixel.b * pixel.b);
}

}  // namespace

SearchTexture::SearchTexture(const ColorImage& texture) : m_pixels(texture.width(), texture.height()) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const glm::vec3& color : texture.pixels()) {
        low = glm::min(low, color);
        high = glm::max(high, color);
    }
    m_middle = (low + high) * 0.5f;
    const glm::vec3 reach = (high - low) * 0.5f;
    const double widest = std::max({reach.r, reach.g, reach.b});
    m_step = widest > 0 ? widest / largestStep : 1;

    std::ranges::transform(texture.pixels(), m_pixels.pixels().begin(),
                           [this](const glm::vec3& color) { return rounded(color); });
    packQuads();
    integrateSquares();
}

SearchPixel SearchTexture::rounded(const glm::vec3& color) const {
    const auto channel = [this](float value, float middle) {
        const double steps = std::round((double(value) - double(middle)) / m_step);
        return std::int8_t(std::clamp(steps, double(-largestStep), double(largestStep)));
    };
    return {channel(color.r, m_middle.r), channel(color.g, m_middle.g), channel(color.b, m_middle.b), false};
}

void SearchTexture::packQuads() {
    const int padded = width() + kernels::columnPadding;
    m_quadPitch = oddLines(padded);
    m_quads.assign(std::size_t(m_quadPitch * 3 * (height() + kernels::rowPadding)), 0);
    std::vector<std::uint8_t> bytes(std::size_t(3 * padded + 6), byteOffset);
    for (int y = 0; y < height(); ++y) {
        for (int x = 0; x < width(); ++x)
            for (std::size_t c = 0; c < 3; ++c)
                bytes[std::size_t(3 * x) + c] = std::uint8_t(channels(m_pixels(x, y))[c] + byteOffset);
        for (int phase = 0; phase < 3; ++phase) {
            std::uint32_t* row = m_quads.data() + (3 * y + phase) * m_quadPitch;
            for (int x = 0; x < padded; ++x)
                for (std::size_t i = 0; i < 4; ++i)
                    row[x] |= std::uint32_t(bytes[std::size_t(3 * x + phase) + i]) << (8 * i);
        }
    }
}

void SearchTexture::integrateSquares() {
    m_squaresPitch = oddLines(width() + 1 + kernels::columnPadding);
    m_squares.assign(std::size_t(m_squaresPitch * (height() + 1 + kernels::rowPadding)), 0);
    for (int y = 0; y < height(); ++y) {
        const std::uint32_t* above = m_squares.data() + y * m_squaresPitch;
        std::uint32_t* row = m_squares.data() + (y + 1) * m_squaresPitch;
        std::uint32_t sum = 0;
        for (int x = 0; x < width(); ++x) {
            sum += squared(m_pixels(x, y));
            row[x + 1] = above[x + 1] + sum;
        }
    }
}

kernels::PackedSource SearchTexture::packed() const {
    return {m_quads.data(), m_quadPitch, m_squares.data(), m_squaresPitch};
}

namespace {

// The template as the kernels take it.
class TemplatePacker {
public:
    TemplatePacker(const Image<SearchPixel>& pixels, const kernels::PackedSource& source,
                   SearchMemory& memory)
        : m_pixels(pixels), m_source(source), m_memory(memory) {}

    // What every candidate's cost has in common; false when no pixel counts.
    bool pack(std::uint32_t& constant) {
        for (auto& pieces : m_memory.pieces) pieces.clear();
        m_memory.rectangles.clear();
        if (!sumUp(constant)) return false;
        for (int column = 0; 4 * column < 3 * m_pixels.width(); ++column) packColumn(column);
        packRectangles();
        return true;
    }

private:
    bool sumUp(std::uint32_t& constant) const {
        bool any = false;
        std::int64_t sum = 0;
        for (const SearchPixel& pixel : m_pixels.pixels()) {
            if (!pixel.counts) continue;
            any = true;
            sum += squared(pixel) + 2 * byteOffset * (pixel.r + pixel.g + pixel.b);
        }
        constant = std::uint32_t(sum);
        return any;
    }

    // A byte of a template row; none where the pixel doesn't count or lies outside.
    std::optional<int> byteAt(int byte, int y) const {
        const int x = byte / 3;
        if (x >= m_pixels.width() || !m_pixels(x, y).counts) return std::nullopt;
        return channels(m_pixels(x, y))[std::size_t(byte % 3)];
    }

    std::optional<std::uint32_t> quadAt(int column, int y) const {
        bool any = false;
        std::uint32_t quad = 0;
        for (int i = 0; i < 4; ++i)
            if (const auto value = byteAt(4 * column + i, y)) {
                any = true;
                quad |= std::uint32_t(std::uint8_t(*value)) << (8 * i);
            }
        return any ? std::optional(quad) : std::nullopt;
    }

    void packColumn(int column) {
        kernels::TemplatePiece piece;
        std::size_t length = 0;
        const auto finish = [&] {
            if (length > 0) m_memory.pieces[length - 1].push_back(piece);
            length = 0;
        };
        for (int y = 0; y < m_pixels.height(); ++y) {
            const auto quad = quadAt(column, y);
            if (!quad) {
                finish();
                continue;
            }
            if (length == 0) piece.offset = (3 * y + 4 * column % 3) * m_source.quadPitch + 4 * column / 3;
            piece.quads[length++] = *quad;
            if (length == kernels::longestPiece) finish();
        }
        finish();
    }

    // Runs of pixels that count; equal runs in consecutive rows make one rectangle.
    void packRectangles() {
        struct Run {
            int begin, end, top;
        };
        std::vector<Run> open, now;
        for (int y = 0; y <= m_pixels.height(); ++y) {
            now.clear();
            for (int x = 0; y < m_pixels.height() && x < m_pixels.width(); ++x) {
                if (!m_pixels(x, y).counts) continue;
                const int begin = x;
                while (x < m_pixels.width() && m_pixels(x, y).counts) ++x;
                now.push_back({begin, x, y});
            }
            for (const Run& run : open) {
                const auto same = std::ranges::find_if(
                    now, [&](const Run& other) { return other.begin == run.begin && other.end == run.end; });
                if (same != now.end())
                    same->top = run.top;
                else
                    addRectangle(run.begin, run.end, run.top, y);
            }
            open.swap(now);
        }
    }

    void addRectangle(int left, int right, int top, int bottom) {
        const auto at = [&](int x, int y) { return y * m_source.squaresPitch + x; };
        m_memory.rectangles.push_back({at(left, top), at(right, top), at(left, bottom), at(right, bottom)});
    }

    const Image<SearchPixel>& m_pixels;
    const kernels::PackedSource& m_source;
    SearchMemory& m_memory;
};

// The costs of one template at all candidates, in `memory.costs`; false when no pixel counts.
bool computeCosts(const SearchTexture& source, const SearchTemplate& goal, const CandidateArea& area,
                  std::ptrdiff_t pitch, SearchMemory& memory) {
    kernels::CostRequest request;
    request.source = source.packed();
    if (!TemplatePacker(goal.pixels, request.source, memory).pack(request.constant)) return false;
    memory.costs.resize(std::size_t(pitch * (area.height + kernels::rowPadding)));
    request.x = area.x;
    request.y = area.y;
    request.columns = area.width;
    request.rows = area.height;
    std::ranges::copy(memory.pieces, request.pieces.begin());
    request.rectangles = memory.rectangles;
    request.costs = memory.costs.data();
    request.pitch = pitch;
    kernels::computeCosts(request);
    return true;
}

// Makes the excluded candidates too bad to choose.
template <class Cost>
void exclude(const SearchQuery& query, std::ptrdiff_t pitch, std::vector<Cost>& costs, Cost worst) {
    for (const CandidateArea& area : query.excluded)
        for (int y = area.y - query.candidates.y; y < area.y - query.candidates.y + area.height; ++y) {
            const auto row = costs.begin() + y * pitch + area.x - query.candidates.x;
            std::fill(row, row + area.width, worst);
        }
}

// Places whose error is small enough when there is one template: its costs are the errors.
void collectBest(const CandidateArea& area, std::ptrdiff_t pitch, double tolerance, SearchMemory& memory) {
    const std::uint32_t best = kernels::smallestCost(memory.costs.data(), pitch, area.width, area.height);
    const double limit = std::min(double(best) * (1 + tolerance), double(~std::uint32_t{0}));
    kernels::collectCosts(memory.costs.data(), pitch, area.width, area.height, std::uint32_t(limit),
                          memory.places);
}

// The same for a weighted sum. Weights are multiples of 1/1024 and costs whole, so the sums are exact.
void collectBestTotals(const CandidateArea& area, double tolerance, SearchMemory& memory) {
    const double limit = *std::ranges::min_element(memory.totals) * (1 + tolerance);
    for (int place = 0; place < area.width * area.height; ++place)
        if (memory.totals[std::size_t(place)] <= limit) memory.places.push_back(std::uint32_t(place));
}

void addTotals(const CandidateArea& area, std::ptrdiff_t pitch, double weight, SearchMemory& memory) {
    const double exact = std::round(weight * 1024) / 1024;
    for (int y = 0; y < area.height; ++y)
        for (int x = 0; x < area.width; ++x)
            memory.totals[std::size_t(y) * std::size_t(area.width) + std::size_t(x)] +=
                exact * memory.costs[std::size_t(y * pitch + x)];
}

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
    const CandidateArea& area = query.candidates;
    const std::ptrdiff_t pitch = roundedUp(area.width, kernels::columnPadding);
    memory.places.clear();
    bool any = false;
    if (query.templates.size() == 1) {
        any = computeCosts(source, query.templates[0], area, pitch, memory);
        if (any) exclude(query, pitch, memory.costs, ~std::uint32_t{0});
        if (any) collectBest(area, pitch, query.tolerance, memory);
    } else {
        memory.totals.assign(std::size_t(area.width) * std::size_t(area.height), 0);
        for (const SearchTemplate& goal : query.templates)
            if (goal.weight > 0 && computeCosts(source, goal, area, pitch, memory)) {
                addTotals(area, pitch, goal.weight, memory);
                any = true;
            }
        if (any) exclude(query, area.width, memory.totals, std::numeric_limits<double>::max());
        if (any) collectBestTotals(area, query.tolerance, memory);
    }
    const std::size_t choices =
        any ? memory.places.size() : std::size_t(area.width) * std::size_t(area.height);
    const std::uint64_t pick = random.below(choices);
    const int place = int(any ? memory.places[pick] : pick);
    return {{area.x + place % area.width, area.y + place / area.width}, choices};
}

}  // namespace chiaro::synthesis
