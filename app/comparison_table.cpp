#include "app/comparison_table.h"

#include "core/project/comparison_report.h"
#include "core/project/render_method.h"
#include "widgets/core_text.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int columnsPerMethod = 2;  ///< ours, and the report's

const project::RenderMethod& methodOf(int column) {
    return project::renderMethods()[std::size_t(column / columnsPerMethod)];
}

bool isReported(int column) {
    return column % columnsPerMethod == 1;
}

}  // namespace

void ComparisonTable::setMeasures(std::vector<project::MethodMeasure> measures) {
    beginResetModel();
    m_measures = std::move(measures);
    endResetModel();
}

int ComparisonTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(project::comparedErrors().size());
}

int ComparisonTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(project::renderMethods().size()) * columnsPerMethod;
}

/// Null where nothing was measured.
const metrics::Estimate* ComparisonTable::estimate(int row, int column) const {
    for (const project::MethodMeasure& measure : m_measures) {
        const metrics::Estimate& found = measure.*project::comparedErrors()[std::size_t(row)].measured;
        if (measure.method == methodOf(column).key) return found.count > 0 ? &found : nullptr;
    }
    return nullptr;
}

bool ComparisonTable::isSmallest(int row, int column) const {
    const metrics::Estimate* own = estimate(row, column);
    for (int other = 0; own && other < columnCount(); other += columnsPerMethod)
        if (const auto* one = estimate(row, other); one && one->mean < own->mean) return false;
    return own != nullptr;
}

QVariant ComparisonTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const int row = index.row(), column = index.column();
    const auto& error = project::comparedErrors()[std::size_t(row)];
    const metrics::Estimate* measured = isReported(column) ? nullptr : estimate(row, column);
    switch (role) {
        case Qt::DisplayRole: {
            if (isReported(column)) {
                const auto value = project::reportedError(error, methodOf(column).key);
                return value ? QString::number(*value, 'f', 5) : QString();
            }
            if (!measured) return QString("–");
            return tr("%1 ± %2").arg(measured->mean, 0, 'f', 5).arg(measured->standardError, 0, 'f', 5);
        }
        case Qt::ToolTipRole:
            if (!measured) return {};
            return tr("The mean over %L1 pixels, and its standard error").arg(measured->count) +
                   (isSmallest(row, column) ? tr("\nThe smallest of the row") : QString());
        case Qt::TextAlignmentRole:
            return int(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ForegroundRole:
            if (isReported(column)) return QApplication::palette().brush(QPalette::PlaceholderText);
            return isSmallest(row, column) ? QApplication::palette().brush(QPalette::Highlight) : QVariant();
        case Qt::FontRole: {
            QFont font = QApplication::font();
            font.setBold(!isReported(column) && isSmallest(row, column));
            return font;
        }
        default:
            return {};
    }
}

QVariant ComparisonTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role == Qt::TextAlignmentRole)
        return int((orientation == Qt::Vertical ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && orientation == Qt::Horizontal && isReported(section))
        return tr("What the report found with its own paints and meshes");
    if (role != Qt::DisplayRole) return {};
    if (orientation == Qt::Vertical)
        return widgets::coreText(project::comparedErrors()[std::size_t(section)].name);
    return isReported(section) ? tr("report") : widgets::coreText(methodOf(section).label);
}

}  // namespace chiaro::app
