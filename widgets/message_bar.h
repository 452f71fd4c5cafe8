#pragma once

#include <QWidget>

class QLabel;

namespace chiaro::widgets {

/// A sentence at the top of the window that stays until it is closed or replaced, and stops nobody's work.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Note, Error };

    explicit MessageBar(QWidget* parent = nullptr);

    void showMessage(const QString& text, Kind kind);
    QString text() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void showIcon();

    QLabel* m_icon = nullptr;
    QLabel* m_text = nullptr;
};

}  // namespace chiaro::widgets
