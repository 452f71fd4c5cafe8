#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace chiaro::app {

/// Three short hints over the viewport for who starts the studio for the first time, one at a time. Once they
/// are closed, they never come again.
class FirstHints : public QFrame {
    Q_OBJECT

public:
    /// Whether somebody closed them before.
    static bool wereSeen();

    explicit FirstHints(QWidget& viewport);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void showHint(int hint);
    void place();
    void finish();

    int m_hint = 0;
    QLabel* m_text = nullptr;
    QLabel* m_number = nullptr;
    QPushButton* m_next = nullptr;
};

}  // namespace chiaro::app
