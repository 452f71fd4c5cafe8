#include "widgets/folding_row.h"

#include <QtWidgets>

#include <algorithm>

namespace chiaro::widgets {

namespace {

constexpr int gap = 12;
constexpr int lineGap = 2;

}  // namespace

FoldingRow::FoldingRow(QWidget* left, QWidget* right, QWidget* parent)
    : QWidget(parent), m_left(left), m_right(right) {
    left->setParent(this);
    right->setParent(this);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

bool FoldingRow::folds(int width) const {
    const int right = m_right->sizeHint().width();
    return right > 0 && m_left->sizeHint().width() + gap + right > width;
}

int FoldingRow::heightForWidth(int width) const {
    const int left = m_left->sizeHint().height(), right = m_right->sizeHint().height();
    return folds(width) ? left + lineGap + right : std::max(left, right);
}

QSize FoldingRow::sizeHint() const {
    const int width = m_left->sizeHint().width() + gap + m_right->sizeHint().width();
    return {width, heightForWidth(width)};
}

QSize FoldingRow::minimumSizeHint() const {
    const int width = std::max(m_left->minimumSizeHint().width(), m_right->minimumSizeHint().width());
    return {width, std::max(m_left->sizeHint().height(), m_right->sizeHint().height())};
}

void FoldingRow::arrange() {
    const QSize left = m_left->sizeHint(), right = m_right->sizeHint();
    if (folds(width())) {
        m_left->setGeometry(0, 0, std::min(left.width(), width()), left.height());
        m_right->setGeometry(0, left.height() + lineGap, std::min(right.width(), width()), right.height());
    } else {
        m_left->setGeometry(0, (height() - left.height()) / 2, left.width(), left.height());
        m_right->setGeometry(width() - right.width(), (height() - right.height()) / 2, right.width(),
                             right.height());
    }
}

void FoldingRow::resizeEvent(QResizeEvent*) {
    arrange();
}

bool FoldingRow::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) {
        updateGeometry();
        arrange();
    }
    return QWidget::event(event);
}

}  // namespace chiaro::widgets
