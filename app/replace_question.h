#pragma once

#include <QString>

#include <filesystem>
#include <vector>

class QWidget;

namespace chiaro::app {

/// Asks whether the files that are there already may be replaced; true without a question when none is. Its
/// title is the dialog's, or `title`.
bool mayReplace(QWidget& dialog, const std::vector<std::filesystem::path>& files, const QString& title = {});

}  // namespace chiaro::app
