#include "tests/widgets/viewport_support.h"

#include "core/base/random.h"
#include "core/methods/view_aligned.h"
#include "core/methods/view_map.h"
#include "core/project/pipeline.h"
#include "core/scene/gbuffer.h"

#include <numbers>

namespace chiaro::test {

namespace {

constexpr float turn = 2 * std::numbers::pi_v<float>;

}  // namespace

scene::Mesh sphereMesh(int segments) {
    scene::Mesh mesh;
    mesh.name = "sphere";
    const int rings = segments / 2;
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i <= segments; ++i) {
            const float polar = turn / 2 * float(j) / float(rings);
            const float around = turn * float(i) / float(segments);
            const glm::vec3 normal(std::sin(polar) * std::sin(around), std::cos(polar),
                                   std::sin(polar) * std::cos(around));
            mesh.positions.push_back(normal);
            mesh.normals.push_back(normal);
        }
    const auto index = [segments](int i, int j) { return std::uint32_t(j * (segments + 1) + i); };
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < segments; ++i) {
            if (j > 0) mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j)});
            if (j + 1 < rings)
                mesh.triangles.push_back({index(i + 1, j), index(i, j + 1), index(i + 1, j + 1)});
        }
    return mesh;
}

scene::Mesh squareMesh() {
    scene::Mesh mesh;
    mesh.name = "square";
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, glm::vec3(0, 0, 1));
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

scene::Scene sceneOf(scene::Mesh mesh, const std::string& name) {
    scene::Scene scene;
    scene.objects.resize(1);
    scene.objects[0].name = name;
    scene.objects[0].mesh = std::make_shared<const scene::Mesh>(std::move(mesh));
    return scene;
}

std::shared_ptr<const synthesis::LevelStack> generatedLevels(int count, int size) {
    auto stack = std::make_shared<synthesis::LevelStack>();
    for (int level = 0; level < count; ++level) {
        ColorImage image(size, size);
        Random random(7, std::uint64_t(level));
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const float u = turn * float(x) / float(size);
                const float v = turn * float(y) / float(size);
                const float strokes = std::sin(float(3 + level) * u + 2 * std::sin(v) + float(level));
                const float grain = float(random.uniform()) - 0.5f;
                image(x, y) = glm::vec3(0.12f, 0.1f, 0.08f) * strokes + 0.06f * grain;
            }
        stack->levels.push_back(std::move(image));
    }
    return stack;
}

gradient::Gradient generatedGradient(int width) {
    gradient::Gradient gradient;
    for (int i = 0; i < width; ++i) {
        const float x = float(i) / float(std::max(1, width - 1));
        gradient.emplace_back(0.1f + 0.8f * x, 0.08f + 0.75f * x * x, 0.3f + 0.4f * std::sqrt(x));
    }
    return gradient;
}

double meanDifference(const QImage& a, const QImage& b, const std::function<bool(int, int)>& inside) {
    if (a.size() != b.size()) return 255;
    double sum = 0;
    std::size_t count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            if (!inside(x, y)) continue;
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            sum +=
                std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
            count += 3;
        }
    return count == 0 ? 255 : sum / double(count);
}

double meanDifference(const QImage& a, const QImage& b) {
    return meanDifference(a, b, [](int, int) { return true; });
}

Reference referencePicture(const scene::Scene& scene, const scene::Camera& camera,
                           const std::vector<widgets::ViewportPaint>& paints,
                           const std::vector<methods::TexturePlacement>& placements,
                           const methods::ViewAlignedParams& params, glm::vec3 background, QSize pixels) {
    const scene::GBuffer gbuffer =
        scene::castGBuffer(scene::RayScene(scene), scene.lights, camera, pixels.width(), pixels.height());
    std::vector<methods::ViewAlignedPaint> worn;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const widgets::ViewportPaint& paint = paints[std::size_t(scene.objects[i].sample)];
        worn.push_back({paint.levels.get(), &paint.gradient, placements[i]});
    }
    const methods::Frame frame = methods::renderViewAligned(gbuffer, worn, params);
    Reference reference{toQImage(methods::over(frame.picture, background)),
                        Image<std::uint8_t>(pixels.width(), pixels.height(), 0)};
    for (int y = 0; y < pixels.height(); ++y)
        for (int x = 0; x < pixels.width(); ++x) reference.inside(x, y) = frame.picture(x, y).a == 1;
    return reference;
}

