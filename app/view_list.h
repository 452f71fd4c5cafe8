#pragma once

#include "app/view_plans.h"
#include "core/project/project.h"

#include <QCoreApplication>

#include <memory>
#include <set>
#include <vector>

namespace chiaro::app {

/// A view of an object as the artist meets it.
struct ListedView {
    views::View view;
    int placed = -1;  ///< index into the object's placed views; -1: planned
    int group = -1;   ///< of the plan that is shown; -1 until it is planned with
    int pass = 1;
};

/// The views of one object: those that the artist placed, as they are now, then those that the plan added.
/// While the artist edits, the plan is the last one.
class ViewList {
    Q_DECLARE_TR_FUNCTIONS(chiaro::app::ViewList)

public:
    /// `plan` may be null; `isCurrent` when it is made with these very views.
    void update(const std::vector<project::PlacedView>& placed, std::shared_ptr<const CoveredPlan> plan,
                bool isCurrent);
    /// A planned view is about to be placed: the last plan goes on to be shown without it.
    void take(int view);

    const std::vector<ListedView>& views() const { return m_views; }
    int count() const { return int(m_views.size()); }
    const ListedView& at(int view) const { return m_views[std::size_t(view)]; }
    const std::shared_ptr<const CoveredPlan>& plan() const { return m_plan; }
    /// Where the view that was `earlier` is now: the same placed view, or one from the same direction; -1 for
    /// nowhere.
    int find(const ListedView& earlier) const;

    /// What a tooltip says of a view: its pass, its faces, their share of the area and their angle.
    QString description(int view) const;
    /// With which views it shares most, and how much; empty when it shares nothing.
    QString overlaps(int view) const;

private:
    const views::ViewCoverage* coverage(int view) const;

    std::shared_ptr<const CoveredPlan> m_plan;
    std::vector<ListedView> m_views;
    std::set<int> m_taken;  ///< groups of the plan that are placed views by now
};

}  // namespace chiaro::app
