#include "app/view_thumbnails.h"

#include "app/jobs/job_runner.h"
#include "app/jobs/memo.h"
#include "core/base/hash.h"
#include "core/views/thumbnail.h"
#include "widgets/picture.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

const char* const slot = "view thumbnails";

views::ThumbnailStyle styleOf(int side, QColor background) {
    const glm::vec3 back = widgets::fromColor(background);
    const bool isDark = background.lightnessF() < 0.5;
    views::ThumbnailStyle style;
    style.side = side;
    style.background = back;
    if (isDark) style.plain = glm::vec3(0.43F, 0.44F, 0.46F);
    style.receding = glm::mix(back, isDark ? glm::vec3(1) : glm::vec3(0), 0.16F);
    return style;
}

}  // namespace

ViewThumbnails::ViewThumbnails(JobRunner& jobs, Memo& memo, QObject* parent)
    : QObject(parent), m_jobs(jobs), m_memo(memo) {}

void ViewThumbnails::show(std::shared_ptr<const CoveredPlan> plan, int side, QColor background) {
    const std::uint64_t planKey = plan ? plan->key : 0;
    const std::uint64_t key =
        plan ? Hasher().add("view thumbnails").add(planKey).add(side).add(background.rgb()).value() : 0;
    if (std::exchange(m_key, key) == key) return;
    m_jobs.supersede(slot);
    if (key == 0) m_shown = nullptr;
    if (auto found = m_memo.find<Pictures>(key)) m_shown = std::move(found);
    if (key == 0 || (m_shown && m_shown->planKey == planKey)) return Q_EMIT picturesChanged();
    m_jobs.start(
        {tr("Drawing views"), slot, {}, {}},
        [plan, style = styleOf(side, background)](const Task& task) {
            Pictures pictures{plan->key, {}};
            for (const ColorImage& image :
                 views::drawThumbnails(plan->planned->surface, plan->planned->plan, style, task))
                pictures.images.push_back(widgets::toImage(image));
            return pictures;
        },
        [this, key](Pictures pictures) {
            std::size_t bytes = 0;
            for (const QImage& image : pictures.images) bytes += std::size_t(image.sizeInBytes());
            m_shown = std::make_shared<const Pictures>(std::move(pictures));
            m_memo.insert(key, m_shown, bytes);
            Q_EMIT picturesChanged();
        });
}

QImage ViewThumbnails::picture(std::uint64_t planKey, int group) const {
    const bool isKnown =
        m_shown && m_shown->planKey == planKey && group >= 0 && group < int(m_shown->images.size());
    return isKnown ? m_shown->images[std::size_t(group)] : QImage();
}

}  // namespace chiaro::app
