#include "core/project/mesh_export.h"

#include "core/base/error.h"
#include "core/export/view_pictures.h"
#include "core/methods/view_map.h"
#include "tests/core/export/glb_reader.h"
#include "tests/core/views/meshes.h"
#include "tests/support/support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <tbb/global_control.h>

namespace chiaro::project {
namespace {

using exporting::Bake;
using exporting::MeshFormat;

/// A ball and a smaller one that is turned about beside it, in oils.
struct TwoBalls {
    Project project;
    scene::Scene scene;
    std::vector<Paint> paints;
    mutable WornPaints worn = {};  ///< once it was asked for

    explicit TwoBalls(const std::string& method) {
        project.method = method;
        project.samples.resize(1);
        project.samples[0].scan = test::resource("demo/samples/oil.png");
        project.views.size = 128;
        project.views.count = 6;
        project.levels.count = 2;
        project.levels.size = 128;
        project.levels.quilt.block = 24;
        scene = test::sceneOf({test::ball(48, 24), test::ball(32, 16)});
        glm::mat4 place = glm::translate(glm::mat4(1), glm::vec3(1.3f, 0.6f, 0.5f));
        place = glm::scale(glm::rotate(place, 2.0f, glm::vec3(1, 1, 0)), glm::vec3(0.5f));
        scene.objects[1].transform = place;
        scene.lights = project.lights;
        paints = {preparePaint(project, 0)};
    }

    /// The lights may change meanwhile, the objects may not.
    const WornPaints& wornByObjects() const {
        if (worn.empty()) worn = wornPaints(project, scene, paints);
        return worn;
    }
    ExportedMesh exported(const MeshExportParams& params = {.atlas = 1024},
                          MeshFormat format = MeshFormat::Glb) const {
        return paintMesh(project, scene, wornByObjects(), format, params);
    }
};

struct Difference {
    double mean = 0;      ///< of a channel, 0..255
    double contrast = 0;  ///< standard deviation of the one picture over that of the other
};

/// Between a GLB in an unlit viewer and the method's own picture, inside the objects.
Difference differenceFrom(const TwoBalls& balls, const exporting::TexturedScene& scene, glm::vec3 direction) {
    const test::TemporaryFolder folder;
    writeTexturedScene(folder / "balls.glb", scene);
    const test::GlbScene glb = test::readGlb(folder / "balls.glb");
    scene::Camera camera;
    camera.azimuth = glm::degrees(std::atan2(direction.x, direction.z));
    camera.elevation = glm::degrees(std::asin(direction.y));
    camera = camera.framed(scene::boundsOf(balls.scene));
    const scene::RayScene rays = scene::RayScene(glb.scene).with(balls.scene.occlusion);
    const scene::GBuffer gbuffer = scene::castGBuffer(rays, balls.scene.lights, camera, 400, 400);
    const ColorImage unlit = test::unlitPicture(glb, gbuffer).color;
    const methods::Frame own = renderFrame(balls.project, balls.wornByObjects(), gbuffer).frame;
    double difference = 0, count = 0;
    glm::dvec2 sums(0), squares(0);
    for (std::size_t i = 0; i < unlit.pixelCount(); ++i) {
        if (own.picture.pixels()[i].a < 1) continue;
        const glm::vec3 a = unlit.pixels()[i], b(own.picture.pixels()[i]);
        difference += double(glm::dot(glm::abs(a - b), glm::vec3(255.0f / 3)));
        const glm::dvec2 texture(a.g - b.g + own.texture.pixels()[i].g, own.texture.pixels()[i].g);
        sums += texture;
        squares += texture * texture;
        ++count;
    }
    EXPECT_GT(count, 30000);
    const glm::dvec2 deviation = glm::sqrt(squares / count - (sums / count) * (sums / count));
    return {difference / count, deviation.x / deviation.y};
}

TEST(MeshExport, LooksFromAViewOfThePlanAsTheMethodPaintsIt) {
    const TwoBalls balls("view-dependent");
    const ExportedMesh mesh = balls.exported();
    const auto planned = planObject(balls.project, balls.scene, 0);
    for (const std::size_t view : {0u, 3u, 5u}) {
        const glm::vec3 direction(glm::normalize(planned->plan.groups.at(view).view.direction));
        const Difference difference = differenceFrom(balls, mesh.scene, direction);
        EXPECT_LT(difference.mean, 4) << "view " << view;
        std::printf("view %zu: %.2f of 255\n", view, difference.mean);
    }
}

TEST(MeshExport, OfTheOtherMethodsKeepsColourAndContrast) {
    for (const char* method : {"view-aligned", "image-based"}) {
        SCOPED_TRACE(method);
        const TwoBalls balls(method);
        const Difference difference = differenceFrom(balls, balls.exported().scene, {0, 0, 1});
        EXPECT_LT(difference.mean, 30);  // other strokes, of the same paint on the same light
        EXPECT_NEAR(difference.contrast, 1, 0.25);
        std::printf("%s: %.1f of 255, contrast %.2f\n", method, difference.mean, difference.contrast);
    }
}

/// The picture that a method paints of a view of an object's plan, and which place each pixel shows, where
/// that view is by far the best one of the place.
struct PlanPicture {
    scene::GBuffer seen;
    ColorImage color;
    std::size_t pixels = 0;

