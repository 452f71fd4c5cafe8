#pragma once

#include "widgets/viewport/method_drawer.h"
#include "widgets/viewport/object_texels.h"

#include <QFuture>

#include <map>

namespace chiaro::widgets {

/// Shades with the textures of the objects' own views (§4.3): a pass an object. An object's textures become
/// texels on another thread, and are uploaded when they are others than in the last frame; until then what it
/// had is shown, if it is of the same mesh.
class ViewDependentDrawer : public MethodDrawer {
public:
    bool initialize(Gl& gl, int samples) override;
    void release(Gl& gl) override;
    bool usesLevels() const override { return false; }
    bool usesFaces() const override { return true; }
    bool sync(Gl& gl, const ViewState& state, GlPaints::Pending pending) override;
    std::vector<Pass> prepare(Gl& gl, const ViewState& state, const GlPaints& paints, QSize pixels) override;
    QOpenGLShaderProgram* bind(Gl& gl, std::size_t pass, const GlPaints& paints) override;

    /// Of all objects in the graphics memory.
    std::size_t textureBytes() const;

private:
    using Painted = std::shared_ptr<const methods::PaintedObject>;
    enum BufferTexture { Corners, FaceViews, Weights, Views, BufferTextureCount };

    /// An object's textures in the graphics memory.
    struct Uploaded {
        GLuint texels = 0;
        std::array<GLuint, BufferTextureCount> buffers{};
        std::array<GLuint, BufferTextureCount> textures{};
        ObjectTexels::Layout layout;
        std::size_t bytes = 0;
    };
    struct Entry {
        Painted shown;  ///< null: none was uploaded
        Uploaded uploaded;
        Painted awaited;                                      ///< whose texels are on their way
        QFuture<std::shared_ptr<const ObjectTexels>> texels;  ///< of those
    };
    /// What the shader is compiled for.
    struct Variant {
        bool isTextured = false;
        bool isPerspective = false;
        bool followsCamera = false;
        bool isPreserving = false;
        int pages = 1;
        auto operator<=>(const Variant&) const = default;
    };
    /// One object for the shader.
    struct Placed {
        Variant variant;
        const Uploaded* uploaded = nullptr;
        QMatrix4x4 objectToClip;
        QVector2D reach;
        QVector3D eye;
    };

    bool finish(Gl& gl, Entry& entry, GlPaints::Pending pending) const;
    static Uploaded upload(Gl& gl, const ObjectTexels& texels);
    static void free(Gl& gl, const Uploaded& uploaded);
    QOpenGLShaderProgram* programFor(const Variant& variant);

    int m_samples = 0;
    int m_largestSide = 0;
    std::map<Variant, std::unique_ptr<QOpenGLShaderProgram>> m_programs;
    /// By mesh and sample, as objects that share both share their textures.
    std::map<std::pair<const scene::Mesh*, int>, Entry> m_entries;
    std::vector<Placed> m_placed;  ///< one a pass
    QVector2D m_pixelSize;
};

}  // namespace chiaro::widgets
