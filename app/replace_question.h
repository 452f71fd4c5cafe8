#pragma once

#include <filesystem>
#include <vector>

class QWidget;

namespace chiaro::app {

/// Asks whether the files that are there already may be replaced; true without a question when none is. Its
/// title is the dialog's.
bool mayReplace(QWidget& dialog, const std::vector<std::filesystem::path>& files);

}  // namespace chiaro::app
