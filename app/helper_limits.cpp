#include "app/helper_limits.h"

#include "core/base/import.h"

#include <QSettings>

#include <cstdio>

namespace chiaro::app {

void readFilesInHelpers() {
    ImportSettings limits;
    const auto& table = ImportSettings::table();
    try {
        const QSettings settings;
        std::vector<double> values = table.values(limits);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const QString key = QString::fromStdString("import/" + table.specs()[i].key);
            if (settings.contains(key))
                values[i] = table.specs()[i].parse(settings.value(key).toString().toStdString());
        }
        table.assign(limits, values);
        limits = ImportSettings::fromEnvironment(limits);
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "chiaro-studio: %s\n", problem.what());
        limits = {};
    }
    importInHelpers(limits);
}

}  // namespace chiaro::app
