// Frame time of the viewport's drawer against the same mesh under one plain 2D texture: same context, 1280 x
// 720 with as many samples a pixel, resolved; frames interleaved, the smallest time of each. `ratio` is the
// one by the other on the clock, `processor_ratio` in processor time. A mesh file may be given.

#include "core/base/random.h"
#include "core/methods/object_texels.h"
#include "core/methods/view_map.h"
#include "core/scene/mesh_io.h"
#include "tests/support/support.h"
#include "widgets/viewport/frame_drawer.h"

#include <benchmark/benchmark.h>

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QOpenGLVersionFunctionsFactory>

#include <cstdio>
#include <time.h>

namespace chiaro::widgets {

namespace {

const QSize frameSize(1280, 720);
constexpr int rounds = 40;

/// The mesh under a 2D texture of the size of a level, laid over its x and y.
class PlainDrawer {
public:
    bool initialize(Gl& gl, const synthesis::LevelStack& levels) {
        static const char* vertex = R"(#version 410 core
            layout(location = 0) in vec3 position;
            uniform mat4 objectToClip;
            uniform float scale;
            out vec2 coordinate;
            void main() {
                coordinate = position.xy * scale;
                gl_Position = objectToClip * vec4(position, 1.0);
            })";
        static const char* fragment = R"(#version 410 core
            in vec2 coordinate;
            uniform sampler2D paint;
            out vec4 color;
            void main() { color = vec4(texture(paint, coordinate).rgb, 1.0); })";
        const ColorImage& level = levels.levels.front();
        std::vector<std::uint8_t> texels;
        for (const glm::vec3& difference : level.pixels())
            for (int i = 0; i < 4; ++i) texels.push_back(std::uint8_t(128 + 100 * difference[i % 3]));
        gl.glGenTextures(1, &m_texture);
        gl.glBindTexture(GL_TEXTURE_2D, m_texture);
        gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, level.width(), level.height(), 0, GL_RGBA,
                        GL_UNSIGNED_BYTE, texels.data());
        gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        return m_program.addShaderFromSourceCode(QOpenGLShader::Vertex, vertex) &&
               m_program.addShaderFromSourceCode(QOpenGLShader::Fragment, fragment) && m_program.link();
    }

    void draw(Gl& gl, const ViewState& state) {
        m_meshes.sync(gl, state.scene());
        gl.glViewport(0, 0, frameSize.width(), frameSize.height());
        gl.glClearColor(state.background.r, state.background.g, state.background.b, 1);
        gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl.glEnable(GL_DEPTH_TEST);
        m_program.bind();
        gl.glActiveTexture(GL_TEXTURE0);
        gl.glBindTexture(GL_TEXTURE_2D, m_texture);
        m_program.setUniformValue("paint", 0);
        m_program.setUniformValue("scale", 1 / state.camera.radius);
        const glm::mat4 worldToClip =
            state.camera.projection(frameSize.width(), frameSize.height()) * state.camera.view();
        for (const scene::Object& object : state.scene().objects) {
            const glm::mat4 objectToClip = worldToClip * object.transform;
            m_program.setUniformValue("objectToClip", QMatrix4x4(&objectToClip[0][0]).transposed());
            const GlMeshes::Buffers& buffers = m_meshes.find(object.mesh);
            gl.glBindVertexArray(buffers.vertexArray);
            gl.glDrawElements(GL_TRIANGLES, buffers.indexCount, GL_UNSIGNED_INT, nullptr);
        }
        m_program.release();
    }

private:
    QOpenGLShaderProgram m_program;
    GLuint m_texture = 0;
    GlMeshes m_meshes;
};

std::shared_ptr<const synthesis::LevelStack> noiseLevels() {
    auto stack = std::make_shared<synthesis::LevelStack>();
    for (int level = 0; level < 8; ++level) {
        Random random(1, std::uint64_t(level));
        ColorImage image(512, 512);
        for (glm::vec3& difference : image.pixels()) difference = glm::vec3(float(random.uniform()) - 0.5f);
        stack->levels.push_back(std::move(image));
    }
    return stack;
}