ImageBasedReference imageBasedPicture(const scene::Scene& scene, const scene::Camera& camera,
                                      const gradient::Gradient& gradient, glm::vec3 background,
                                      QSize pixels) {
    project::Project project;
    project.method = "image-based";
    project.imageBased.quilt.block = 24;
    project::Paint paint;
    const auto levels = generatedLevels(4, 200);
    paint.separation.texture = ColorImage(400, 100);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 400; ++x)
            paint.separation.texture(x, y) = levels->levels[std::size_t(x / 100)](x % 200, y);
    paint.shown = gradient;
    const project::WornPaints worn(scene.objects.size(), project::Worn{&paint});
    const scene::GBuffer gbuffer =
        scene::castGBuffer(scene::RayScene(scene), scene.lights, camera, pixels.width(), pixels.height());
    const methods::Frame frame = project::renderFrame(project, worn, gbuffer).frame;
    ImageBasedReference result{{toQImage(methods::over(frame.picture, background)),
                                Image<std::uint8_t>(pixels.width(), pixels.height(), 0)},
                               nullptr};
    for (int y = 0; y < pixels.height(); ++y)
        for (int x = 0; x < pixels.width(); ++x) result.reference.inside(x, y) = frame.picture(x, y).a == 1;
    const methods::ImageBasedTexture made = methods::synthesizeImageBased(
        gbuffer, methods::SampleTextures(scene.objects.size(), &paint.separation.texture),
        project.imageBased);
    result.texture = std::make_shared<const widgets::ViewTexture>(
        widgets::viewTexture(made, scene, camera, pixels.width(), pixels.height()));
    return result;
}

std::shared_ptr<const methods::PaintedObject> paintedObject(const std::shared_ptr<const scene::Mesh>& mesh,
                                                            const views::ViewParams& params) {
    auto painted = std::make_shared<methods::PaintedObject>();
    painted->planned = methods::planObject(mesh, params);
    painted->weights = std::make_shared<const methods::ViewWeights>(*painted->planned, params.epsilon);
    const auto levels = generatedLevels(8, 64);
    for (std::size_t group = 0; group < painted->planned->plan.groups.size(); ++group) {
        const methods::ViewMap map = methods::ViewMap::of(*painted->planned, group);
        methods::ViewTexture& texture = painted->textures.views.emplace_back();
        texture.origin = map.origin;
        if (map.face.empty()) continue;
        for (const ColorImage& level : levels->levels) {
            auto& texels = texture.levels.emplace_back(map.face.width(), map.face.height());
            for (int y = 0; y < texels.height(); ++y)
                for (int x = 0; x < texels.width(); ++x)
                    texels(x, y) = methods::packed(level((x + 17 * int(group)) % 64, (y * 3 / 2) % 64));
        }
    }
    return painted;
}

Reference viewDependentPicture(const scene::Scene& scene, const scene::Camera& camera,
                               const std::vector<std::shared_ptr<const methods::PaintedObject>>& painted,
                               const gradient::Gradient& gradient, const methods::ViewDependentParams& params,
                               glm::vec3 background, QSize pixels) {
    const scene::GBuffer gbuffer =
        scene::castGBuffer(scene::RayScene(scene), scene.lights, camera, pixels.width(), pixels.height());
    std::vector<methods::ViewDependentPaint> paints;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        paints.push_back({painted[i].get(), &gradient,
                          glm::vec3(glm::inverse(scene.objects[i].transform) * glm::vec4(gbuffer.eye, 1))});
    const methods::Frame frame = methods::renderViewDependent(gbuffer, paints, params);
    Reference reference{toQImage(methods::over(frame.picture, background)),
                        Image<std::uint8_t>(pixels.width(), pixels.height(), 0)};
    for (int y = 0; y < pixels.height(); ++y)
        for (int x = 0; x < pixels.width(); ++x) reference.inside(x, y) = frame.picture(x, y).a == 1;
    return reference;
}

QImage toQImage(const ColorImage& picture) {
    QImage image(picture.width(), picture.height(), QImage::Format_RGB32);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const glm::ivec3 bytes(picture(x, y) * 255.0f + 0.5f);
            image.setPixel(x, y, qRgb(bytes.r, bytes.g, bytes.b));
        }
    return image;
}

void keepPicture(const QImage& picture, const QString& name) {
    const QString folder = qEnvironmentVariable("CHIARO_TEST_PICTURES");
    if (!folder.isEmpty()) picture.save(folder + "/" + name + ".png");
}

}  // namespace chiaro::test
