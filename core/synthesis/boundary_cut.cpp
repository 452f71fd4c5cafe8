#include "core/synthesis/boundary_cut.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace chiaro::synthesis {

namespace {

enum class Side { Left, Top, Right, Bottom };

// A block seen from a side: lines run along it, depth counts from it inwards.
class SideView {
public:
    SideView(Side side, int width, int height) : m_side(side), m_width(width), m_height(height) {}

    int lines() const { return horizontal() ? m_height : m_width; }
    int depth() const { return horizontal() ? m_width : m_height; }
    glm::ivec2 cell(int line, int depth) const {
        switch (m_side) {
            case Side::Left:
                return {depth, line};
            case Side::Right:
                return {m_width - 1 - depth, line};
            case Side::Top:
                return {line, depth};
            default:
                return {line, m_height - 1 - depth};
        }
    }

private:
    bool horizontal() const { return m_side == Side::Left || m_side == Side::Right; }

    Side m_side;
    int m_width;
    int m_height;
};

// How deep texture reaches into a line: up to its last texture pixel before the first free one, and one pixel
// further where the picture ends there. None when no pixel is free.
std::optional<int> textureDepth(const Image<Under>& under, const SideView& view, int line) {
    const auto at = [&](int depth) {
        const glm::ivec2 cell = view.cell(line, depth);
        return under(cell.x, cell.y);
    };
    int end = 0;
    for (int depth = 0; depth < view.depth(); ++depth) {
        if (at(depth) == Under::Texture) end = depth + 1;
        if (at(depth) == Under::Nothing) return end > 0 && at(end) == Under::Outside ? end + 1 : end;
    }
    return std::nullopt;
}

// The depths of all lines. A line without a free pixel is as deep as the nearest line that has one, so that
// the path runs on into the corners.
std::vector<int> textureDepths(const Image<Under>& under, const SideView& view) {
    std::vector<std::optional<int>> found;
    for (int line = 0; line < view.lines(); ++line) found.push_back(textureDepth(under, view, line));
    const auto at = [&](int line) {
        return line >= 0 && line < view.lines() ? found[std::size_t(line)] : std::nullopt;
    };
    std::vector<int> depths;
    for (int line = 0; line < view.lines(); ++line) {
        std::optional<int> nearest = at(line);
        for (int away = 1; !nearest && away < view.lines(); ++away)
            nearest = at(line - away) ? at(line - away) : at(line + away);
        depths.push_back(nearest.value_or(0));
    }
    return depths;
}

// The path of least error along a side: the depth in each line at which the block begins. Every line's path
// stays within `reach` of where its texture ends.
class SidePath {
public:
    SidePath(const Image<Under>& under, const ScalarImage& error, const SideView& view, int reach,
             const std::vector<int>& depths)
        : m_under(under), m_error(error), m_view(view), m_reach(reach), m_depths(depths) {}

    std::vector<int> find() {
        m_columns = *std::ranges::max_element(m_depths) + 1;
        m_cost.assign(std::size_t(m_view.lines()) * std::size_t(m_columns), 0);
        m_from.assign(m_cost.size(), 0);
        for (int line = 0; line < m_view.lines(); ++line)
            for (int depth = first(line); depth <= last(line); ++depth) extend(line, depth);
        return trace();
    }

private:
    int last(int line) const { return std::max(m_depths[std::size_t(line)] - 1, 0); }
    int first(int line) const { return std::max(m_depths[std::size_t(line)] - m_reach, 0); }
    std::size_t index(int line, int depth) const {
        return std::size_t(line) * std::size_t(m_columns) + std::size_t(depth);
    }

    float errorAt(int line, int depth) const {
        const glm::ivec2 cell = m_view.cell(line, depth);
        return m_under(cell.x, cell.y) == Under::Texture ? m_error(cell.x, cell.y) : 0.0f;
    }

    void extend(int line, int depth) {
        float before = 0;
        if (line > 0) {
            // Where the texture's edge jumps, the path may jump as far.
            const int jump = std::abs(m_depths[std::size_t(line)] - m_depths[std::size_t(line - 1)]);
            const int step = std::max(jump, 1);
            const int low = std::clamp(depth - step, first(line - 1), last(line - 1));
            const int high = std::clamp(depth + step, first(line - 1), last(line - 1));
            int best = low;
            for (int other = low + 1; other <= high; ++other)
                if (m_cost[index(line - 1, other)] < m_cost[index(line - 1, best)]) best = other;
            before = m_cost[index(line - 1, best)];
            m_from[index(line, depth)] = best;
        }
        m_cost[index(line, depth)] = before + errorAt(line, depth);
    }

    std::vector<int> trace() const {
        const int end = m_view.lines() - 1;
        int depth = first(end);
        for (int other = depth + 1; other <= last(end); ++other)
            if (m_cost[index(end, other)] < m_cost[index(end, depth)]) depth = other;
        std::vector<int> path(std::size_t(m_view.lines()), 0);
        for (int line = end; line >= 0; --line) {
            path[std::size_t(line)] = depth;
            depth = m_from[index(line, depth)];
        }
        return path;
    }

    const Image<Under>& m_under;
    const ScalarImage& m_error;
    const SideView& m_view;
    int m_reach;
    const std::vector<int>& m_depths;
    int m_columns = 0;
    std::vector<float> m_cost;
    std::vector<int> m_from;
};

}  // namespace

Image<std::uint8_t> boundaryCut(const Image<Under>& under, const ScalarImage& error, int reach) {
    Image<std::uint8_t> stays(under.width(), under.height(), 0);
    Image<std::uint8_t> reached(under.width(), under.height(), 0);
    for (const Side side : {Side::Left, Side::Top, Side::Right, Side::Bottom}) {
        const SideView view(side, under.width(), under.height());
        const std::vector<int> depths = textureDepths(under, view);
        if (std::ranges::max(depths) == 0) continue;
        const std::vector<int> path = SidePath(under, error, view, reach, depths).find();
        for (int line = 0; line < view.lines(); ++line)
            for (int depth = 0; depth < depths[std::size_t(line)]; ++depth) {
                const glm::ivec2 cell = view.cell(line, depth);
                reached(cell.x, cell.y) = 1;
                if (depth < path[std::size_t(line)]) stays(cell.x, cell.y) = 1;
            }
    }
    for (int y = 0; y < under.height(); ++y)
        for (int x = 0; x < under.width(); ++x) {
            const bool texture = under(x, y) == Under::Texture;
            stays(x, y) = texture && (stays(x, y) || !reached(x, y));
        }
    return stays;
}

}  // namespace chiaro::synthesis
