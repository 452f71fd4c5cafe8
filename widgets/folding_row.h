#pragma once

#include <QWidget>

namespace chiaro::widgets {

/// Two widgets in a line, one at either end; where that is too narrow for both, one below the other.
class FoldingRow : public QWidget {
    Q_OBJECT

public:
    FoldingRow(QWidget* left, QWidget* right, QWidget* parent = nullptr);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    bool folds(int width) const;
    void arrange();

    QWidget* m_left = nullptr;
    QWidget* m_right = nullptr;
};

}  // namespace chiaro::widgets