/// Noise all over the picture for every object.
std::shared_ptr<const ViewTexture> noiseTexture(const ViewState& state) {
    auto texture = std::make_shared<ViewTexture>();
    texture->camera = state.camera;
    texture->width = frameSize.width();
    texture->height = frameSize.height();
    texture->range = methods::DifferenceRange::of(0.5f);
    Random random(2, 0);
    for (const scene::Object& object : state.scene().objects) {
        Image<methods::DifferenceTexel> texels(texture->width, texture->height);
        for (methods::DifferenceTexel& texel : texels.pixels())
            texel[0] = std::uint8_t(random.uniform() * 255);
        texture->objects.push_back({glm::ivec2(0), std::move(texels), object.transform});
    }
    return texture;
}

/// Noise in the maps of twelve views, and of those that paint the rest, for every object.
std::vector<std::shared_ptr<const methods::PaintedObject>> noisePainted(const scene::Scene& scene) {
    std::vector<std::shared_ptr<const methods::PaintedObject>> objects;
    for (const scene::Object& object : scene.objects) {
        auto painted = std::make_shared<methods::PaintedObject>();
        const views::ViewParams params;
        painted->planned = methods::planObject(object.mesh, params);
        painted->weights = std::make_shared<const methods::ViewWeights>(*painted->planned, params.epsilon);
        Random random(3, objects.size());
        for (std::size_t group = 0; group < painted->planned->plan.groups.size(); ++group) {
            const methods::ViewMap map = methods::ViewMap::of(*painted->planned, group);
            methods::ViewTexture& texture = painted->textures.views.emplace_back();
            texture.origin = map.origin;
            for (int level = 0; level < 8 && !map.face.empty(); ++level)
                for (auto& texel : texture.levels.emplace_back(map.face.width(), map.face.height()).pixels())
                    texel = methods::packed(glm::vec3(float(random.uniform()) - 0.5f));
        }
        objects.push_back(std::move(painted));
    }
    return objects;
}

ViewState makeState(const std::filesystem::path& file) {
    scene::Scene scene;
    for (scene::Mesh& mesh : scene::readModel(file).meshes)
        scene.objects.push_back(
            {.name = mesh.name, .mesh = std::make_shared<const scene::Mesh>(std::move(mesh))});
    ViewState state;
    state.setScene(scene);
    state.setPaint(0, {noiseLevels(), {glm::vec3(0.1f), glm::vec3(0.5f, 0.3f, 0.2f), glm::vec3(1)}});
    state.camera = state.camera.framed(scene::boundsOf(scene));
    state.camera.distance = 0.8f;
    return state;
}

/// Of one frame; the processor's time is what a software renderer is measured by on a busy machine.
struct FrameTime {
    double wall = std::numeric_limits<double>::infinity();  ///< ms
    double processor = wall;                                ///< ms, all threads
};

double milliseconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

/// Draws a frame and lowers `best` to its times.
void measureFrame(Gl& gl, FrameTime& best, const std::function<void()>& frame) {
    const double wall = milliseconds(CLOCK_MONOTONIC);
    const double processor = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    frame();
    gl.glFinish();
    best.wall = std::min(best.wall, milliseconds(CLOCK_MONOTONIC) - wall);
    best.processor = std::min(best.processor, milliseconds(CLOCK_PROCESS_CPUTIME_ID) - processor);
}

struct Bench {
    Gl& gl;
    PlainDrawer plain;
    FrameDrawer painted;
    ViewState state;
    std::unique_ptr<QOpenGLFramebufferObject> multisampled;
    std::unique_ptr<QOpenGLFramebufferObject> target;

    void drawPlain() {
        multisampled->bind();
        plain.draw(gl, state);
        QOpenGLFramebufferObject::blitFramebuffer(target.get(), multisampled.get());
    }

    void drawPainted() {
        state.follow(frameSize);
        painted.draw(gl, state, state.method(), frameSize, target->handle());
    }

