#pragma once

#include <QMenu>

namespace chiaro::app {

class Exporter;
class ProjectFiles;

/// What comes into the studio and what goes out.
class FileMenu : public QMenu {
    Q_OBJECT

public:
    /// Quitting closes `window`.
    FileMenu(ProjectFiles& files, Exporter& exporter, QWidget& window);
};

}  // namespace chiaro::app
