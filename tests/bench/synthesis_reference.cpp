#include "tests/bench/synthesis_reference.h"

#include "core/synthesis/block_grid.h"
#include "core/synthesis/boundary_cut.h"
#include "core/synthesis/tiling.h"

#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

namespace chiaro::bench {

using namespace synthesis;

namespace {

// One stroke: a soft bar that adds to what is there.
void paintStroke(ColorImage& texture, Random& random) {
    const glm::vec2 centre(random.uniform() * texture.width(), random.uniform() * texture.height());
    const float angle = 0.6f + 0.5f * float(random.uniform()), length = 8 + 16 * float(random.uniform());
    const glm::vec2 along(std::cos(angle), std::sin(angle));
    const float strength = 0.25f * (float(random.uniform()) - 0.5f);
    const glm::vec3 tint = strength * glm::vec3(1, 0.8f + 0.4f * float(random.uniform()), 0.9f);
    for (int y = int(centre.y - length); y < int(centre.y + length); ++y)
        for (int x = int(centre.x - length); x < int(centre.x + length); ++x) {
            if (!texture.contains(x, y)) continue;
            const glm::vec2 from = glm::vec2(x, y) - centre;
            const float u = glm::dot(from, along) / length, v = (from.x * along.y - from.y * along.x) / 2.5f;
            if (u * u < 1) texture(x, y) += tint * (1 - u * u) * std::exp(-v * v);
        }
}

cv::Mat matOf(const ColorImage& image) {
    cv::Mat mat(image.height(), image.width(), CV_32FC3);
    std::memcpy(mat.data, image.pixels().data(), image.pixelCount() * sizeof(glm::vec3));
    return mat;
}

// Quilting with nothing but the search different; blocks in the order that the engine's result depends on.
class MatchTemplateQuilter {
public:
    MatchTemplateQuilter(const QuiltTask& task, const QuiltParams& params)
        : m_task(task),
          m_params(fittedBlock(params, task)),
          m_grid(task.width, task.height, m_params.block, m_params.overlapPixels(), task.wrap),
          m_source(matOf(*task.source)),
          m_made(task.width, task.height, 0),
          m_sources(std::size_t(m_grid.count())) {
        m_result.texture = ColorImage(task.width, task.height);
        m_result.origin = Image<glm::i16vec2>(task.width, task.height, glm::i16vec2(-1));
        if (!task.filled) return;
        for (int y = 0; y < task.height; ++y)
            for (int x = 0; x < task.width; ++x) {
                m_made(x, y) = (*task.filledWhere)(x, y);
                m_result.texture(x, y) = (*task.filled)(x, y);
            }
    }

    QuiltResult run() {
        const auto successors = m_grid.successors();
        std::vector<int> waiting(successors.size(), 0);
        for (const auto& later : successors)
            for (const int other : later) ++waiting[std::size_t(other)];
        std::vector<int> ready;
        for (int i = 0; i < m_grid.count(); ++i)
            if (waiting[std::size_t(i)] == 0) ready.push_back(i);
        for (std::size_t next = 0; next < ready.size(); ++next) {
            place(m_grid.site(ready[next]));
            for (const int other : successors[std::size_t(ready[next])])
                if (--waiting[std::size_t(other)] == 0) ready.push_back(other);
        }
        return std::move(m_result);
    }

private:
    void place(const BlockSite& site) {
        if (!look(site)) return;
        PlacedBlock placed{site, choose(site), 0, 0};
        m_sources[std::size_t(site.index)] = placed.source;
        ScalarImage error(site.size.x, site.size.y, 0.0f);
        for (int y = 0; y < site.size.y; ++y)
            for (int x = 0; x < site.size.x; ++x) {
                if (m_under(x, y) != Under::Texture) continue;
                const glm::vec3 difference = sourceAt(placed, x, y) - at(site, x, y);
                error(x, y) = glm::dot(difference, difference);
                placed.overlapError += double(error(x, y));
                ++placed.overlapPixels;
            }
        m_result.blocks.push_back(placed);
        const auto stays = boundaryCut(m_under, error, m_grid.widestOverlap());
        for (int y = 0; y < site.size.y; ++y)
            for (int x = 0; x < site.size.x; ++x) {
                if (stays(x, y) || !validAt(site, x, y)) continue;
                at(site, x, y) = sourceAt(placed, x, y);
                madeAt(site, x, y) = 1;
            }
    }

