#pragma once

#include "app/change.h"
#include "core/project/project.h"

#include <QObject>
#include <QUndoStack>

#include <filesystem>

namespace chiaro::app {

/// The project that is open, and its history. Needs no window.
///
/// Every edit is a command on the undo stack; edits of one value until finishEdit() are one step. The camera
/// is kept but is no edit: looking around changes nothing that is worth undoing or saving by itself.
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

    /// Another project, with a history of its own. `objectNames` are those of its mesh file, which the
    /// project itself does not hold.
    void replace(project::Project project, const std::filesystem::path& path,
                 const std::vector<std::string>& objectNames);
    /// Throws Error; the document then stays modified.
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
    void editLight(int light, glm::vec3 vector);
    void editViews(const views::ViewParams& params);

    /// The views that the artist placed on an object of the mesh file.
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
    /// Objects that wore it wear the first that is left.
    void removeSample(int sample);
    /// Puts the sample on all objects.
    void wearEverywhere(int sample);
    /// Another mesh, all of whose objects wear the sample.
    void setMesh(const std::filesystem::path& path, const std::vector<std::string>& objectNames, int sample);

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

    /// Samples, the mesh and who wears what change together.
    struct Contents {
        std::vector<project::Sample> samples;
        std::filesystem::path mesh;
        std::vector<project::ObjectSettings> objects;
        std::vector<std::string> objectNames;
        friend bool operator==(const Contents&, const Contents&) = default;
    };
    Contents contents() const;
    /// The settings of every object of the mesh, those that the project does not name included.
    std::vector<project::ObjectSettings> allObjects() const;
    void editContents(Change::Kind kind, const QString& text, const Contents& contents);

    void editPlacedViews(int object, const QString& text, std::vector<project::PlacedView> views);

    template <class Value, class Member>
    void edit(Change change, const QString& text, Member member, const Value& value);

    project::Project m_project;
    std::filesystem::path m_path;
    std::vector<std::string> m_objectNames;
    QUndoStack m_undo;
    int m_session = 0;
    bool m_editing = false;
};

}  // namespace chiaro::app
