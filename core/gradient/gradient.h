#pragma once

#include "core/base/image.h"
#include "core/base/parameters.h"
#include "core/base/task.h"
#include "core/gradient/color_path.h"
#include "core/gradient/speed_curve.h"

#include <vector>

namespace chiaro::gradient {

/// W colours along the strip, dark end first; display-referred RGB in [0, 1].
using Gradient = std::vector<glm::vec3>;

/// Column averages as the sort compares them: single precision would decide ties by its rounding.
using ExactColors = std::vector<glm::dvec3>;

/// Mean RGB of each column (§3.1). Summed exactly, in whole steps of 1/64 of a 16-bit level, so that columns
/// of equal colour are equal to the last bit.
ExactColors columnAverages(const ColorImage& strip);

/// The same colours in single precision.
Gradient rounded(const ExactColors& colors);

/// The gradient sort (§3.1): the column indices it keeps, in order; first 0, last W - 1. `searchScale` in [1,
/// 4] enlarges the sphere that is searched around the midpoint. Distances are computed in double; a column on
/// the sphere is outside it; ties go to the smaller column. Takes 0.1 s at worst for 8192 columns.
std::vector<int> sortColumns(const ExactColors& averages, double searchScale);

/// The colours resampled linearly to `count`, end on end.
Gradient resample(const Gradient& colors, int count);

/// The colour at u in [0, 1], linear between the W entries; 0 is the first, 1 the last. NaN gives the first.
glm::vec3 lookUp(const Gradient& gradient, double u);

struct GradientParams {
    double searchScale = 1;  ///< of the gradient sort, 1..4
    bool matchSpeed = true;  ///< fit the speed curve to the column averages; else `curve` is used
    SpeedCurve curve;        ///< u(x), drawn by the artist
    static const ParameterTable<GradientParams>& table();  ///< all but the curve
    friend bool operator==(const GradientParams&, const GradientParams&) = default;
};

/// G(u(x)): as many colours as the gradient has, taken at the curve's pace.
Gradient atSpeed(const Gradient& sorted, const SpeedCurve& curve);

/// A strip taken apart (§3): strip = clip(texture + gradient) to within 1e-6.
struct Separation {
    Gradient averages;       ///< W column averages
    std::vector<int> order;  ///< the columns that the sort kept, K <= W
    Gradient sorted;         ///< the kept colours resampled to W: G
    SpeedCurve curve;        ///< the speed curve used, matched or drawn
    Gradient gradient;       ///< W colours G(u(x))
    ColorImage texture;      ///< D = S - G(u(x)), in [-1, 1], as large as the strip
    double residue = 0;      ///< RMS over columns and channels of averages minus gradient
};

/// Separates colour from texture (§3.1, §3.2). Deterministic. The strip must not be empty. Throws Cancelled,
/// and Error when a parameter is out of range or the curve breaks its rules.
Separation separate(const ColorImage& strip, const GradientParams& params = {}, const Task& task = {});

/// S' = clip(D + G'): the texture over another gradient (§3.2). Throws Error unless the gradient has one
/// colour a column.
ColorImage recolored(const ColorImage& texture, const Gradient& gradient);

}  // namespace chiaro::gradient
