#include "core/project/mesh_export.h"

#include "core/base/error.h"
#include "core/export/surface_paint.h"
#include "core/export/view_pictures.h"
#include "core/project/render_method.h"

#include <algorithm>
#include <chrono>

namespace chiaro::project {

const ParameterTable<MeshExportParams>& MeshExportParams::table() {
    static const auto table =
        ParameterTable<MeshExportParams>()
            .add(&MeshExportParams::atlas,
                 ParameterSpec::integer(
                     "atlas", "Atlas", "px", 64, 8192,
                     "The texture's side: as many pixels hold the paint of the whole mesh."))
            .add(
                &MeshExportParams::padding,
                ParameterSpec::integer("padding", "Padding", "px", 0, 64,
                                       "Between the parts of the texture, so that small versions of it don't "
                                       "mix them; less where there are too many parts."))
            .add(
                &MeshExportParams::bake,
                ParameterSpec::choice("bake", "Bake", {"lit", "texture"},
                                      "lit: the colours as they are in the scene's light. texture: the paint "
                                      "in an even middle light, for a renderer with lights of its own."))
            .add(&MeshExportParams::dilate,
                 ParameterSpec::boolean("dilate", "Dilate",
                                        "Let the parts of the texture grow until they meet; off leaves black "
                                        "between them."));
    return table;
}

namespace {

using exporting::Bake;
using exporting::MeshFormat;

/// The visible part of a scene, with what its objects wear and the views that paint them.
class MeshPainter {
public:
    MeshPainter(const Project& project, const scene::Scene& scene, const WornPaints& worn,
                const MeshExportParams& params)
        : m_project(project), m_params(params) {
        m_scene.lights = scene.lights;
        m_scene.occlusion = scene.occlusion;
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            if (!scene.objects[i].visible || !scene.objects[i].mesh) continue;
            m_scene.objects.push_back(scene.objects[i]);
            m_worn.push_back(worn[i]);
            m_places.push_back(i);
        }
        if (m_scene.objects.empty())
            throw Error("scene", "shows no object", "make at least one object visible");
    }

    ExportedMesh paint(const scene::Scene& scene, MeshFormat format, const Task& task) {
        auto begin = std::chrono::steady_clock::now();
        const auto lap = [&begin] {
            const auto now = std::chrono::steady_clock::now();
            return std::chrono::duration<double>(now - std::exchange(begin, now)).count();
        };
        ExportedMesh result;
        result.scene.bake = m_params.bake;
        const exporting::SurfaceLight light(m_scene, m_params.bake, task.part(0, 0.05));
        prepareObjects(scene, light, task.part(0.05, 0.4));
        const auto meeting = renderMethod(m_project.method).usesViews ? exporting::Meeting::Agreed
                                                                      : exporting::Meeting::Pictures;
        const exporting::SurfacePaint paint(light, paints(), m_project.viewDependent, meeting);
        if (format == MeshFormat::Ply) {
            colorVertices(paint, result, task.part(0.4, 1));
            result.bakeSeconds = lap();
            return result;
        }
        result.bakeSeconds = lap();
        const exporting::Atlas atlas = makeAtlas(task.part(0.4, 0.6));
        result.report = atlas.report;
        for (std::size_t i = 0; i < m_scene.objects.size(); ++i)
            result.scene.objects.push_back(
                exporting::withCoordinates(m_scene.objects[i], atlas.objects[i], atlas.size));
        result.atlasSeconds = lap();
        result.scene.texture = exporting::bakeAtlas(
            atlas,
            [&paint](std::size_t object, std::uint32_t face, glm::vec2 place) {
                return paint.color(object, face, place);
            },
            {samplesFor(atlas), m_params.dilate}, task.part(0.6, 1));
        result.bakeSeconds += lap();
        return result;
    }

private:
    /// Views and their textures, of the methods that have none of their own too.
    void prepareObjects(const scene::Scene& scene, const exporting::SurfaceLight& light, const Task& task) {
        const double share = 1 / double(m_worn.size());
        for (std::size_t i = 0; i < m_worn.size(); ++i) {
            const Task part = task.part(share * double(i), share * double(i + 1));
            if (!m_worn[i].views) m_worn[i].views = paintedViews(scene, i, light, part);
            m_painted.push_back(m_worn[i].views);
        }
    }

