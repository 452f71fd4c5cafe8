#pragma once

#include "widgets/viewport/viewport.h"

namespace chiaro::test {

/// A sphere of radius 1 around the origin with smooth normals, the front outside.
scene::Mesh sphereMesh(int segments = 48);
/// A square of side 2 in the xy plane, the front towards +Z.
scene::Mesh squareMesh();

/// One object with this mesh, lit from the upper left.
scene::Scene sceneOf(scene::Mesh mesh, const std::string& name = "object");

/// Differences that vary in x, y and from level to level, made from sines and noise; they tile.
std::shared_ptr<const synthesis::LevelStack> generatedLevels(int count = 8, int size = 128);
/// Dark blue to warm white, curved.
gradient::Gradient generatedGradient(int width = 400);

/// Mean absolute difference of the channels, in steps of 1/255, over the pixels for which `inside` holds.
double meanDifference(const QImage& a, const QImage& b, const std::function<bool(int, int)>& inside);
/// The same over the whole pictures; 255 when their sizes differ.
double meanDifference(const QImage& a, const QImage& b);

/// What core's renderer makes of a state of the viewport, and where an object covers whole pixels.
struct Reference {
    QImage picture;
    Image<std::uint8_t> inside;
};
Reference referencePicture(const scene::Scene& scene, const scene::Camera& camera,
                           const std::vector<widgets::ViewportPaint>& paints,
                           const std::vector<methods::TexturePlacement>& placements,
                           const methods::ViewAlignedParams& params, glm::vec3 background, QSize pixels);

/// What core's renderer makes of a state by the image-based method, with generated paint of one strip for
/// every object; and the texture that it made, for the viewport.
struct ImageBasedReference {
    Reference reference;
    std::shared_ptr<const widgets::ViewTexture> texture;
};
ImageBasedReference imageBasedPicture(const scene::Scene& scene, const scene::Camera& camera,
                                      const gradient::Gradient& gradient, glm::vec3 background, QSize pixels);

/// An object with small textures of its own views that look different from view to view; not quilted, so
/// quick to make.
std::shared_ptr<const methods::PaintedObject> paintedObject(const std::shared_ptr<const scene::Mesh>& mesh,
                                                            const views::ViewParams& params);
/// What core's renderer makes of a state by the view-dependent method.
Reference viewDependentPicture(const scene::Scene& scene, const scene::Camera& camera,
                               const std::vector<std::shared_ptr<const methods::PaintedObject>>& painted,
                               const gradient::Gradient& gradient, const methods::ViewDependentParams& params,
                               glm::vec3 background, QSize pixels);

/// A core picture as the viewport would give it.
QImage toQImage(const ColorImage& picture);

/// Keeps a picture where $CHIARO_TEST_PICTURES says, to be looked at.
void keepPicture(const QImage& picture, const QString& name);

}  // namespace chiaro::test
