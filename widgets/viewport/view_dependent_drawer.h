#pragma once

#include "widgets/viewport/method_drawer.h"
#include "widgets/viewport/object_upload.h"

#include <QFuture>

#include <map>
#include <optional>

namespace chiaro::widgets {

/// Shades with the textures of the objects' own views (§4.3): a pass an object. An object's textures become
/// texels on another thread, and are uploaded over as many frames as that takes; until then what it had is
/// shown, if it is of the same mesh.
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
    struct Entry {
        Painted shown;  ///< null: none was uploaded
        UploadedObject uploaded;
        Painted awaited;                                               ///< whose texels are on their way
        QFuture<std::shared_ptr<const methods::ObjectTexels>> texels;  ///< of those, while they are made
        std::optional<ObjectUpload> upload;                            ///< and once they are
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
        const UploadedObject* uploaded = nullptr;
        QMatrix4x4 objectToClip;
        QVector2D reach;
        QVector3D eye;
    };

    void await(Gl& gl, Entry& entry, const Painted& painted) const;
    static bool finish(Gl& gl, Entry& entry, GlPaints::Pending pending, QDeadlineTimer deadline);
    static void free(Gl& gl, Entry& entry);
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