    PlanPicture(const TwoBalls& balls, std::size_t group) {
        const auto planned = planObject(balls.project, balls.scene, 0);
        const methods::ViewWeights weights(*planned, balls.project.views.epsilon);
        const exporting::SurfaceLight light(balls.scene, Bake::Lit);
        const auto textures = exporting::paintViews(
            *planned, weights, 0, light, [&](const scene::GBuffer& guide, const Task& task) {
                return renderFrame(balls.project, balls.wornByObjects(), guide, task).frame;
            });
        const methods::ViewMap map = methods::ViewMap::of(*planned, group);
        seen.width = map.face.width();
        seen.height = map.face.height();
        seen.objectId = IdImage(seen.width, seen.height);
        seen.faceId = Image<std::uint32_t>(seen.width, seen.height);
        seen.barycentrics = Image<glm::vec2>(seen.width, seen.height);
        color = ColorImage(seen.width, seen.height);
        for (int y = 0; y < seen.height; ++y)
            for (int x = 0; x < seen.width; ++x) {
                const std::uint32_t face = map.face(x, y);
                if (face == views::noFace) continue;
                const auto place = bestSeen(weights.of(face), group, map.center(x, y));
                if (!place) continue;
                const float l = light.at(0, face, *place);
                const glm::vec3 texture = textures.views[group].at(0, map.center(x, y));
                seen.objectId(x, y) = 1;
                seen.faceId(x, y) = face;
                seen.barycentrics(x, y) = *place;
                color(x, y) =
                    glm::clamp(gradient::lookUp(balls.paints[0].shown, double(l)) + texture, 0.0f, 1.0f);
                ++pixels;
            }
    }

private:
    /// Where on a face a position in the group's map lies; empty beyond the face, and where another view
    /// counts.
    static std::optional<glm::vec2> bestSeen(std::span<const methods::ViewWeights::FaceView> views,
                                             std::size_t group, glm::vec2 position) {
        const auto own = std::ranges::find(views, group, &methods::ViewWeights::FaceView::group);
        const glm::vec2 origin = own->corners[0].position;
        const glm::mat2 sides{own->corners[1].position - origin, own->corners[2].position - origin};
        const glm::vec2 place = glm::inverse(sides) * (position - origin);
        const glm::vec3 corners(1 - place.x - place.y, place);
        if (std::min({corners.x, corners.y, corners.z}) < 0) return {};
        float most = 0, mine = 0;
        for (const methods::ViewWeights::FaceView& view : views) {
            float weight = 0;
            for (int k = 0; k < 3; ++k) weight += view.corners[std::size_t(k)].weight * corners[k];
            (view.group == group ? mine : most) = std::max(view.group == group ? mine : most, weight);
        }
        return mine > 2 * most ? std::optional(place) : std::nullopt;
    }
};

TEST(MeshExport, ShowsThePicturesThatTheOtherMethodsPaintOfThePlansViews) {
    for (const char* method : {"view-aligned", "image-based"}) {
        SCOPED_TRACE(method);
        const TwoBalls balls(method);
        const test::TemporaryFolder folder;
        writeTexturedScene(folder / "balls.glb", balls.exported().scene);
        const test::GlbScene glb = test::readGlb(folder / "balls.glb");
        for (const std::size_t view : {0u, 3u, 5u}) {
            const PlanPicture own(balls, view);
            const test::UnlitPicture unlit = test::unlitPicture(glb, own.seen);
            double difference = 0;
            for (std::size_t i = 0; i < own.color.pixelCount(); ++i)
                if (unlit.covered.pixels()[i])
                    difference += double(glm::dot(glm::abs(unlit.color.pixels()[i] - own.color.pixels()[i]),
                                                  glm::vec3(255.0f / 3)));
            EXPECT_GT(own.pixels, 500u) << "view " << view;
            EXPECT_LT(difference / double(own.pixels), 4) << "view " << view;
            std::printf("%s, view %zu: %.2f of 255 over %zu px\n", method, view,
                        difference / double(own.pixels), own.pixels);
        }
    }
}

TEST(MeshExport, TakesTheLightAlongOrNot) {
    TwoBalls balls("view-dependent");
    const auto lit = balls.exported().scene.texture;
    const auto texture = balls.exported({.atlas = 1024, .bake = Bake::Texture}).scene.texture;
    balls.scene.lights.front().vector = {0.5f, -0.7f, 0.1f};
    EXPECT_NE(balls.exported().scene.texture, lit);
    EXPECT_EQ(balls.exported({.atlas = 1024, .bake = Bake::Texture}).scene.texture, texture);
    // Everywhere the paint's middle colour, give or take its strokes.
    glm::dvec3 sum(0);
    for (const glm::u8vec3& pixel : texture.pixels()) sum += glm::dvec3(pixel) / 255.0;
    const glm::vec3 middle = gradient::lookUp(balls.paints[0].shown, 0.5);
    EXPECT_LT(glm::distance(glm::vec3(sum / double(texture.pixelCount())), middle), 0.06f);
}

TEST(MeshExport, TakesShadowsAlong) {
    TwoBalls balls("view-dependent");
    balls.scene.lights.front().vector = {1, 0.4f, 0.3f};  // past the small ball onto the large one
    const auto plain = balls.exported().scene.texture;
    balls.scene.occlusion.shadows = true;
    balls.scene.occlusion.ambient = 0.5;
    const ExportedMesh mesh = balls.exported();
    EXPECT_NE(mesh.scene.texture, plain);
    EXPECT_LT(differenceFrom(balls, mesh.scene, glm::normalize(glm::vec3(0.6f, 0.2f, 1))).mean, 4);
}

TEST(MeshExport, HoldsTheVisibleObjectsByName) {
    TwoBalls balls("view-aligned");
    balls.scene.objects[0].name = "large";
    balls.scene.objects[1].name = "small";
    ExportedMesh both = balls.exported({.atlas = 256});
    ASSERT_EQ(both.scene.objects.size(), 2u);
    EXPECT_EQ(both.scene.objects[1].name, "small");
    EXPECT_EQ(both.report.faces,
              balls.scene.objects[0].mesh->triangles.size() + balls.scene.objects[1].mesh->triangles.size());
    EXPECT_EQ(both.scene.objects[1].transform, balls.scene.objects[1].transform);
    balls.scene.objects[0].visible = false;
    const ExportedMesh one = balls.exported({.atlas = 256});
    ASSERT_EQ(one.scene.objects.size(), 1u);
    EXPECT_EQ(one.scene.objects[0].name, "small");
    balls.scene.objects[1].visible = false;
    EXPECT_THROW(balls.exported({.atlas = 256}), Error);
}

TEST(MeshExport, GivesVerticesTheColoursOfTheirPlaces) {
    const TwoBalls balls("view-dependent");
    const ExportedMesh mesh = balls.exported({}, MeshFormat::Ply);
    EXPECT_TRUE(mesh.scene.texture.empty());
    EXPECT_EQ(mesh.report.charts, 0u);
    const exporting::TexturedObject& ball = mesh.scene.objects[0];
    EXPECT_EQ(ball.positions, balls.scene.objects[0].mesh->positions);
    // Where the light falls the paint is light.
    const glm::vec3 light = glm::normalize(balls.scene.lights.front().vector);
    double lit = 0, dark = 0, lits = 0, darks = 0;
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
        const float cosine = glm::dot(ball.positions[i], light);
        if (cosine > 0.7f) lit += ball.colors[i].g, ++lits;
        if (cosine < -0.7f) dark += ball.colors[i].g, ++darks;
    }
    EXPECT_GT(lit / lits, dark / darks + 60);
}

TEST(MeshExport, IsTheSameWithAnyNumberOfThreads) {
    for (const char* method : {"view-dependent", "image-based"}) {
        const TwoBalls balls(method);
        const ExportedMesh many = balls.exported({.atlas = 256});
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(balls.exported({.atlas = 256}).scene.texture, many.scene.texture);
    }
}

TEST(MeshExport, TakesMeshesOfEveryKindOfTrouble) {
    for (const char* method : {"view-dependent", "view-aligned"}) {
        TwoBalls balls(method);
        balls.project.views.size = 64;
        for (const test::OddMesh& odd : test::oddMeshes()) {
            SCOPED_TRACE(odd.what);
            balls.scene = test::sceneOf(odd.parts);
            balls.worn.clear();
            const ExportedMesh mesh = balls.exported({.atlas = 128, .padding = 2});
            EXPECT_EQ(mesh.scene.objects.size(), odd.parts.size());
            EXPECT_EQ(mesh.report.overlap, 0);
        }
    }
}

TEST(MeshExport, CanBeCancelled) {
    const TwoBalls balls("view-dependent");
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(paintMesh(balls.project, balls.scene, balls.wornByObjects(), MeshFormat::Glb, {.atlas = 256},
                           Task(stop.get_token())),
                 Cancelled);
}

}  // namespace
}  // namespace chiaro::project
