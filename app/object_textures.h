#pragma once

#include "app/change.h"
#include "core/methods/view_dependent.h"
#include "core/project/texture_cache.h"

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
class Paints;
class ViewPlans;
struct SeparatedStrip;

/// The textures of the visible objects' own views (§4.3), while the document's method is that. Made in the
/// background, one object at a time: of all objects first a coarse one, whose maps and strokes have a quarter
/// of the texels a side, then the fine one. Until there is a newer one an object's last texture stays.
///
/// Each is remembered under the hash of what it comes from: the plan, the separated strip, how levels are
/// made, and whether textures propagate. Recolouring, the lights and the camera are in no hash and begin
/// nothing. While the artist drags something that is, fine textures wait until that rests.
class ObjectTextures : public QObject {
    Q_OBJECT

public:
    ObjectTextures(Document& document, JobRunner& jobs, Memo& memo, Paints& paints, Meshes& meshes,
                   ViewPlans& plans, QObject* parent = nullptr);

    using Painted = std::shared_ptr<const methods::PaintedObject>;
    /// One an object of Meshes::scene(); null where nothing is there yet.
    std::vector<Painted> textures() const;
    /// Of an object: false while its texture is coarse, of something else, or not there. True for an object
    /// that needs none.
    bool isFinal(int object) const;
    /// Of all objects.
    bool isFinal() const;
    /// How many syntheses were begun, and how many of them were coarse.
    int synthesisCount() const { return m_synthesisCount; }
    int coarseCount() const { return m_coarseCount; }

    /// Where fine textures are kept from one run to the next; nowhere without.
    void setCache(std::shared_ptr<const project::TextureCache> cache) { m_cache = std::move(cache); }
    const std::shared_ptr<const project::TextureCache>& cache() const { return m_cache; }

public Q_SLOTS:
    /// Makes again what was cancelled or failed.
    void retry();

Q_SIGNALS:
    void texturesChanged();

private:
    struct Entry {
        std::uint64_t fineKey = 0;    ///< of the texture that there should be; 0 while that is unknown
        std::uint64_t coarseKey = 0;  ///< of its coarse one; 0 when maps are small as they are
        bool isNeeded = false;        ///< visible, and painted
        Painted shown;
        std::uint64_t shownKey = 0;
    };
    struct Inputs;

    void applyChange(Change change);
    void refresh();
    void follow(int object);
    bool isWanted() const;
    std::uint64_t keyOf(int object, bool isCoarse) const;
    std::shared_ptr<const SeparatedStrip> stripOf(int object) const;
    void startNext();
    void start(int object, bool isCoarse);
    void take(std::uint64_t key, const Painted& painted);

    Document& m_document;
    JobRunner& m_jobs;
    Memo& m_memo;
    Paints& m_paints;
    Meshes& m_meshes;
    ViewPlans& m_plans;
    std::shared_ptr<const project::TextureCache> m_cache;
    std::vector<Entry> m_entries;
    std::uint64_t m_meshKey = 0;        ///< of the objects that the entries are of
    std::set<std::uint64_t> m_givenUp;  ///< cancelled or failed; not tried again by itself
    std::uint64_t m_inWork = 0;         ///< key of the texture that is being made
    QTimer m_rest;
    int m_synthesisCount = 0;
    int m_coarseCount = 0;
};

}  // namespace chiaro::app