    std::shared_ptr<const methods::PaintedObject> paintedViews(const scene::Scene& scene, std::size_t i,
                                                               const exporting::SurfaceLight& light,
                                                               const Task& task) {
        auto painted = std::make_shared<methods::PaintedObject>();
        painted->planned = planObject(m_project, scene, m_places[i], task.part(0, 0.3));
        painted->weights =
            std::make_shared<const methods::ViewWeights>(*painted->planned, m_project.views.epsilon);
        painted->textures = exporting::paintViews(
            *painted->planned, *painted->weights, i, light,
            [this](const scene::GBuffer& guide, const Task& part) {
                return renderFrame(m_project, m_worn, guide, part).frame;
            },
            task.part(0.3, 1));
        return painted;
    }

    std::vector<methods::ViewDependentPaint> paints() const {
        std::vector<methods::ViewDependentPaint> paints;
        for (std::size_t i = 0; i < m_worn.size(); ++i)
            paints.push_back({m_painted[i].get(), &m_worn[i].paint->shown, glm::vec3(0)});
        return paints;
    }

    exporting::Atlas makeAtlas(const Task& task) const {
        std::vector<exporting::PlannedPlace> places;
        for (std::size_t i = 0; i < m_scene.objects.size(); ++i)
            places.push_back({m_painted[i]->planned, m_scene.objects[i].transform});
        return exporting::makeAtlas(places, {m_params.atlas, m_params.padding}, task);
    }

    /// One where the views' textures are magnified, more where a texel holds more than one of theirs.
    int samplesFor(const exporting::Atlas& atlas) const {
        double texels = 0, total = 0;  // of the views for a unit of length, by area
        for (std::size_t i = 0; i < m_scene.objects.size(); ++i) {
            const methods::PlannedObject& planned = *m_painted[i]->planned;
            const double scale = scaleOf(m_scene.objects[i]);
            const double area = planned.surface.totalArea() * scale * scale;
            if (planned.plan.groups.empty() || !(scale > 0)) continue;
            texels += area * planned.plan.groups[0].view.texelsPerUnit() / scale;
            total += area;
        }
        if (!(total > 0) || !(atlas.report.densityP5 > 0)) return 1;
        return int(std::clamp(std::ceil(1.25 * texels / total / atlas.report.densityP5), 1.0, 5.0));
    }

    void colorVertices(const exporting::SurfacePaint& paint, ExportedMesh& result, const Task& task) const {
        const double share = 1 / double(m_scene.objects.size());
        for (std::size_t i = 0; i < m_scene.objects.size(); ++i) {
            const scene::Object& object = m_scene.objects[i];
            result.report.faces += object.mesh->triangles.size();
            std::vector<glm::u8vec3> colors = exporting::vertexColors(
                *object.mesh,
                [&](std::uint32_t face, glm::vec2 place) { return paint.color(i, face, place); },
                task.part(share * double(i), share * double(i + 1)));
            result.scene.objects.push_back({object.name,
                                            object.transform,
                                            object.mesh->positions,
                                            object.mesh->normals,
                                            {},
                                            std::move(colors),
                                            object.mesh->triangles});
        }
    }

    const Project& m_project;
    const MeshExportParams& m_params;
    scene::Scene m_scene;                                                  ///< visible objects only
    WornPaints m_worn;                                                     ///< of each
    std::vector<std::size_t> m_places;                                     ///< of each in the whole scene
    std::vector<std::shared_ptr<const methods::PaintedObject>> m_painted;  ///< of each
};

}  // namespace

ExportedMesh paintMesh(const Project& project, const scene::Scene& scene, const WornPaints& worn,
                       MeshFormat format, const MeshExportParams& params, const Task& task) {
    MeshExportParams::table().check(params);
    return MeshPainter(project, scene, worn, params).paint(scene, format, task);
}

}  // namespace chiaro::project
