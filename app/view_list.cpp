#include "app/view_list.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int shownOverlaps = 4;

QString percent(double share) {
    return QString("%1 %").arg(share * 100, 0, 'f', share < 0.1 ? 1 : 0);
}

}  // namespace

void ViewList::update(const std::vector<project::PlacedView>& placed, std::shared_ptr<const CoveredPlan> plan,
                      bool isCurrent) {
    if (isCurrent || plan != m_plan) m_taken.clear();
    m_plan = std::move(plan);
    m_views.clear();
    static const std::vector<views::FaceGroup> none;
    const std::vector<views::FaceGroup>& groups = m_plan ? m_plan->planned->plan.groups : none;
    for (const project::PlacedView& one : placed) {
        ListedView& listed = m_views.emplace_back();
        listed.placed = int(m_views.size()) - 1;
        listed.view.direction = glm::dvec3(one.direction);
        listed.view.up = glm::dvec3(one.up);
        for (int group = 0; group < int(groups.size()) && listed.group < 0; ++group)
            if (glm::vec3(groups[std::size_t(group)].view.direction) == one.direction) listed.group = group;
        if (listed.group >= 0)
            listed.view = groups[std::size_t(listed.group)].view;
        else if (m_plan)
            listed.view = views::framed(listed.view, m_plan->planned->surface);
    }
    for (int group = 0; group < int(groups.size()); ++group) {
        const views::FaceGroup& one = groups[std::size_t(group)];
        if (!one.view.locked && !m_taken.contains(group)) m_views.push_back({one.view, -1, group, one.pass});
    }
}

void ViewList::take(int view) {
    m_taken.insert(at(view).group);
}

int ViewList::find(const ListedView& earlier) const {
    for (int view = 0; view < count(); ++view)
        if (glm::vec3(at(view).view.direction) == glm::vec3(earlier.view.direction)) return view;
    return earlier.placed >= 0 && earlier.placed < count() && at(earlier.placed).placed >= 0 ? earlier.placed
                                                                                             : -1;
}

const views::ViewCoverage* ViewList::coverage(int view) const {
    const int group = at(view).group;
    return m_plan && group >= 0 ? &m_plan->coverage.views[std::size_t(group)] : nullptr;
}

QString ViewList::description(int view) const {
    const ListedView& listed = at(view);
    QString text = (listed.placed >= 0 ? tr("View %1, placed") : tr("View %1, planned")).arg(view + 1);
    const views::ViewCoverage* seen = coverage(view);
    if (!seen) return text + tr(" · to be planned");
    text += tr(" · pass %1").arg(listed.pass);
    if (seen->faces == 0) return text + tr(" · sees no face");
    text += seen->faces == 1 ? tr(" · 1 face") : tr(" · %L1 faces").arg(seen->faces);
    return text +
           tr("\n%1 of the area, at %2° on average").arg(percent(seen->area)).arg(seen->meanAngle, 0, 'f', 0);
}

QString ViewList::overlaps(int view) const {
    const views::ViewCoverage* seen = coverage(view);
    if (!seen) return {};
    std::vector<std::pair<double, int>> others;  // share, number
    for (int other = 0; other < count(); ++other)
        if (other != view && at(other).group >= 0 && seen->overlap[std::size_t(at(other).group)] > 0)
            others.emplace_back(seen->overlap[std::size_t(at(other).group)], other + 1);
    if (others.empty()) return tr("Shares no face with another view");
    std::ranges::sort(others, [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    QStringList parts;
    for (int i = 0; i < std::min(shownOverlaps, int(others.size())); ++i)
        parts << tr("%1 with view %2")
                     .arg(percent(others[std::size_t(i)].first))
                     .arg(others[std::size_t(i)].second);
    const int rest = int(others.size()) - shownOverlaps;
    const QString list = parts.join(", ");
    return rest > 0 ? tr("Shares %1, less with %2 more").arg(list).arg(rest) : tr("Shares %1").arg(list);
}

}  // namespace chiaro::app
