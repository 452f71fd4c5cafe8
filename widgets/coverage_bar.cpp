#include "widgets/coverage_bar.h"

#include "core/views/coverage.h"

#include <QtWidgets>

#include <cmath>
#include <numeric>

namespace chiaro::widgets {

namespace {

constexpr int barHeight = 10;
constexpr int gap = 4;

/// Never rounded to all or to nothing when it is neither.
QString percent(double share) {
    if (share > 0 && share < 0.001) return QString("< 0.1 %");
    if (share < 1 && share > 0.999) return QString("> 99.9 %");
    return QString("%1 %").arg(share * 100, 0, 'f', share == 1 ? 0 : 1);
}

}  // namespace

CoverageBar::CoverageBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Coverage"));
    setReport(nullptr);
}

void CoverageBar::setReport(const views::CoverageReport* report) {
    m_shares.reset();
    m_text = tr("Coverage is not known yet");
    if (report && report->faces > 0) {
        const std::vector<std::size_t>& passes = report->facesPerPass;
        const auto all = double(report->faces);
        const std::size_t first = passes.empty() ? 0 : passes.front();
        const std::size_t further = std::accumulate(passes.begin(), passes.end(), std::size_t(0)) - first;
        m_shares = Shares{double(first) / all, double(further) / all};
        QStringList parts;
        parts << tr("%1 in the first pass").arg(percent(m_shares->first));
        if (further > 0) {
            const QString share = percent(m_shares->further);
            parts << (passes.size() == 2 ? tr("%1 in another pass").arg(share)
                                         : tr("%1 in %2 further passes").arg(share).arg(passes.size() - 1));
        }
        if (report->unreachable > 0) parts << tr("%L1 without area").arg(report->unreachable);
        m_text = parts.join(tr(" · "));
    }
    setAccessibleDescription(m_text);
    setToolTip(m_shares ? tr("Of %L1 faces: %2").arg(report->faces).arg(m_text) : m_text);
    update();
}

void CoverageBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF bar(0.5, 0.5, width() - 1, barHeight - 1);
    QPainterPath outline;
    outline.addRoundedRect(bar, 3, 3);
    painter.fillPath(outline, palette().color(QPalette::Base));
    if (m_shares) {
        painter.setClipPath(outline);
        // What there is of a kind is seen, however little.
        const auto width = [&](double share) { return share > 0 ? std::max(2.0, share * bar.width()) : 0; };
        const double further = width(m_shares->further);
        const double first = std::min(width(m_shares->first), bar.width() - further);
        const QColor accent = palette().color(QPalette::Highlight);
        painter.fillRect(QRectF(bar.left(), 0, first, barHeight), accent);
        const QRectF rest(bar.left() + first, 0, further, barHeight);
        painter.fillRect(rest, accent.darker(220));
        painter.fillRect(rest, QBrush(accent, Qt::BDiagPattern));
        painter.setClipping(false);
    }
    painter.setPen(QPen(palette().color(QPalette::Dark), 1));
    painter.drawPath(outline);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QRect line(0, barHeight + gap, width(), fontMetrics().height());
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(m_text, Qt::ElideRight, width()));
}

}  // namespace chiaro::widgets
