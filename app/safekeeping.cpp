#include "app/safekeeping.h"

#include "app/document.h"
#include "app/missing_files_dialog.h"
#include "app/opener.h"
#include "app/recovery_dialog.h"

#include <QtWidgets>

namespace chiaro::app {

Safekeeping::Safekeeping(Document& document, Opener& opener, std::filesystem::path folder, QWidget& window)
    : QObject(&window),
      m_document(document),
      m_opener(opener),
      m_window(window),
      m_autosave(document, std::move(folder), {}),
      m_label(new QLabel) {
    m_label->setObjectName("autosave");
    m_label->setContentsMargins(0, 0, 14, 0);
    m_label->setToolTip(
        tr("Changes are kept every minute or 25 edits, in case Chiaro ends before they are saved"));
    connect(&m_autosave, &Autosave::kept, this, [this](const QDateTime& time) {
        m_label->setText(tr("Autosaved %1").arg(QLocale().toString(time.time(), QLocale::ShortFormat)));
    });
    connect(&m_autosave, &Autosave::cleared, m_label, &QLabel::clear);
    connect(&m_autosave, &Autosave::failed, this, [this](const QString& message) {
        m_label->setText(tr("Autosave failed"));
        m_label->setToolTip(message);
    });
    connect(&document, &Document::pathChanged, this, [this] { m_lock.take(m_document.path()); });
    opener.setMissingQuestion([this](project::Project& project) { return askMissing(project); });
    opener.setOpenQuestion([this](const std::filesystem::path& path) { return askLocked(path); });
}

bool Safekeeping::offerRecovery() {
    const std::vector<Autosave::Leftover> leftovers = m_autosave.leftovers();
    if (leftovers.empty()) return false;
    RecoveryDialog dialog(leftovers, &m_window);
    dialog.exec();
    if (dialog.answer() == RecoveryDialog::Answer::Discard) m_autosave.discard(dialog.chosen());
    if (dialog.answer() != RecoveryDialog::Answer::Recover) return false;
    const Autosave::Leftover chosen = dialog.chosen();
    connect(
        &m_opener, &Opener::projectOpened, this,
        [this, chosen](const QString& path) {
            const bool isRecovered = path == QString::fromStdString(chosen.original.string());
            if (isRecovered && m_document.isModified()) m_autosave.takeOver(chosen);
        },
        Qt::SingleShotConnection);
    m_opener.recover(chosen.kept, chosen.original);
    return true;
}

bool Safekeeping::askMissing(project::Project& project) {
    MissingFilesDialog dialog(project, &m_window);
    return dialog.exec() == QDialog::Accepted;
}

bool Safekeeping::askLocked(const std::filesystem::path& path) {
    if (path == m_document.path()) return true;
    const auto holder = ProjectLock::holder(path);
    if (!holder) return true;
    const QString name = QString::fromStdString(path.filename().string());
    const auto answer = QMessageBox::warning(
        &m_window, tr("Open Twice"),
        tr("%1 is open in another Chiaro (%2). Who saves last wins: what the other saves is lost.")
            .arg(name, *holder),
        QMessageBox::Open | QMessageBox::Cancel, QMessageBox::Cancel);
    return answer == QMessageBox::Open;
}

}  // namespace chiaro::app
