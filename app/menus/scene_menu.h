#pragma once

#include <QMenu>

namespace chiaro::app {

class ProjectFiles;
class SceneDock;

/// The objects and the lights.
class SceneMenu : public QMenu {
    Q_OBJECT

public:
    SceneMenu(ProjectFiles& files, SceneDock& dock, QWidget& window);
};

}  // namespace chiaro::app
