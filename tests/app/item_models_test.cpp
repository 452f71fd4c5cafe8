#include "app/comparison_table.h"
#include "app/job_model.h"
#include "app/scene_model.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/project/render_method.h"
#include "tests/app/app_support.h"

#include <QAbstractItemModelTester>
#include <QtTest>
#include <QtWidgets>

#include <thread>

using namespace chiaro;
using test::Studio;

namespace {

/// Holds a model to Qt's rules, with a view on it that asks as views do.
class Watched {
public:
    explicit Watched(QAbstractItemModel& model)
        : m_tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest) {
        m_view.setModel(&model);
        m_view.resize(300, 200);
        m_view.show();
    }
    /// Every item of every column is asked for all that views show.
    void read() const {
        const QAbstractItemModel& model = *m_view.model();
        for (int row = 0; row < model.rowCount(); ++row)
            for (int column = 0; column < model.columnCount(); ++column)
                for (int role = 0; role <= Qt::InitialSortOrderRole; ++role)
                    model.index(row, column).data(role);
    }

private:
    QTableView m_view;
    QAbstractItemModelTester m_tester;
};

int below(Random& random, std::size_t end) {
    return int(random.uniform() * double(end));
}

/// Some edit of the scene that an artist may make.
void editScene(app::Document& document, Random& random) {
    auto objects = document.project().objects;
    auto lights = document.project().lights;
    QUndoStack& undo = document.undoStack();
    switch (below(random, 7)) {
        case 0:
            lights.emplace_back().name = lights.size() % 2 ? "" : "rim";
            return document.editLights(lights, "Add Light");
        case 1:
            if (lights.size() > 1) lights.erase(lights.begin() + below(random, lights.size()));
            return document.editLights(lights, "Remove Light");
        case 2:
            if (objects.size() < 12 && !objects.empty())
                document.duplicateObjects({below(random, objects.size())});
            return;
        case 3:
            if (objects.size() > 1) document.removeObjects({below(random, objects.size())});
            return;
        case 4:
            if (!objects.empty()) objects[std::size_t(below(random, objects.size()))].name = "head";
            return document.editObjects(objects, "Rename");
        case 5:
            for (int i = below(random, 6); i > 0; --i) undo.undo();
            return;
        default:
            for (int i = below(random, 6); i > 0; --i) undo.redo();
    }
}

}  // namespace

class ItemModelsTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

private Q_SLOTS:
    void theSceneKeepsTheRulesUnderEdits() {
        Studio studio;
        app::SceneModel model(studio.document);
        const Watched watched(model);
        const auto strip = test::writeStrip(m_folder / "strip.png");
        QVERIFY(studio.open({strip, test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron")}));
        Random random(1);
        for (int i = 0; i < 300; ++i) {
            editScene(studio.document, random);
            studio.document.finishEdit();
            const project::Project& project = studio.document.project();
            QCOMPARE(model.rowCount(), int(project.objects.size() + project.lights.size()));
            watched.read();
        }
        QVERIFY(model.setData(model.index(0, 0), "renamed"));
        model.setVisible({0, model.rowCount() - 1}, false);
        QVERIFY(studio.settle());
        studio.document.replace({}, {}, {});
        QCOMPARE(model.objectCount(), 0);
        watched.read();
    }

    void whoAsksAmidAChangeGetsAnAnswer() {
        Studio studio;
        std::unique_ptr<app::SceneModel> model;
        // Told of changes before the model is.
        connect(&studio.document, &app::Document::changed, this, [&] {
            for (int row = 0; model && row < model->rowCount(); ++row) {
                model->index(row, app::SceneModel::Name).data();
                model->index(row, app::SceneModel::Eye).data(Qt::ToolTipRole);
            }
        });
        model = std::make_unique<app::SceneModel>(studio.document);
        QVERIFY(studio.open({test::writeStrip(m_folder / "strip.png"),
                             test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron")}));
        auto lights = studio.document.project().lights;
        lights.resize(3);
        studio.document.editLights(lights, "Add Lights");
        studio.document.duplicateObjects({0});
        studio.document.removeObjects({0, 1});
        lights.resize(1);
        studio.document.editLights(lights, "Remove Lights");
        QCOMPARE(model->rowCount(), 1);
    }

    void theJobsKeepTheRulesWhileTheyComeAndGo() {
        app::JobRunner jobs;
        app::JobModel model(jobs);
        const Watched watched(model);
        Random random(2);
        const auto quick = [](const Task&) { return 1; };
        const auto fails = [](const Task&) -> int { throw Error("strip.png", "is empty", "scan it again"); };
        const auto endless = [](const Task& task) -> int {
            for (;; std::this_thread::sleep_for(std::chrono::milliseconds(1))) task.checkpoint();
        };
        const auto ignore = [](int) {};
        for (int i = 0; i < 200; ++i) {
            switch (below(random, 7)) {
                case 0:
                    jobs.start({"Quick", {}, {}, {}}, quick, ignore);
                    break;
                case 1:
                    jobs.start({"Failing", {}, {}, {}}, fails, ignore);
                    break;
                case 2:
                    jobs.start({"Endless", "slot", {}, {}}, endless, ignore);
                    break;
                case 3:
                    jobs.start({"Quiet", {}, {}, {}, true}, quick, ignore);
                    break;
                case 4:
                    model.cancel(below(random, 4));
                    break;
                case 5:
                    QTest::qWait(5);
                    break;
                default:
                    if (below(random, 8) == 0) model.clearEnded();
            }
            watched.read();
        }
        jobs.cancelAll();
        QTRY_VERIFY(jobs.isIdle());
        QCOMPARE(model.runningCount(), 0);
        QVERIFY(model.rowCount() > 0);
        model.clearEnded();
        QCOMPARE(model.rowCount(), 0);
    }

    void theComparisonKeepsTheRules() {
        app::ComparisonTable table;
        const Watched watched(table);
        std::vector<project::MethodMeasure> measures;
        for (const project::RenderMethod& method : project::renderMethods()) {
            measures.emplace_back().method = method.key;
            measures.back().similarity = {0.1 * double(measures.size()), 0.01, 100};
            table.setMeasures(measures);
            watched.read();
        }
        table.setMeasures({});
        watched.read();
        QCOMPARE(table.index(0, 0).data().toString(), QString("–"));
    }
};

QTEST_MAIN(ItemModelsTest)
#include "item_models_test.moc"