    /// While the camera orbits, after it was moved closer by `zoom`.
    void measure(benchmark::State& counters, float zoom) {
        state.follow(frameSize);
        state.camera.distance /= zoom;
        FrameTime plainBest;
        FrameTime paintedBest;
        for (int round = 0; round < rounds; ++round) {
            state.camera.azimuth += 0.5f;
            measureFrame(gl, plainBest, [this] { drawPlain(); });
            measureFrame(gl, paintedBest, [this] { drawPainted(); });
        }
        counters.SetIterationTime(paintedBest.wall / 1e3);
        counters.counters["plain_ms"] = plainBest.wall;
        counters.counters["ratio"] = paintedBest.wall / plainBest.wall;
        counters.counters["processor_ratio"] = paintedBest.processor / plainBest.processor;
        state.camera.azimuth -= 0.5f * rounds;
        state.camera.distance *= zoom;
        state.follow(frameSize);
    }
};

/// One way to look at the scene, `setUp` before it is drawn; they run one after the other on one scene.
void registerFrame(Bench& bench, const char* name, float zoom, std::function<void()> setUp) {
    benchmark::RegisterBenchmark(name,
                                 [&bench, zoom, setUp = std::move(setUp)](benchmark::State& state) {
                                     setUp();
                                     for ([[maybe_unused]] auto _ : state) bench.measure(state, zoom);
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
}

void registerFrames(Bench& bench) {
    ViewState& state = bench.state;
    const auto aligned = [&state](bool followZoom, double density) {
        return [&state, followZoom, density] {
            state.setMethod("view-aligned");
            state.params.followZoom = followZoom;
            state.params.density = density;
        };
    };
    registerFrame(bench, "viewAligned", 1, aligned(true, 1));
    registerFrame(bench, "viewAlignedTwoOctaves", 1.4f, aligned(true, 1));
    registerFrame(bench, "viewAlignedFixed", 1, aligned(false, 1));
    registerFrame(bench, "viewAlignedDensity1.5", 1, aligned(false, 1.5));
    registerFrame(bench, "imageBased", 1, [&state] {
        state.setMethod("image-based");
        state.viewTexture = noiseTexture(state);
    });
    const auto viewDependent = [&state](bool followCamera) {
        return [&state, followCamera] {
            state.setMethod("view-dependent");
            state.setPaintedObjects(noisePainted(state.scene()));
            state.viewDependent.followCamera = followCamera;
        };
    };
    registerFrame(bench, "viewDependent", 1, viewDependent(false));
    registerFrame(bench, "viewDependentFollowing", 1, viewDependent(true));
}

int run(const std::filesystem::path& file) {
    QOpenGLContext context;
    context.setFormat(openGlFormat());
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!openGlSupport().usable || !context.create() || !context.makeCurrent(&surface)) {
        std::puts("no OpenGL 4.1 here");
        return 1;
    }
    Gl& gl = *QOpenGLVersionFunctionsFactory::get<Gl>(&context);
    QOpenGLFramebufferObjectFormat format;
    format.setSamples(openGlSupport().samples);
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    Bench bench{gl,
                {},
                {},
                makeState(file),
                std::make_unique<QOpenGLFramebufferObject>(frameSize, format),
                std::make_unique<QOpenGLFramebufferObject>(frameSize)};
    if (!bench.plain.initialize(gl, *bench.state.paint(0).levels) || !bench.painted.initialize(gl)) return 1;
    benchmark::AddCustomContext("renderer", reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER)));
    benchmark::AddCustomContext("samples", std::to_string(openGlSupport().samples));
    registerFrames(bench);
    benchmark::RunSpecifiedBenchmarks();
    bench.painted.release(gl);
    return 0;
}

}  // namespace

}  // namespace chiaro::widgets

int main(int argc, char** argv) {
    QGuiApplication app(argc, argv);
    benchmark::Initialize(&argc, argv);
    return chiaro::widgets::run(argc > 1 ? std::filesystem::path(argv[1])
                                         : chiaro::test::resource("demo/meshes/skull.glb"));
}
