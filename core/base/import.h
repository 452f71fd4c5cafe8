#pragma once

#include "core/base/parameters.h"
#include "core/base/task.h"

#include <filesystem>
#include <stop_token>

namespace chiaro {

namespace helper {
class HelperPool;
}

/// What reading one file may take when it happens in a helper process.
struct ImportSettings {
    int megabytes = 4096;                ///< of memory, 512..65536
    int seconds = 30;                    ///< 1..3600
    std::filesystem::path program = {};  ///< empty: chiaro-import, as installed or built
    static const ParameterTable<ImportSettings>& table();

    /// These, but with CHIARO_IMPORT_MEMORY and CHIARO_IMPORT_SECONDS where they are set. Throws Error when
    /// one is out of range.
    static ImportSettings fromEnvironment(ImportSettings otherwise);
    static ImportSettings fromEnvironment() { return fromEnvironment(ImportSettings()); }
};

/// From now on readImage, readImageMetadata and scene::readModel read in helper processes: limited in memory
/// and time, unable to write files or to reach the network, so that a file that breaks its reader breaks
/// nothing else. Without this call they read in this process, as the helper itself does and tests do. Every
/// import is cancelled once a stop is requested. Throws Error when a setting is out of range.
void importInHelpers(const ImportSettings& settings, std::stop_token stop = {});

/// While it lives, what this thread has read in helpers is cancelled when the task is: for readers that are given
/// no task of their own. Not to be nested.
class ImportsOfTask {
public:
    explicit ImportsOfTask(const Task& task);
    ~ImportsOfTask();
    ImportsOfTask(const ImportsOfTask&) = delete;
    ImportsOfTask& operator=(const ImportsOfTask&) = delete;

    /// Of this thread; false without one.
    static bool cancelled();
};

/// Null while files are read in this process.
helper::HelperPool* importHelpers();

}  // namespace chiaro
