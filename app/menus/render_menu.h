#pragma once

#include <QMenu>

namespace chiaro::app {

class Exporter;
class MethodSwitch;
class ProjectFiles;
class TimelineDock;

/// The method that shades, and its animation.
class RenderMenu : public QMenu {
    Q_OBJECT

public:
    RenderMenu(const MethodSwitch& methods, ProjectFiles& files, Exporter& exporter, TimelineDock& timeline,
               QWidget& window);
};

}  // namespace chiaro::app
