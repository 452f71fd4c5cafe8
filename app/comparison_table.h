#pragma once

#include "core/project/comparison.h"

#include <QAbstractTableModel>

#include <vector>

namespace chiaro::app {

/// The report's table (§5): a row an error, and for every method a column of ours with its standard error and
/// one of the report's. Before anything is measured the report's figures stand alone.
class ComparisonTable : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void setMeasures(std::vector<project::MethodMeasure> measures);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const metrics::Estimate* estimate(int row, int column) const;
    bool isSmallest(int row, int column) const;

    std::vector<project::MethodMeasure> m_measures;
};

}  // namespace chiaro::app
