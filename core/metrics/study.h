#pragma once

#include "core/metrics/frame.h"
#include "core/metrics/line_chart.h"
#include "core/metrics/neighbours.h"

#include <string>

namespace chiaro::metrics {

/// How the metric answers to known distortions (§5.1, figures 4 to 6).
struct StudyParams {
    std::vector<int> blocks{4, 8, 12};  ///< s
    int pixels = 100;                   ///< measured in each distorted picture; 0 is every one
    std::uint64_t seed = 1;
};

enum class Distortion { Rotation, ScaleX, ScaleY, ScaleBoth, Discontinuity };
inline constexpr std::array<Distortion, 5> allDistortions{Distortion::Rotation, Distortion::ScaleX,
                                                          Distortion::ScaleY, Distortion::ScaleBoth,
                                                          Distortion::Discontinuity};
/// "rotation", "scale-x", "scale-y", "scale-both", "discontinuity".
const char* nameOf(Distortion distortion);
/// How strongly a study distorts: degrees 0..180, factors 1/2..2, blocks of 4..32 px.
std::vector<double> strengthsOf(Distortion distortion);

struct StudyTexture {
    std::string name;
    ColorImage picture;
};
/// The three built-in textures: random, diagonal, symmetric.
std::vector<StudyTexture> builtInTextures();

/// One point of one curve.
struct StudyPoint {
    std::string texture;
    Distortion distortion{};
    int block = 0;        ///< s
    double strength = 0;  ///< degrees, factor or px
    Estimate error;       ///< similarity error against the undistorted texture
};

/// Distorts each texture and measures it against itself, always inside the same central disc, whose radius is
/// a quarter of the smaller side less 2 px: what a picture shrunk to a half still fills. Throws Error naming
/// the texture when it is too small for that, or of one colour; Cancelled.
std::vector<StudyPoint> runStudy(const std::vector<StudyTexture>& textures, const StudyParams& params,
                                 const Task& task = {});

/// Rows `texture,distortion,block,value,error,standard_error,pixels` under a header.
std::string studyCsv(const std::vector<StudyPoint>& points);

/// A sheet of charts: rotation and discontinuity with a curve a texture, scale with a curve an axis.
struct StudyFigure {
    std::string name;  ///< "rotation", "scale", "discontinuity"
    std::vector<LineChart> charts;
    int columns = 1;  ///< charts in a row of the sheet
    std::string svg() const { return svgOf(charts, columns); }
    ColorImage picture() const { return pictureOf(charts, columns); }
};
std::vector<StudyFigure> studyFigures(const std::vector<StudyPoint>& points);

}  // namespace chiaro::metrics
