#include "core/export/bake.h"

#include "core/export/texel_scan.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace chiaro::exporting {

namespace {

constexpr int bandHeight = 16;
struct FaceName {
    std::uint32_t object;
    std::uint32_t face;
};

glm::u8vec3 quantized(glm::vec3 color) {
    return glm::u8vec3(glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// The faces of every band of rows.
class Bands {
public:
    explicit Bands(const Atlas& atlas) : m_ends(std::size_t((atlas.size + bandHeight - 1) / bandHeight) + 1) {
        eachBand(atlas, [this](std::size_t band, FaceName) { ++m_ends[band + 1]; });
        for (std::size_t i = 1; i < m_ends.size(); ++i) m_ends[i] += m_ends[i - 1];
        m_faces.resize(m_ends.back());
        std::vector<std::size_t> next(m_ends.begin(), m_ends.end() - 1);
        eachBand(atlas, [&](std::size_t band, FaceName face) { m_faces[next[band]++] = face; });
    }
    std::size_t count() const { return m_ends.size() - 1; }
    std::span<const FaceName> of(std::size_t band) const {
        return {m_faces.data() + m_ends[band], m_ends[band + 1] - m_ends[band]};
    }

private:
    template <class Visit>
    void eachBand(const Atlas& atlas, Visit visit) const {
        const int last = int(count()) - 1;
        for (std::uint32_t object = 0; object < atlas.objects.size(); ++object) {
            const auto& corners = atlas.objects[object].corners;
            for (std::uint32_t face = 0; face < corners.size(); ++face) {
                const auto [low, high] =
                    std::minmax({corners[face][0].y, corners[face][1].y, corners[face][2].y});
                for (int band = std::clamp(int(low) / bandHeight, 0, last);
                     band <= std::clamp(int(high) / bandHeight, 0, last); ++band)
                    visit(std::size_t(band), FaceName{object, face});
            }
        }
    }

    std::vector<std::size_t> m_ends;
    std::vector<FaceName> m_faces;
};

class Baker {
public:
    Baker(const Atlas& atlas, const PlaceColor& color, int samples)
        : m_atlas(atlas),
          m_color(color),
          m_samples(samples),
          m_bands(atlas),
          m_picture(atlas.size, atlas.size, glm::u8vec3(0)),
          m_covered(atlas.size, atlas.size, 0) {}

    void paint(const Task& task) {
        Task::Steps steps(task, m_bands.count());
        tbb::parallel_for(std::size_t(0), m_bands.count(), [&](std::size_t band) {
            paintBand(band);
            steps.done();
        });
    }

    ByteImage picture(bool isDilated) {
        if (isDilated) dilate(m_picture, m_covered);
        return std::move(m_picture);
    }

private:
    /// Ranks of the places that a cell may show: its middle, the others of 3 x 3, and, where none of them is
    /// covered, the middle of a face that lies between them.
    static constexpr std::uint8_t middleRank = 0, speckRank = 254, emptyRank = 255;

    /// The place that a cell shows.
    struct Cell {
        FaceName name{0, 0};
        glm::vec2 barycentrics{0};
        std::uint8_t rank = emptyRank;
    };

    void paintBand(std::size_t band) {
        const glm::ivec2 rows(int(band) * bandHeight, std::min(int(band + 1) * bandHeight, m_atlas.size));
        Image<Cell> cells(m_atlas.size * m_samples, (rows.y - rows.x) * m_samples);
        // Most cells have a middle that a face covers, and need no closer look.
        for (const FaceName& name : m_bands.of(band)) coverMiddles(name, rows * m_samples, cells);
        for (const FaceName& name : m_bands.of(band)) coverRest(name, rows * m_samples, cells);
        for (int y = rows.x; y < rows.y; ++y)
            for (int x = 0; x < m_atlas.size; ++x) {
                glm::vec4 sum(0);  // and how many there are
                for (int i = 0; i < m_samples * m_samples; ++i) {
                    const Cell& cell =
                        cells(x * m_samples + i % m_samples, (y - rows.x) * m_samples + i / m_samples);
                    if (cell.rank == emptyRank) continue;
                    sum += glm::vec4(m_color(cell.name.object, cell.name.face, cell.barycentrics), 1);
                }
                if (!(sum.a > 0)) continue;
                m_picture(x, y) = quantized(glm::vec3(sum) / sum.a);
                m_covered(x, y) = 1;
            }
    }

    /// In cells.
    std::array<glm::vec2, 3> cornersOf(const FaceName& name) const {
        std::array<glm::vec2, 3> corners = m_atlas.objects[name.object].corners[name.face];
        for (glm::vec2& corner : corners) corner *= float(m_samples);
        return corners;
    }

    void coverMiddles(const FaceName& name, glm::ivec2 rows, Image<Cell>& cells) const {
        const auto scan = TexelScan::of(cornersOf(name));
        if (!scan) return;
        scan->scan(rows, [&](glm::ivec2 place, glm::vec2 barycentrics) {
            Cell& cell = cells(place.x, place.y - rows.x);
            if (cell.rank != middleRank) cell = {name, barycentrics, middleRank};
        });
    }

    void coverRest(const FaceName& name, glm::ivec2 rows, Image<Cell>& cells) const {
        static constexpr std::array<glm::vec2, 8> steps{
            {{0, -1}, {-1, 0}, {1, 0}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
        const std::array<glm::vec2, 3> corners = cornersOf(name);
        const auto scan = TexelScan::of(corners);
        if (!scan) return;
        for (int y = std::max(scan->low().y, rows.x); y < std::min(scan->high().y, rows.y); ++y)
            for (int x = scan->low().x; x < std::min(scan->high().x, cells.width()); ++x) {
                Cell& cell = cells(x, y - rows.x);
                for (std::uint8_t i = 0; i < steps.size() && i + 1 < cell.rank; ++i) {
                    const glm::vec2 place = glm::vec2(x, y) + 0.5f + steps[i] / 3.0f;
                    const glm::dvec2 barycentrics = scan->barycentricsAt(glm::dvec2(place));
                    if (TexelScan::isInside(barycentrics))
                        cell = {name, glm::vec2(barycentrics), std::uint8_t(i + 1)};
                }
            }
        const glm::ivec2 middle((corners[0] + corners[1] + corners[2]) / 3.0f);
        if (middle.y < rows.x || middle.y >= rows.y || middle.x >= cells.width()) return;
        Cell& cell = cells(middle.x, middle.y - rows.x);
        if (cell.rank == emptyRank) cell = {name, glm::vec2(1.0f / 3), speckRank};
    }

    const Atlas& m_atlas;
    const PlaceColor& m_color;
    int m_samples;
    Bands m_bands;
    ByteImage m_picture;
    Image<std::uint8_t> m_covered;
};

}  // namespace

ByteImage bakeAtlas(const Atlas& atlas, const PlaceColor& color, const BakeParams& params, const Task& task) {
    Baker baker(atlas, color, params.samples);
    baker.paint(task.part(0, 0.95));
    ByteImage picture = baker.picture(params.dilate);
    task.report(1);
    return picture;
}

std::vector<glm::u8vec3> vertexColors(const scene::Mesh& mesh,
                                      const std::function<glm::vec3(std::uint32_t, glm::vec2)>& color,
                                      const Task& task) {
    // Of each corner's third of its face, by the face's area; vertices that are one in space share a colour.
    const std::vector<std::uint32_t> welded = scene::weldedIndices(mesh);
    constexpr std::size_t chunk = 4096;
    std::vector<std::array<glm::vec3, 3>> corners(mesh.triangles.size());
    const std::size_t chunks = (mesh.triangles.size() + chunk - 1) / chunk;
    Task::Steps steps(task, std::max<std::size_t>(chunks, 1));
    tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t c) {
        for (std::size_t face = c * chunk; face < std::min((c + 1) * chunk, corners.size()); ++face)
            for (std::size_t k = 0; k < 3; ++k) {
                glm::vec3 sum(0);
                for (const glm::vec2 shares : {glm::vec2(0, 0), {0.3f, 0}, {0, 0.3f}, {0.25f, 0.25f}}) {
                    glm::vec3 weights(0);
                    weights[int(k)] = 1 - shares.x - shares.y;
                    weights[int(k + 1) % 3] = shares.x;
                    weights[int(k + 2) % 3] = shares.y;
                    sum += color(std::uint32_t(face), {weights.y, weights.z}) / 4.0f;
                }
                corners[face][k] = sum;
            }
        steps.done();
    });
    std::vector<glm::dvec4> sums(mesh.positions.size(), glm::dvec4(0));
    for (std::size_t face = 0; face < corners.size(); ++face) {
        const auto& [a, b, c] = mesh.triangles[face];
        const glm::dvec3 origin(mesh.positions[a]);
        const double area = glm::length(
            glm::cross(glm::dvec3(mesh.positions[b]) - origin, glm::dvec3(mesh.positions[c]) - origin));
        for (std::size_t k = 0; k < 3; ++k)
            sums[welded[mesh.triangles[face][k]]] +=
                std::max(area, 1e-300) * glm::dvec4(glm::dvec3(corners[face][k]), 1);
    }
    std::vector<glm::u8vec3> colors(sums.size(), glm::u8vec3(0));
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const glm::dvec4& sum = sums[welded[i]];
        if (sum.a > 0) colors[i] = quantized(glm::vec3(glm::dvec3(sum) / sum.a));
    }
    return colors;
}

}  // namespace chiaro::exporting
