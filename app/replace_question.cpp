#include "app/replace_question.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

struct ReplaceQuestion {
    Q_DECLARE_TR_FUNCTIONS(chiaro::app::ReplaceQuestion)
};

}  // namespace

bool mayReplace(QWidget& dialog, const std::vector<std::filesystem::path>& files, const QString& title) {
    constexpr int listed = 3;
    QStringList there;
    for (const std::filesystem::path& file : files)
        if (QFileInfo::exists(QString::fromStdString(file.string())))
            there << QString::fromStdString(file.filename().string());
    if (there.isEmpty()) return true;
    QString question =
        ReplaceQuestion::tr("%1 are there already. Replace them?").arg(there.mid(0, listed).join(", "));
    if (there.size() == 1)
        question = ReplaceQuestion::tr("%1 is there already. Replace it?").arg(there.front());
    if (there.size() > listed)
        question = ReplaceQuestion::tr("%1 and %2 more are there already. Replace them?")
                       .arg(there.mid(0, listed).join(", "))
                       .arg(there.size() - listed);
    return QMessageBox::question(&dialog, title.isEmpty() ? dialog.windowTitle() : title, question,
                                 QMessageBox::Yes | QMessageBox::Cancel,
                                 QMessageBox::Cancel) == QMessageBox::Yes;
}

}  // namespace chiaro::app