    const glm::vec3& sourceAt(const PlacedBlock& placed, int x, int y) const {
        return (*m_task.source)(placed.source.x + x, placed.source.y + y);
    }
    glm::ivec2 wrapped(const BlockSite& site, int x, int y) const {
        return {(site.position.x + x) % m_task.width, (site.position.y + y) % m_task.height};
    }
    glm::vec3& at(const BlockSite& site, int x, int y) {
        const glm::ivec2 pixel = wrapped(site, x, y);
        return m_result.texture(pixel.x, pixel.y);
    }
    std::uint8_t& madeAt(const BlockSite& site, int x, int y) {
        const glm::ivec2 pixel = wrapped(site, x, y);
        return m_made(pixel.x, pixel.y);
    }
    bool validAt(const BlockSite& site, int x, int y) const {
        const glm::ivec2 pixel = wrapped(site, x, y);
        return !m_task.valid || (*m_task.valid)(pixel.x, pixel.y) != 0;
    }

    bool look(const BlockSite& site) {
        bool missing = false;
        m_under = Image<Under>(site.size.x, site.size.y);
        m_goal = cv::Mat(site.size.y, site.size.x, CV_32FC3);
        for (int y = 0; y < site.size.y; ++y)
            for (int x = 0; x < site.size.x; ++x) {
                const bool made = madeAt(site, x, y) != 0;
                missing |= !made && validAt(site, x, y);
                m_under(x, y) = made ? Under::Texture : validAt(site, x, y) ? Under::Nothing : Under::Outside;
                const glm::vec3 color = at(site, x, y);
                m_goal.at<cv::Vec3f>(y, x) = {color.r, color.g, color.b};
            }
        return missing;
    }

    // The overlap as few rectangles: runs of a row, as far down as they stay the same.
    std::vector<cv::Rect> rectangles() const {
        const auto made = [&](int x, int y) { return m_under(x, y) == Under::Texture; };
        std::vector<cv::Rect> found;
        for (int y = 0; y < m_under.height(); ++y)
            for (int x = 0; x < m_under.width(); ++x) {
                const int begin = x;
                while (x < m_under.width() && made(x, y)) ++x;
                if (x == begin) continue;
                const auto above = std::ranges::find_if(found, [&](const cv::Rect& r) {
                    return r.x == begin && r.width == x - begin && r.y + r.height == y;
                });
                if (above != found.end())
                    ++above->height;
                else
                    found.emplace_back(begin, y, x - begin, 1);
            }
        return found;
    }

    glm::ivec2 choose(const BlockSite& site) {
        const CandidateArea all{0, 0, m_task.source->width() - m_params.block + 1,
                                m_task.source->height() - m_params.block + 1};
        const CandidateArea area = m_task.candidates ? m_task.candidates(site) : all;
        cv::Mat total(area.height, area.width, CV_32F, cv::Scalar(0));
        for (const cv::Rect& r : rectangles()) {
            const cv::Rect reach(area.x + r.x, area.y + r.y, area.width + r.width - 1,
                                 area.height + r.height - 1);
            cv::Mat errors;
            cv::matchTemplate(m_source(reach), m_goal(r), errors, cv::TM_SQDIFF);
            total += errors;
        }
        std::vector<glm::ivec2> used;
        for (const int index : m_grid.earlier(site.index, m_task.variety))
            used.push_back(m_sources[std::size_t(index)]);
        for (const CandidateArea& out : excludedAround(used, area, m_params.block))
            total(cv::Rect(out.x - area.x, out.y - area.y, out.width, out.height)) = cv::Scalar(1e9);
        double smallest = 0;
        cv::minMaxLoc(total, &smallest);
        const double limit = std::max(smallest, 0.0) * (1 + m_params.tolerance) + 1e-6;
        std::vector<glm::ivec2> good;
        for (int y = 0; y < area.height; ++y)
            for (int x = 0; x < area.width; ++x)
                if (total.at<float>(y, x) <= limit) good.emplace_back(area.x + x, area.y + y);
        Random random(m_params.seed, std::uint64_t(site.index));
        return good[random.below(good.size())];
    }

