#pragma once

#include "core/gradient/gradient.h"

#include <vector>

namespace chiaro::test {

/// The gradient sort (§3.1) word for word: recursive, looking at every column each time.
class LiteralSort {
public:
    LiteralSort(const gradient::ExactColors& averages, double searchScale)
        : m_averages(averages), m_searchScale(searchScale), m_used(averages.size(), false) {}

    std::vector<int> operator()() {
        const int last = int(m_averages.size()) - 1;
        m_used.front() = m_used.back() = true;
        m_order = {0};
        sort(0, last);
        return m_order;
    }

private:
    void sort(int a, int b) {
        const glm::dvec3 colorA(m_averages[std::size_t(a)]), colorB(m_averages[std::size_t(b)]);
        const glm::dvec3 middle = (colorA + colorB) * 0.5;
        const double radius = m_searchScale * glm::length(colorA - colorB) / 2;
        int closest = -1;
        double closestDistance = 0;
        for (int c = 0; c < int(m_averages.size()); ++c) {
            if (m_used[std::size_t(c)]) continue;
            const double distance = glm::length(glm::dvec3(m_averages[std::size_t(c)]) - middle);
            // Nearer by more than double's rounding, or else it is a tie.
            if (distance > radius - 1e-14 || (closest >= 0 && distance > closestDistance - 1e-14)) continue;
            closest = c;
            closestDistance = distance;
        }
        if (closest < 0) {
            m_order.push_back(b);
            return;
        }
        m_used[std::size_t(closest)] = true;
        sort(a, closest);
        sort(closest, b);
    }

    const gradient::ExactColors m_averages;
    double m_searchScale;
    std::vector<bool> m_used;
    std::vector<int> m_order;
};

}  // namespace chiaro::test
