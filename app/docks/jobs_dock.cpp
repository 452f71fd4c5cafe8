#include "app/docks/jobs_dock.h"

#include "app/job_model.h"
#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

/// A bar with the percentage where a job runs, words where it ended.
class ProgressDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const QVariant progress = index.data(JobModel::ProgressRole);
        if (!progress.isValid()) return QStyledItemDelegate::paint(painter, option, index);
        QStyleOptionViewItem row(option);
        initStyleOption(&row, index);
        row.text.clear();
        const QStyle* style = row.widget ? row.widget->style() : QApplication::style();
        style->drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        constexpr int wordWidth = 44;
        const QRectF all = QRectF(option.rect).adjusted(4, 0, -4, 0);
        const QRectF bar(all.left(), all.center().y() - 2.5, all.width() - wordWidth, 6);
        painter->setPen(Qt::NoPen);
        painter->setBrush(option.palette.color(QPalette::Dark));
        painter->drawRoundedRect(bar, 3, 3);
        painter->setBrush(option.palette.color(QPalette::Highlight));
        painter->drawRoundedRect(
            QRectF(bar.topLeft(), QSizeF(bar.width() * progress.toDouble(), bar.height())), 3, 3);
        painter->setPen(option.palette.color(QPalette::Text));
        painter->drawText(all, Qt::AlignVCenter | Qt::AlignRight, index.data().toString());
        painter->restore();
    }
};

}  // namespace

JobsDock::JobsDock(JobRunner& jobs)
    : QDockWidget(tr("Jobs")), m_model(new JobModel(jobs, this)), m_list(new QTreeView) {
    setObjectName("jobs-dock");
    m_list->setObjectName("job-list");
    m_list->setAccessibleName(tr("Jobs"));
    m_list->setModel(m_model);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAllColumnsShowFocus(true);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setMinimumHeight(72);
    m_list->setItemDelegateForColumn(JobModel::State, new ProgressDelegate(m_list));
    QHeaderView& header = *m_list->header();
    header.setStretchLastSection(false);
    header.setSectionResizeMode(JobModel::Title, QHeaderView::Stretch);
    header.setSectionResizeMode(JobModel::State, QHeaderView::Stretch);
    header.setSectionResizeMode(JobModel::Time, QHeaderView::Fixed);
    header.resizeSection(JobModel::Time, 100);
    m_list->installEventFilter(this);

    m_cancel = widgets::makeToolButton("cancel", tr("Cancel job"), tr("Cancel the selected job (Delete)"));
    m_cancelAll = widgets::makeToolButton("close", tr("Cancel all"), tr("Cancel everything that runs"));
    auto* clear = widgets::makeToolButton("remove", tr("Clear"), tr("Clear the list of what ended"));
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(2);
    for (QToolButton* button : {m_cancel, m_cancelAll, clear}) buttons->addWidget(button);
    buttons->addStretch(1);
    auto* content = new QWidget;
    auto* layout = new QHBoxLayout(content);
    layout->setContentsMargins(10, 8, 10, 8);
    layout->setSpacing(4);
    layout->addWidget(m_list, 1);
    layout->addLayout(buttons);
    setWidget(content);

    connect(m_cancel, &QToolButton::clicked, this, &JobsDock::cancelSelected);
    connect(m_cancelAll, &QToolButton::clicked, &jobs, &JobRunner::cancelAll);
    connect(clear, &QToolButton::clicked, m_model, &JobModel::clearEnded);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &JobsDock::showButtons);
    connect(m_model, &QAbstractItemModel::modelReset, this, &JobsDock::showButtons);
    showButtons();
}

void JobsDock::cancelSelected() {
    // With one job there is no need to select it.
    const int row = m_model->runningCount() == 1 ? 0 : m_list->currentIndex().row();
    m_model->cancel(row);
}

void JobsDock::showButtons() {
    const int running = m_model->runningCount();
    m_cancel->setEnabled(running == 1 || m_model->isRunning(m_list->currentIndex().row()));
    m_cancelAll->setEnabled(running > 0);
}

bool JobsDock::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_list && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        cancelSelected();
        return true;
    }
    return QDockWidget::eventFilter(watched, event);
}

}  // namespace chiaro::app
