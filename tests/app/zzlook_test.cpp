#include "app/docks/view_planning_dock.h"
#include "app/main_window.h"
#include "app/theme.h"
#include "tests/support/support.h"
#include "widgets/view_sphere.h"
#include "widgets/viewport/viewport.h"
#include <QtTest>
#include <QtWidgets>
using namespace chiaro;
int main(int argc, char** argv) {
    QApplication application(argc, argv); Q_INIT_RESOURCE(resources);
    app::applyTheme(application);
    app::MainWindow window;
    window.show();
    window.open({argc > 2 ? QString(argv[2]) : QString::fromStdString(test::resource("demo/demo.chiaro").string())});
    auto& dock = window.viewPlanningDock();
    dock.show(); dock.raise();
    QTest::qWait(1500);
    for (int i = 0; i < 400 && !(window.jobs().isIdle() && window.viewPlans().plan(0)); ++i) QTest::qWait(50);
    QTest::qWait(500);
    if (argc > 3) window.document().editMethod(argv[3]);
    dock.selectView(2); dock.lockSelected();
    dock.addFromCamera();
    QTest::qWait(500);
    for (int i = 0; i < 400 && !(window.jobs().isIdle() && window.viewPlans().plan(0)); ++i) QTest::qWait(50);
    QTest::qWait(300);
    dock.selectView(0);
    QTest::qWait(300);
    window.grab().save(argv[1]);
    dock.grab().save(QString(argv[1]) + ".dock.png");
    return 0;
}
