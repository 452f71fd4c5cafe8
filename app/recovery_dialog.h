#pragma once

#include "app/autosave.h"

#include <QDialog>

class QListWidget;

namespace chiaro::app {

/// Offers what studios that ended before their time left.
class RecoveryDialog : public QDialog {
    Q_OBJECT

public:
    enum class Answer { Recover, Discard, Later };

    explicit RecoveryDialog(std::vector<Autosave::Leftover> leftovers, QWidget* parent = nullptr);

    Answer answer() const { return m_answer; }
    const Autosave::Leftover& chosen() const;

private:
    std::vector<Autosave::Leftover> m_leftovers;
    QListWidget* m_list = nullptr;
    Answer m_answer = Answer::Later;
};

}  // namespace chiaro::app
