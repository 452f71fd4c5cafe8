#include "app/missing_files_dialog.h"

#include <QtConcurrent>
#include <QtWidgets>

namespace chiaro::app {

using project::MissingFile;

namespace {

QString question() {
    return MissingFilesDialog::tr(
        "These files of the project are not where they were. Find one, and those beside it are found as "
        "well; or search a folder for all of them.");
}

}  // namespace

MissingFilesDialog::MissingFilesDialog(project::Project& project, QWidget* parent)
    : QDialog(parent), m_project(project), m_list(new QTreeWidget) {
    setWindowTitle(tr("Missing Files"));
    m_text = new QLabel(question());
    m_text->setWordWrap(true);
    m_list->setObjectName("missing-files");
    m_list->setAccessibleName(tr("Missing files"));
    m_list->setHeaderLabels({tr("File"), tr("Used as"), tr("Folder")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setMinimumSize(560, 160);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_find = buttons->addButton(tr("Find…"), QDialogButtonBox::ActionRole);
    m_searchButton = buttons->addButton(tr("Search Folder…"), QDialogButtonBox::ActionRole);
    m_searchButton->setToolTip(tr("Looks for all of them in a folder and those below"));
    m_open = buttons->addButton(tr("Open Without Them"), QDialogButtonBox::AcceptRole);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons);
    connect(m_find, &QPushButton::clicked, this, &MissingFilesDialog::findSelected);
    connect(m_list, &QTreeWidget::itemActivated, this, &MissingFilesDialog::findSelected);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_searchButton, &QPushButton::clicked, this, &MissingFilesDialog::chooseFolder);
    connect(&m_search, &QFutureWatcher<project::Project>::finished, this, [this] {
        const std::size_t before = m_missing.size();
        m_project = m_search.result();
        showMissing(project::missingFiles(m_project));
        const int found = int(before - m_missing.size());
        if (m_missing.empty())
            m_text->setText(tr("All of them were found."));
        else if (found > 0)
            m_text->setText(tr("%1 of %2 were found.").arg(found).arg(before) + " " + question());
        else
            m_text->setText(tr("None of them is there.") + " " + question());
        Q_EMIT searched();
    });
    m_find->setDefault(true);
    showMissing(project::missingFiles(m_project));
}

MissingFilesDialog::~MissingFilesDialog() {
    m_stop.request_stop();
    m_search.waitForFinished();
}

void MissingFilesDialog::chooseFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Search Folder"));
    if (!folder.isEmpty()) search(folder);
}

void MissingFilesDialog::search(const QString& folder) {
    for (QWidget* part : std::initializer_list<QWidget*>{m_list, m_find, m_searchButton, m_open})
        part->setEnabled(false);
    m_text->setText(tr("Looking in %1…").arg(QDir::toNativeSeparators(folder)));
    m_search.setFuture(QtConcurrent::run(
        [project = m_project, folder = folder.toStdString(), stop = m_stop.get_token()]() mutable {
            try {
                project::relinkFrom(project, folder, Task(stop));
            } catch (const Cancelled&) {
                // The dialog is gone.
            }
            return project;
        }));
}

void MissingFilesDialog::showMissing(const std::vector<MissingFile>& missing) {
    m_missing = missing;
    m_list->clear();
    for (const MissingFile& file : missing) {
        const bool isScan = file.kind == MissingFile::Kind::Scan;
        const QString use =
            isScan
                ? tr("sample %1").arg(QString::fromStdString(m_project.samples[std::size_t(file.index)].name))
                : tr("mesh");
        auto* item = new QTreeWidgetItem(
            {QString::fromStdString(file.path.filename().string()), use,
             QDir::toNativeSeparators(QString::fromStdString(file.path.parent_path().string()))});
        item->setToolTip(2, item->text(2));
        m_list->addTopLevelItem(item);
    }
    for (int column = 0; column < 2; ++column) m_list->resizeColumnToContents(column);
    m_list->setCurrentItem(m_list->topLevelItem(0));
    m_list->setEnabled(true);
    m_open->setEnabled(true);
    m_find->setEnabled(!missing.empty());
    m_searchButton->setEnabled(!missing.empty());
    m_open->setText(missing.empty() ? tr("Open") : tr("Open Without Them"));
}

void MissingFilesDialog::findSelected() {
    const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
    if (row < 0) return;
    const MissingFile file = m_missing[std::size_t(row)];
    const QString name = QString::fromStdString(file.path.filename().string());
    const QString filter = tr("%1 (%1);;All files (*)").arg(name);
    const QString path = QFileDialog::getOpenFileName(this, tr("Find %1").arg(name), {}, filter);
    if (path.isEmpty()) return;
    project::relink(m_project, file, std::filesystem::path(path.toStdString()));
    showMissing(project::missingFiles(m_project));
}

}  // namespace chiaro::app
