#include "core/export/atlas.h"

#include "core/base/error.h"
#include "core/export/chart_packing.h"
#include "core/export/charts.h"
#include "core/export/texel_scan.h"

#include <spdlog/fmt/fmt.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace chiaro::exporting {

namespace {

void check(const AtlasParams& params) {
    if (params.size < 64 || params.size > 8192)
        throw Error("atlas", fmt::format("is {} texels wide", params.size), "choose 64..8192");
    if (params.padding < 0 || params.padding > 64)
        throw Error("padding", fmt::format("is {} texels", params.padding), "choose 0..64");
}

/// Faces without area lie in a point of a face that they touch, or of any.
void placeFacesWithoutArea(const PlacedSurface& surface, std::uint32_t& nextChart, AtlasFaces& faces) {
    const scene::Mesh& mesh = surface.planned().surface.mesh();
    const std::vector<std::uint32_t> welded = scene::weldedIndices(mesh);
    std::vector<glm::vec2> places(mesh.positions.size(), glm::vec2(-1));
    glm::vec2 any(0.5f);
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
        if (!(surface.area(face) > 0)) continue;
        any = faces.corners[face][0];
        for (std::size_t k = 0; k < 3; ++k) places[welded[mesh.triangles[face][k]]] = faces.corners[face][k];
    }
    for (std::uint32_t face = 0; face < surface.faceCount(); ++face) {
        if (surface.area(face) > 0) continue;
        glm::vec2 place = any;
        for (const std::uint32_t vertex : mesh.triangles[face])
            if (places[welded[vertex]].x >= 0) place = places[welded[vertex]];
        faces.corners[face].fill(place);
        faces.chart[face] = nextChart++;
    }
}

double flatArea(const std::array<glm::vec2, 3>& face) {
    const glm::dvec2 a(face[1] - face[0]), b(face[2] - face[0]);
    return std::abs(a.x * b.y - a.y * b.x) / 2;
}

/// The density that this share of the area stays below; `densities` are pairs of density and area, sorted.
double quantile(const std::vector<std::pair<double, double>>& densities, double total, double share) {
    double sum = 0;
    for (const auto& [density, area] : densities)
        if ((sum += area) >= share * total) return density;
    return densities.empty() ? 0 : densities.back().first;
}

void measureDensity(const std::vector<PlacedSurface>& surfaces, const Atlas& atlas, AtlasReport& report) {
    std::vector<std::pair<double, double>> densities;
    double total = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        for (std::uint32_t face = 0; face < surfaces[i].faceCount(); ++face) {
            const double area = surfaces[i].area(face);
            if (!(area > 0)) continue;
            densities.emplace_back(std::sqrt(flatArea(atlas.objects[i].corners[face]) / area), area);
            total += area;
        }
    std::ranges::sort(densities);
    report.densityP5 = quantile(densities, total, 0.05);
    report.densityP95 = quantile(densities, total, 0.95);
}

/// Counts the faces over each texel's centre. A centre on the border of a face counts for none: two faces
/// that touch there don't overlap.
void measureCoverage(const Atlas& atlas, AtlasReport& report) {
    constexpr double border = 1e-3;  // texels; far above the rounding of positions to single precision
    Image<std::uint8_t> inside(atlas.size, atlas.size, 0);
    for (const AtlasFaces& object : atlas.objects)
        for (const std::array<glm::vec2, 3>& corners : object.corners) {
            const auto scan = TexelScan::of(corners);
            if (!scan) continue;
            scan->scan({0, atlas.size}, [&](glm::ivec2 texel, glm::vec2 barycentrics) {
                std::uint8_t& count = inside(texel.x, texel.y);
                if (scan->distanceToBorder(barycentrics) > border)
                    count = std::uint8_t(std::min(count + 2, 254) & ~1);
                count |= 1;
            });
        }
    std::size_t covered = 0, twice = 0;
    for (const std::uint8_t count : inside.pixels()) {
        covered += count > 0;
        twice += count >= 4;
    }
    report.coverage = double(covered) / double(inside.pixelCount());
    report.overlap = covered == 0 ? 0 : double(twice) / double(covered);
}

}  // namespace

Atlas makeAtlas(const std::vector<PlannedPlace>& places, const AtlasParams& params, const Task& task) {
    check(params);
    std::vector<PlacedSurface> surfaces(places.begin(), places.end());
    std::vector<std::vector<Chart>> chartsOf(surfaces.size());
    const Task charting = task.part(0, 0.5);
    Task::Steps steps(charting, std::max<std::size_t>(surfaces.size(), 1));
    tbb::parallel_for(std::size_t(0), surfaces.size(), [&](std::size_t i) {
        chartsOf[i] = makeCharts(surfaces[i], i, charting);
        steps.done();
    });
    std::vector<Chart> charts;
    for (std::vector<Chart>& some : chartsOf)
        charts.insert(charts.end(), std::make_move_iterator(some.begin()),
                      std::make_move_iterator(some.end()));
    const std::optional<ChartPacking> packing =
        packCharts(charts, params.size, params.padding, task.part(0.5, 0.9));
    if (!packing)
        throw Error("atlas",
                    fmt::format("of {} texels a side has no room for the {} charts of this mesh", params.size,
                                charts.size()),
                    "choose a larger one");

    Atlas atlas;
    atlas.size = params.size;
    for (const PlacedSurface& surface : surfaces)
        atlas.objects.push_back({std::vector<std::array<glm::vec2, 3>>(surface.faceCount()),
                                 std::vector<std::uint32_t>(surface.faceCount())});
    for (std::size_t c = 0; c < charts.size(); ++c)
        for (std::size_t i = 0; i < charts[c].faces.size(); ++i) {
            AtlasFaces& object = atlas.objects[charts[c].object];
            object.chart[charts[c].faces[i]] = std::uint32_t(c);
            for (std::size_t k = 0; k < 3; ++k)
                object.corners[charts[c].faces[i]][k] =
                    glm::vec2(packing->origins[c] + charts[c].corners[i][k] * packing->scale);
        }
    auto nextChart = std::uint32_t(charts.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        placeFacesWithoutArea(surfaces[i], nextChart, atlas.objects[i]);

    for (const PlacedSurface& surface : surfaces) atlas.report.faces += surface.faceCount();
    atlas.report.charts = charts.size();
    atlas.report.padding = packing->padding;
    measureDensity(surfaces, atlas, atlas.report);
    measureCoverage(atlas, atlas.report);
    task.report(1);
    return atlas;
}

}  // namespace chiaro::exporting
