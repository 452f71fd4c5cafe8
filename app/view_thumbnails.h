#pragma once

#include "app/view_plans.h"

#include <QImage>
#include <QObject>

#include <memory>
#include <vector>

namespace chiaro::app {

/// Pictures of what each view of a plan paints, made in the background and remembered.
class ViewThumbnails : public QObject {
    Q_OBJECT

public:
    ViewThumbnails(JobRunner& jobs, Memo& memo, QObject* parent = nullptr);

    /// Square pictures of so many device pixels on a background, of the views of a plan; null for none. The
    /// pictures there were stay until there are new ones.
    void show(std::shared_ptr<const CoveredPlan> plan, int side, QColor background);
    /// Of group `group` of the plan with this key; null while there is none.
    QImage picture(std::uint64_t planKey, int group) const;

Q_SIGNALS:
    void picturesChanged();

private:
    struct Pictures {
        std::uint64_t planKey = 0;
        std::vector<QImage> images;
    };

    JobRunner& m_jobs;
    Memo& m_memo;
    std::shared_ptr<const Pictures> m_shown;
    std::uint64_t m_key = 0;  ///< of the pictures that there should be
};

}  // namespace chiaro::app
