#include "core/base/import.h"

#include "core/base/error.h"
#include "core/base/helper/helper_pool.h"

#include <cstdlib>

namespace chiaro {

namespace {

std::unique_ptr<helper::HelperPool>& sharedPool() {
    static std::unique_ptr<helper::HelperPool> pool;
    return pool;
}

thread_local const Task* threadTask = nullptr;

}  // namespace

ImportsOfTask::ImportsOfTask(const Task& task) {
    threadTask = &task;
}

ImportsOfTask::~ImportsOfTask() {
    threadTask = nullptr;
}

bool ImportsOfTask::cancelled() {
    return threadTask && threadTask->cancelled();
}

const ParameterTable<ImportSettings>& ImportSettings::table() {
    static const auto made =
        ParameterTable<ImportSettings>()
            .add(&ImportSettings::megabytes, ParameterSpec::integer("memory", "Memory", "MB", 512, 65536,
                                                                    "Memory that reading one file may take"))
            .add(&ImportSettings::seconds, ParameterSpec::integer("seconds", "Time", "s", 1, 3600,
                                                                  "Seconds that reading one file may take"));
    return made;
}

ImportSettings ImportSettings::fromEnvironment(ImportSettings settings) {
    const auto& specs = table().specs();
    std::vector<double> values = table().values(settings);
    const char* const names[] = {"CHIARO_IMPORT_MEMORY", "CHIARO_IMPORT_SECONDS"};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const char* const text = std::getenv(names[i]);
        if (!text || !*text) continue;
        try {
            values[i] = specs[i].parse(text);
        } catch (const Error& error) {
            throw Error(names[i], error);
        }
    }
    table().assign(settings, values);
    return settings;
}

void importInHelpers(const ImportSettings& settings, std::stop_token stop) {
    sharedPool() = std::make_unique<helper::HelperPool>(settings, std::move(stop));
}

helper::HelperPool* importHelpers() {
    return sharedPool().get();
}

}  // namespace chiaro
