#include "app/face_groups.h"

#include "core/project/pipeline.h"
#include "tests/app/app_support.h"
#include "widgets/viewport/viewport.h"

#include <QtTest>
#include <QtWidgets>

#include <algorithm>
#include <set>

using namespace chiaro;
using app::FaceGroups;

class FaceGroupsTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

private Q_SLOTS:
    void everyFaceHasTheColourOfItsView() {
        test::Studio studio;
        widgets::Viewport viewport;
        viewport.resize(160, 160);
        QVERIFY(studio.open({test::writeStrip(m_folder / "strip.png"),
                             test::writeTetrahedron(m_folder / "mesh.obj", "one")}));
        viewport.setScene(studio.meshes.scene());
        viewport.setCamera(project::cameraFor(studio.document.project(), studio.meshes.scene()));
        FaceGroups groups(studio.jobs, studio.viewPlans, viewport, nullptr);
        QVERIFY(groups.picture().isNull());
        studio.viewPlans.setWanted(this, true);
        groups.setWanted(true);
        QVERIFY(studio.settle());
        QVERIFY(studio.viewPlans.plan(0));
        QCOMPARE(groups.picture().size(), viewport.pixels());

        const auto& plan = *studio.viewPlans.plan(0);
        const scene::RayScene rays(studio.meshes.scene());
        const scene::GBuffer gbuffer = scene::castGBuffer(rays, {}, viewport.camera(), 160, 160);
        std::set<std::size_t> seen;
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 160; ++x) {
                const QColor color = groups.picture().pixelColor(x, y);
                const std::uint32_t face = gbuffer.faceId(x, y);
                const auto& all = plan.planned->plan.groups;
                const views::Surface& surface = plan.planned->surface;
                std::size_t of = all.size();
                double most = -1;
                for (std::size_t group = 0; group < all.size(); ++group) {
                    if (!std::ranges::binary_search(all[group].faces, face)) continue;
                    const double facing =
                        glm::dot(surface.normal(face), glm::normalize(all[group].view.direction));
                    if (facing > most) of = group;
                    most = std::max(most, facing);
                }
                if (of == all.size()) {
                    QCOMPARE(color.alpha(), 0);
                    continue;
                }
                seen.insert(of);
                // But for what premultiplied bytes round.
                const QColor expected = FaceGroups::colorOf(of);
                QVERIFY(color.alpha() > 0);
                QVERIFY(std::abs(color.red() - expected.red()) < 4);
                QVERIFY(std::abs(color.green() - expected.green()) < 4);
                QVERIFY(std::abs(color.blue() - expected.blue()) < 4);
            }
        QVERIFY(!seen.empty());
        groups.setWanted(false);
        QVERIFY(groups.picture().isNull());
    }

    void coarsePicturesFollowTheCamera() {
        test::Studio studio;
        widgets::Viewport viewport;
        viewport.resize(160, 160);
        QVERIFY(studio.open({test::writeStrip(m_folder / "strip.png"),
                             test::writeTetrahedron(m_folder / "mesh.obj", "one")}));
        viewport.setScene(studio.meshes.scene());
        viewport.setCamera(project::cameraFor(studio.document.project(), studio.meshes.scene()));
        FaceGroups groups(studio.jobs, studio.viewPlans, viewport, nullptr);
        studio.viewPlans.setWanted(this, true);
        groups.setWanted(true);
        QVERIFY(studio.settle());
        const QImage before = groups.picture();
        std::vector<QSize> sizes;
        connect(&groups, &FaceGroups::pictureChanged, &groups,
                [&] { sizes.push_back(groups.picture().size()); });
        scene::Camera camera = viewport.camera();
        for (int i = 0; i < 20; ++i) {
            camera.azimuth += 4;
            viewport.setCamera(camera);
            QTest::qWait(5);
        }
        QVERIFY(studio.settle());
        QVERIFY(sizes.size() >= 2);
        QCOMPARE(sizes.front(), QSize(40, 40));
        QCOMPARE(sizes.back(), QSize(160, 160));
        QVERIFY(groups.picture() != before);
    }
};

QTEST_MAIN(FaceGroupsTest)
#include "face_groups_test.moc"
