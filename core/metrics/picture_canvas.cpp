#include "core/metrics/picture_canvas.h"

#include <opencv2/imgproc.hpp>

#include <cmath>

namespace chiaro::metrics {

namespace {

constexpr int shownScale = 2;               // of the picture
constexpr int drawnScale = 2 * shownScale;  // drawn larger, so that averaging smooths what OpenCV doesn't
constexpr int subpixelBits = 4;             // of the places that OpenCV takes
constexpr double letterHeight = 7.6 / 21;   // font scale of capitals of 7.6 px; at 1 they are 21 px high

cv::Scalar scalarOf(unsigned color) {
    return cv::Scalar(double(color >> 16 & 255), double(color >> 8 & 255), double(color & 255));
}

/// Half way to white, as if it were half transparent.
unsigned paleOf(unsigned color) {
    return (color >> 1 & 0x7f7f7f) + 0x808080;
}

/// A sign of UTF-8 is one question mark, however many bytes it takes.
std::string plain(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0) == 0x80) continue;
        result += byte < ' ' ? ' ' : byte < 0x7f ? c : '?';
    }
    return result;
}

struct Pen {
    unsigned color;
    double width;
};

Pen penOf(Stroke stroke, unsigned color) {
    switch (stroke) {
        case Stroke::Grid:
            return {0xe4e4e4, 1};
        case Stroke::Axis:
            return {0x555555, 1};
        case Stroke::Bar:
            return {paleOf(color), 1};
        default:
            return {color, 1.8};
    }
}

}  // namespace

struct PictureCanvas::Paper {
    cv::Mat pixels;
    glm::dvec2 origin{0};

    cv::Point pointAt(glm::dvec2 place) const {
        const glm::dvec2 at = (origin + place) * double(drawnScale << subpixelBits);
        return {int(std::lround(at.x)), int(std::lround(at.y))};
    }

    /// Lays a color where the letters' mask says so.
    void letter(const cv::Mat& mask, cv::Point corner, unsigned color) {
        const cv::Rect whole(cv::Point(0, 0), pixels.size());
        const cv::Rect shown = cv::Rect(corner, mask.size()) & whole;
        if (!shown.empty()) pixels(shown).setTo(scalarOf(color), mask(shown - corner));
    }
};

PictureCanvas::PictureCanvas(glm::dvec2 size)
    : m_paper(std::make_unique<Paper>(
          Paper{cv::Mat(int(std::lround(size.y)) * drawnScale, int(std::lround(size.x)) * drawnScale, CV_8UC3,
                        cv::Scalar(255, 255, 255))})) {}

PictureCanvas::~PictureCanvas() = default;

void PictureCanvas::moveTo(glm::dvec2 origin) {
    m_paper->origin = origin;
}

void PictureCanvas::text(glm::dvec2 place, const std::string& text, Anchor anchor, Lettering lettering) {
    const bool title = lettering == Lettering::Title;
    const double size = letterHeight * drawnScale * (title ? 1.15 : 1);
    const int thickness = title ? drawnScale + 1 : drawnScale - 1;
    const std::string letters = plain(text);
    int below = 0;
    const cv::Size extent = cv::getTextSize(letters, cv::FONT_HERSHEY_SIMPLEX, size, thickness, &below);
    const int margin = 2 * thickness;
    cv::Mat mask(extent.height + below + 2 * margin, extent.width + 2 * margin, CV_8UC1, cv::Scalar(0));
    cv::putText(mask, letters, {margin, margin + extent.height}, cv::FONT_HERSHEY_SIMPLEX, size, 255,
                thickness);
    cv::Point corner = m_paper->pointAt(place) / (1 << subpixelBits);
    if (anchor == Anchor::Upward) {
        cv::rotate(mask, mask, cv::ROTATE_90_COUNTERCLOCKWISE);
        corner -= cv::Point(margin + extent.height, mask.rows / 2);
    } else {
        const int ahead = anchor == Anchor::Start ? 0
                          : anchor == Anchor::End ? extent.width
                                                  : extent.width / 2;
        corner -= cv::Point(margin + ahead, margin + extent.height);
    }
    m_paper->letter(mask, corner, 0x333333);
}

void PictureCanvas::line(std::span<const glm::dvec2> points, Stroke stroke, unsigned color) {
    const Pen pen = penOf(stroke, color);
    std::vector<cv::Point> way;
    for (const glm::dvec2 point : points) way.push_back(m_paper->pointAt(point));
    cv::polylines(m_paper->pixels, way, false, scalarOf(pen.color), int(std::lround(pen.width * drawnScale)),
                  cv::LINE_AA, subpixelBits);
}

void PictureCanvas::dot(glm::dvec2 place, unsigned color, const std::string&) {
    constexpr double radius = 2.2;
    cv::circle(m_paper->pixels, m_paper->pointAt(place),
               int(std::lround(radius * (drawnScale << subpixelBits))), scalarOf(color), cv::FILLED,
               cv::LINE_AA, subpixelBits);
}

ColorImage PictureCanvas::picture() const {
    cv::Mat smooth;
    cv::resize(m_paper->pixels, smooth, {}, double(shownScale) / drawnScale, double(shownScale) / drawnScale,
               cv::INTER_AREA);
    ColorImage picture(smooth.cols, smooth.rows);
    for (int y = 0; y < smooth.rows; ++y)
        for (int x = 0; x < smooth.cols; ++x) {
            const auto& pixel = smooth.at<cv::Vec3b>(y, x);
            picture(x, y) = glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0f;
        }
    return picture;
}

}  // namespace chiaro::metrics
