#pragma once

#include <QMenu>

namespace chiaro::app {

class Document;
class Exporter;
class ProjectCollector;
class ProjectFiles;

/// What comes into the studio and what goes out.
class FileMenu : public QMenu {
    Q_OBJECT

public:
    /// Quitting closes `window`.
    FileMenu(Document& document, ProjectFiles& files, ProjectCollector& collector, Exporter& exporter,
             QWidget& window);
};

}  // namespace chiaro::app
