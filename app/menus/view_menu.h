#pragma once

#include <QMenu>

namespace chiaro::widgets {
class Viewport;
}

namespace chiaro::app {

class CameraMoves;
class CompareTools;
class MetricTools;
class ThemeSwitch;
class ViewOverlays;

/// How the scene is looked at, what lies over it, and which docks are there.
class ViewMenu : public QMenu {
    Q_OBJECT

public:
    /// Lists the docks that `window` has by now.
    ViewMenu(widgets::Viewport& viewport, CompareTools& compare, const CameraMoves& moves,
             const ViewOverlays& overlays, const MetricTools& metrics, QWidget& window);

    /// Theme and language, to choose.
    void addAppearance(ThemeSwitch& theme);

Q_SIGNALS:
    void resetLayoutWanted();

private:
    void addNavigation();
    void setNavigation(int navigation);

    widgets::Viewport& m_viewport;
};

}  // namespace chiaro::app
