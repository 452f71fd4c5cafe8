#include "core/gradient/gradient.h"

#include "core/base/error.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace chiaro::gradient {

const ParameterTable<GradientParams>& GradientParams::table() {
    static const auto table =
        ParameterTable<GradientParams>()
            .add(&GradientParams::searchScale,
                 ParameterSpec::real(
                     "search-scale", "Search scale", "", 1, 4, 0.05,
                     "Enlarge it a little, to 1.2 say, when a strongly curved colour path loses colours."))
            .add(&GradientParams::matchSpeed,
                 ParameterSpec::boolean("match-speed", "Match speed",
                                        "Fits the speed of the colour change to the strip; off, the drawn "
                                        "curve is used."));
    return table;
}

ExactColors columnAverages(const ColorImage& strip) {
    // Both 8-bit and 16-bit levels are whole multiples of this step.
    constexpr double steps = 65535.0 * 64;
    std::vector<glm::i64vec3> sums(std::size_t(strip.width()), glm::i64vec3(0));
    for (int y = 0; y < strip.height(); ++y) {
        const auto row = strip.row(y);
        for (std::size_t x = 0; x < sums.size(); ++x)
            sums[x] += glm::i64vec3(glm::floor(glm::dvec3(row[x]) * steps + 0.5));
    }
    ExactColors averages(sums.size());
    std::transform(sums.begin(), sums.end(), averages.begin(),
                   [&](const glm::i64vec3& sum) { return glm::dvec3(sum) / (steps * strip.height()); });
    return averages;
}

Gradient rounded(const ExactColors& colors) {
    return Gradient(colors.begin(), colors.end());
}

glm::vec3 lookUp(const Gradient& gradient, double u) {
    if (!(u > 0)) return gradient.front();
    if (u >= 1) return gradient.back();
    const double place = u * double(gradient.size() - 1);
    const std::size_t index = std::min(std::size_t(place), gradient.size() - 2);
    const glm::dvec3 left(gradient[index]), right(gradient[index + 1]);
    return glm::vec3(glm::mix(left, right, place - double(index)));
}

Gradient resample(const Gradient& colors, int count) {
    Gradient result(std::size_t(std::max(count, 0)));
    if (count == 1) result.front() = colors.front();
    if (count < 2) return result;
    // Whole numbers tell where each colour falls, so that as many colours come back as they were.
    const std::size_t last = colors.size() - 1;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::size_t index = i * last / (result.size() - 1);
        const std::size_t rest = i * last % (result.size() - 1);
        if (rest == 0) {
            result[i] = colors[index];
            continue;
        }
        const double fraction = double(rest) / double(result.size() - 1);
        result[i] = glm::vec3(glm::mix(glm::dvec3(colors[index]), glm::dvec3(colors[index + 1]), fraction));
    }
    return result;
}

Gradient atSpeed(const Gradient& sorted, const SpeedCurve& curve) {
    if (curve == SpeedCurve{}) return sorted;
    const std::vector<double> pace = curve.sampled(int(sorted.size()));
    Gradient gradient(sorted.size());
    std::transform(pace.begin(), pace.end(), gradient.begin(), [&](double u) { return lookUp(sorted, u); });
    return gradient;
}

namespace {

double rmsDifference(const Gradient& a, const Gradient& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::dvec3 difference = glm::dvec3(a[i]) - glm::dvec3(b[i]);
        sum += glm::dot(difference, difference);
    }
    return std::sqrt(sum / (3.0 * double(a.size())));
}

ColorImage difference(const ColorImage& strip, const Gradient& gradient) {
    ColorImage texture(strip.width(), strip.height());
    for (int y = 0; y < strip.height(); ++y)
        std::transform(strip.row(y).begin(), strip.row(y).end(), gradient.begin(), texture.row(y).begin(),
                       std::minus<>());
    return texture;
}

}  // namespace

Separation separate(const ColorImage& strip, const GradientParams& params, const Task& task) {
    GradientParams::table().check(params);
    Separation result;
    const ExactColors averages = columnAverages(strip);
    result.averages = rounded(averages);
    task.report(0.2);
    task.checkpoint();
    result.order = sortColumns(averages, params.searchScale);
    Gradient kept;
    for (const int column : result.order) kept.push_back(result.averages[std::size_t(column)]);
    result.sorted = resample(kept, strip.width());
    task.report(0.4);
    task.checkpoint();
    result.curve = params.matchSpeed ? matchSpeed(result.sorted, result.averages) : params.curve;
    result.gradient = atSpeed(result.sorted, result.curve);
    result.residue = rmsDifference(result.averages, result.gradient);
    task.report(0.8);
    task.checkpoint();
    result.texture = difference(strip, result.gradient);
    task.report(1);
    return result;
}

ColorImage recolored(const ColorImage& texture, const Gradient& gradient) {
    if (gradient.size() != std::size_t(texture.width()))
        throw Error("gradient", fmt::format("has {} colours", gradient.size()),
                    fmt::format("this texture needs {}, one a column", texture.width()));
    ColorImage result(texture.width(), texture.height());
    for (int y = 0; y < texture.height(); ++y)
        std::transform(texture.row(y).begin(), texture.row(y).end(), gradient.begin(), result.row(y).begin(),
                       [](const glm::vec3& d, const glm::vec3& g) { return glm::clamp(d + g, 0.0f, 1.0f); });
    return result;
}

}  // namespace chiaro::gradient
