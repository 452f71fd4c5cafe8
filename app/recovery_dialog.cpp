#include "app/recovery_dialog.h"

#include <QtWidgets>

namespace chiaro::app {

RecoveryDialog::RecoveryDialog(std::vector<Autosave::Leftover> leftovers, QWidget* parent)
    : QDialog(parent), m_leftovers(std::move(leftovers)), m_list(new QListWidget) {
    setWindowTitle(tr("Recover"));
    auto* text = new QLabel(tr("Chiaro ended before these changes were saved. Recover them?"));
    text->setWordWrap(true);
    m_list->setObjectName("leftovers");
    m_list->setAccessibleName(tr("Changes that were kept"));
    m_list->setMinimumSize(420, 96);
    for (const Autosave::Leftover& leftover : m_leftovers) {
        const QString time = QLocale().toString(leftover.time, QLocale::ShortFormat);
        auto* item = new QListWidgetItem(tr("%1, %2").arg(leftover.name, time), m_list);
        item->setToolTip(leftover.original.empty() ? tr("It was never saved")
                                                   : QString::fromStdString(leftover.original.string()));
    }
    m_list->setCurrentRow(0);
    auto* buttons = new QDialogButtonBox;
    auto* recover = buttons->addButton(tr("Recover"), QDialogButtonBox::AcceptRole);
    auto* later = buttons->addButton(tr("Not Now"), QDialogButtonBox::RejectRole);
    auto* discard = buttons->addButton(tr("Discard"), QDialogButtonBox::DestructiveRole);
    discard->setToolTip(tr("Removes these changes for good"));
    recover->setDefault(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons);
    const auto end = [this](Answer answer) {
        m_answer = answer;
        accept();
    };
    connect(recover, &QPushButton::clicked, this, [end] { end(Answer::Recover); });
    connect(later, &QPushButton::clicked, this, [end] { end(Answer::Later); });
    connect(discard, &QPushButton::clicked, this, [end] { end(Answer::Discard); });
    connect(m_list, &QListWidget::itemActivated, this, [end] { end(Answer::Recover); });
}

const Autosave::Leftover& RecoveryDialog::chosen() const {
    return m_leftovers[std::size_t(std::max(0, m_list->currentRow()))];
}

}  // namespace chiaro::app