    const QuiltTask& m_task;
    QuiltParams m_params;
    BlockGrid m_grid;
    cv::Mat m_source;
    Image<std::uint8_t> m_made;
    Image<Under> m_under;
    std::vector<glm::ivec2> m_sources;
    cv::Mat m_goal;
    QuiltResult m_result;
};

}  // namespace

GeneratedPaint generatePaint(int width, int height) {
    GeneratedPaint paint{ColorImage(width, height, glm::vec3(0)), {}};
    Random random(7);
    for (int i = 0; i < width * height / 40; ++i) paintStroke(paint.strip, random);
    for (int x = 0; x < width; ++x) {
        const float u = float(x) / float(width - 1);
        paint.gradient.push_back({0.2f + 0.6f * u, 0.15f + 0.65f * u * u, 0.3f + 0.4f * u});
        for (int y = 0; y < height; ++y) {
            const float grain = 0.04f * (float(random.uniform()) - 0.5f);
            paint.strip(x, y) = glm::clamp(paint.strip(x, y) + paint.gradient.back() + grain, 0.0f, 1.0f);
        }
    }
    return paint;
}

QuiltResult quiltWithMatchTemplate(const QuiltTask& task, const QuiltParams& params) {
    return MatchTemplateQuilter(task, params).run();
}

QuiltReport levelsWithMatchTemplate(const GeneratedPaint& paint, const LevelParams& params) {
    std::vector<QuiltResult> results(std::size_t(params.count));
    tbb::parallel_for(0, params.count, [&](int i) {
        const int begin = i * paint.strip.width() / params.count;
        const int end = (i + 1) * paint.strip.width() / params.count;
        ColorImage section(end - begin, paint.strip.height());
        for (int y = 0; y < section.height(); ++y)
            for (int x = begin; x < end; ++x)
                section(x - begin, y) = paint.strip(x, y) - paint.gradient[std::size_t(x)];
        QuiltTask task;
        task.source = &section;
        task.width = task.height = params.size;
        task.variety = levelVariety;
        QuiltParams quilt = params.quilt;
        quilt.seed = Random(quilt.seed, std::uint64_t(i)).bits();
        results[std::size_t(i)] = quiltTileable(task, quilt, quiltWithMatchTemplate);
    });
    QuiltResult all;
    for (const QuiltResult& result : results)
        all.blocks.insert(all.blocks.end(), result.blocks.begin(), result.blocks.end());
    return all.report();
}

QuiltTask ballFrame(const ColorImage& texture, int size) {
    QuiltTask task;
    task.source = &texture;
    task.width = task.height = size;
    task.candidates = [&texture, size](const BlockSite& site) {
        const glm::vec2 middle = glm::vec2(site.position) + glm::vec2(site.size) / 2.0f;
        const float light = std::max(1 - glm::length(middle / float(size) - 0.4f), 0.0f);
        const int columns = 256, rows = texture.height() - 31, last = texture.width() - 31 - columns;
        return CandidateArea{std::clamp(int(light * float(texture.width())) - 16 - columns / 2, 0, last), 0,
                             columns, rows};
    };
    return task;
}

}  // namespace chiaro::bench
