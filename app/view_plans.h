#pragma once

#include "app/change.h"
#include "core/methods/view_textures.h"
#include "core/scene/scene.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <set>
#include <vector>

namespace chiaro::app {

class Document;
class JobRunner;
class Meshes;
class Memo;

/// An object's views, its faces' groups, and how well they cover it.
struct CoveredPlan {
    std::shared_ptr<const methods::PlannedObject> planned;
    views::CoverageReport coverage;
    std::uint64_t key = 0;  ///< hash of what it comes from: the mesh, the parameters, the placed views

    std::size_t bytes() const;
};

/// The view plans (§4.3.1 to 3) of the visible objects of the document's scene. Made in the background, one
/// after the other, while somebody wants them, and remembered under the hash of what they come from; so an
/// undo finds its plan still there. An object's first plan is begun at once; while the artist drags a view or
/// a parameter, the last one stays until that rests.
class ViewPlans : public QObject {
    Q_OBJECT

public:
    /// The jobs' slot that it plans in.
    static constexpr const char* slot = "view plan";

    ViewPlans(Document& document, JobRunner& jobs, Memo& memo, Meshes& meshes, QObject* parent = nullptr);

    /// The method that is shown may want plans (project::RenderMethod::usesViews), and so may others, such as
    /// a dock while it is visible.
    void setWanted(const QObject* who, bool wanted);
    bool isWanted() const;

    /// The plan of object `object` of Meshes::scene(), null while it is unknown, out of date, or of an object
    /// that is not visible.
    std::shared_ptr<const CoveredPlan> plan(int object) const;
    /// The same, or else the last plan of the same mesh: for pictures, not to work on.
    std::shared_ptr<const CoveredPlan> lastPlan(int object) const;
    int objectCount() const { return int(m_entries.size()); }
    /// How many plans were begun.
    int planCount() const { return m_planCount; }

public Q_SLOTS:
    /// Plans again what was cancelled or failed.
    void retry();

Q_SIGNALS:
    /// What plan() or lastPlan() gives for an object.
    void planChanged(int object);
    /// Another mesh: other objects.
    void objectsChanged();

private:
    struct Entry {
        std::uint64_t key = 0;  ///< of the plan that there should be; 0: of none
        std::shared_ptr<const CoveredPlan> last;
    };

    void applyChange(Change change);
    void refresh();
    std::uint64_t keyOf(int object, const scene::Object& one) const;
    bool isWantedOf(int object) const;
    void follow(int object, const scene::Object& one);
    void startNext();
    void start(int object);
    void take(std::shared_ptr<const CoveredPlan> plan);

    Document& m_document;
    JobRunner& m_jobs;
    Memo& m_memo;
    Meshes& m_meshes;
    std::vector<Entry> m_entries;
    std::uint64_t m_meshKey = 0;  ///< of the objects that the entries are of
    std::set<const QObject*> m_wanting;
    std::set<std::uint64_t> m_givenUp;  ///< cancelled or failed; not tried again by itself
    std::uint64_t m_inWork = 0;         ///< key of the plan that is being made
    QTimer m_rest;
    int m_planCount = 0;
};

}  // namespace chiaro::app
