#pragma once

#include "app/change.h"
#include "core/project/objects.h"
#include "core/project/presets.h"

#include <QObject>
#include <QUndoStack>

#include <filesystem>
#include <functional>

namespace chiaro::project {
struct RenderMethod;
}

namespace chiaro::app {

/// The project that is open, and its history. Needs no window.
///
/// Every edit is a command on the undo stack; edits of one value until finishEdit() are one step. The camera
/// is kept but is no edit: looking around changes nothing that is worth undoing or saving by itself.
///
/// While a change is told nothing can be edited, for it would come before its cause in the history: a field
/// that loses the focus then, with something half typed in it, is shown what is true.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    const project::Project& project() const { return m_project; }
    QUndoStack& undoStack() { return m_undo; }
    bool isModified() const { return !m_undo.isClean(); }
    /// Where it was last saved or read; empty when it never was.
    const std::filesystem::path& path() const { return m_path; }
    /// "oil study" of oil study.chiaro; "Untitled" without a path.
    QString name() const;

    /// Of a project whose file says more than this program knows: it is saved elsewhere only.
    bool isReadOnly() const { return m_isReadOnly; }

    /// Another project, with a history of its own. `names` are those of the objects in its mesh files: every
    /// object of the scene gets settings, in the scene's order.
    void replace(project::Project project, const std::filesystem::path& path,
                 const project::ObjectNames& names);
    /// To be called right after the project was replaced.
    void setReadOnly();
    /// A project that was recovered after a crash: as replace(), but modified from the start.
    void recover(project::Project project, const std::filesystem::path& path,
                 const project::ObjectNames& names);
    /// Keeps what the file was as a backup. Throws Error, as when a project of a newer format is there; the
    /// document then stays modified.
    void save(const std::filesystem::path& path);

    void editStrip(int sample, const sample::StripParams& params);
    void editGradient(int sample, const gradient::GradientParams& params);
    void editRecoloring(int sample, const std::optional<gradient::ColorPath>& path);
    void editLevels(const synthesis::LevelParams& params);
    /// The key of a project::RenderMethod.
    void editMethod(const std::string& key);
    void editImageBased(const methods::ImageBasedParams& params);
    void editCoherence(const methods::CoherenceParams& params);
    void editViewAligned(const methods::ViewAlignedParams& params);
    void editViewDependent(const methods::ViewDependentParams& params);
    void editOcclusion(const scene::OcclusionParams& params);

    /// Turns or moves a light.
    void editLight(int light, glm::vec3 vector);
    /// Of the lights that there are, or with `text` for another number of them.
    void editLights(const std::vector<scene::Light>& lights, const QString& text);
    /// All that a preset says, in one step.
    void applyPreset(const project::MethodPreset& preset);
    /// To an object of the scene.
    void applyPreset(int object, const project::ViewPlanPreset& preset);
    void editAnimation(const project::Animation& animation, const QString& text);

    /// Settings of the same objects of the scene, in its order. Names stay unique: one that is taken gets a
    /// number.
    void editObjects(std::vector<project::ObjectSettings> objects, const QString& text);
    /// Takes objects out of the scene, and out of the project mesh files none of whose objects is left.
    void removeObjects(const std::vector<int>& objects);
    /// Puts a copy after each of these objects; returns the copies.
    std::vector<int> duplicateObjects(const std::vector<int>& objects);
    void editViews(const views::ViewParams& params);

    /// The views that the artist placed on an object of the scene.
    const std::vector<project::PlacedView>& placedViews(int object) const;
    /// Places a view from where there was none; returns its index.
    int addView(int object, const project::PlacedView& view);
    /// Places a view where planning put one, so that it stays; returns its index.
    int lockView(int object, const project::PlacedView& view);
    void moveView(int object, int view, const project::PlacedView& moved);
    void removeView(int object, int view);

    /// Adds a sample and puts it on the objects that wear `instead`, or on all when there was none. Returns
    /// its index.
    int addSample(const project::Sample& sample, int instead);
    void renameSample(int sample, const std::string& name);
    /// Objects that wore it wear the first that is left.
    void removeSample(int sample);
    /// Puts the sample on all objects.
    void wearEverywhere(int sample);
    /// Another mesh in place of all there are; its objects wear the sample.
    void setMesh(const std::filesystem::path& path, const std::vector<std::string>& objectNames, int sample);
    /// One more mesh; its objects wear the sample. Returns the first of them in the scene.
    int addMesh(const std::filesystem::path& path, const std::vector<std::string>& objectNames, int sample);

    /// The methods that are compared with each other where the project's own is not shown alone; none when it
    /// is. What is looked at, so no edit, and not saved.
    void setComparedMethods(std::vector<std::string> keys);
    /// Whether a method is shown, and so what it needs is to be made.
    bool shows(std::string_view method) const;
    /// Whether one that needs something is: `need` is usesLevels or usesViews.
    bool shows(bool project::RenderMethod::*need) const;

    /// Ends a drag or dialog: the next edit is another step. Tells editFinished().
    void finishEdit();
    /// True from the first edit of a drag or dialog to finishEdit().
    bool isEditing() const { return m_editing; }

    void setCamera(const scene::Camera& camera);
    /// True when an object of the mesh shows the sample.
    bool isWorn(int sample) const;

Q_SIGNALS:
    void changed(chiaro::app::Change change);
    void editFinished();
    void pathChanged();
    void modifiedChanged(bool modified);

private:
    friend class ProjectCommand;

    /// Samples, meshes and who wears what change together.
    struct Contents {
        std::vector<project::Sample> samples;
        std::vector<project::MeshFile> meshes;
        std::vector<project::ObjectSettings> objects;
        friend bool operator==(const Contents&, const Contents&) = default;
    };
    Contents contents() const;
    void editContents(Change::Kind kind, const QString& text, const Contents& contents);

    /// Edits that are one step.
    void editTogether(const QString& text, const std::function<void()>& edits);
    void editPlacedViews(int object, const QString& text, std::vector<project::PlacedView> views);

    template <class Value, class Member>
    void edit(Change change, const QString& text, Member member, const Value& value);

    project::Project m_project;
    std::filesystem::path m_path;
    QUndoStack m_undo;
    std::vector<std::string> m_comparedMethods;
    int m_session = 0;
    bool m_editing = false;
    bool m_isReadOnly = false;
    bool m_isTelling = false;  ///< of a change
};

}  // namespace chiaro::app
