#include "app/dropped_files.h"

#include <QtWidgets>

namespace chiaro::app {

QStringList localFiles(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    return paths;
}

}  // namespace chiaro::app
