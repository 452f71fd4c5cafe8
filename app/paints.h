#pragma once

#include "app/change.h"
#include "core/base/image.h"
#include "core/gradient/gradient.h"
#include "core/synthesis/levels.h"
#include "widgets/strip_view.h"

#include <QImage>
#include <QObject>
#include <QTimer>

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace chiaro::app {

class Document;
class JobRunner;
class Memo;
struct JobSpec;

/// A scan as read, and a smaller copy to show.
struct LoadedScan {
    ColorImage image;
    QImage picture;

    /// Throws Error.
    static LoadedScan read(const std::filesystem::path& path);
    std::size_t bytes() const {
        return image.pixelCount() * sizeof(glm::vec3) + std::size_t(picture.sizeInBytes());
    }
};

/// A strip cut from its scan and taken apart.
struct SeparatedStrip {
    std::shared_ptr<const ColorImage> strip;
    gradient::GradientParams params;  ///< that it was separated with
    gradient::Separation separation;  ///< without its texture, which is
    std::shared_ptr<const ColorImage> texture;
    std::shared_ptr<const widgets::StripPictures> pictures;
    std::uint64_t key = 0;  ///< hash of what it comes from
};

/// What becomes of the document's samples: scan, strip and separation, level stack. Each stage is made in the
/// background under the hash of what it comes from, so that nothing is made twice while it is remembered.
///
/// Levels are made only while the document's method uses them. Recolouring is in no stage's hash: it changes
/// the gradient in the same call and synthesises nothing. While the artist drags something that does reach
/// the levels, these wait until the edit is finished or rests.
class Paints : public QObject {
    Q_OBJECT

public:
    /// What is known of one sample so far; null where nothing is.
    struct State {
        std::shared_ptr<const LoadedScan> scan;
        std::shared_ptr<const SeparatedStrip> separated;
        std::shared_ptr<const synthesis::LevelStack> levels;
        bool levelsAreFinal = false;  ///< else coarse, or of parameters that have changed since
    };

    Paints(Document& document, JobRunner& jobs, Memo& memo, QObject* parent = nullptr);

    /// A state for every sample of the document.
    const State& state(int sample) const { return m_states[std::size_t(sample)].shown; }
    int sampleCount() const { return int(m_states.size()); }
    /// The colours that the sample shows now: its recolouring, or its own gradient; empty while unknown.
    gradient::Gradient gradient(int sample) const;
    /// True while the sample is read or separated.
    bool isSeparating(int sample) const;
    /// How many level stacks were begun, coarse ones included.
    int synthesisCount() const { return m_synthesisCount; }

    /// Hands over a scan that is already read, so that it isn't read again.
    void remember(const std::filesystem::path& path, LoadedScan scan);

public Q_SLOTS:
    /// Makes again what was cancelled or failed.
    void retry();

Q_SIGNALS:
    void scanChanged(int sample);
    void separationChanged(int sample);
    void gradientChanged(int sample);
    void levelsChanged(int sample);

private:
    struct Keys {
        std::uint64_t scan = 0;
        std::uint64_t strip = 0;
        std::uint64_t separation = 0;
        std::uint64_t levels = 0;
        std::uint64_t coarseLevels = 0;
    };
    struct Entry {
        State shown;
        Keys shownKeys;                  ///< of what is shown, so that it needn't be remembered besides
        std::uint64_t levelsInWork = 0;  ///< key of the stack that is being made
    };

    void applyChange(Change change);
    void refreshAll();
    void refresh(int sample);
    void refreshLevels(int sample, const Keys& keys);
    bool showScan(int sample, const Keys& keys);
    bool showSeparation(int sample, const Keys& keys);
    void readScan(int sample, const Keys& keys);
    void separate(int sample, const Keys& keys);
    void synthesise(int sample, std::uint64_t key, const synthesis::LevelParams& params, bool isFinal);
    void setSeparation(int sample, std::uint64_t key, std::shared_ptr<const SeparatedStrip> separated);
    void setLevels(int sample, std::uint64_t key, std::shared_ptr<const synthesis::LevelStack> levels,
                   bool isFinal);
    JobSpec spec(const QString& title, const char* stage, int sample, std::uint64_t key);
    Keys keysOf(int sample);
    std::uint64_t fileKey(const std::filesystem::path& path);
    bool gaveUp(std::uint64_t key) const { return m_givenUp.contains(key); }
    QString title(const QString& format, int sample) const;

    Document& m_document;
    JobRunner& m_jobs;
    Memo& m_memo;
    std::vector<Entry> m_states;
    std::set<std::uint64_t> m_givenUp;  ///< cancelled or failed; not tried again by itself
    std::map<std::filesystem::path, std::uint64_t> m_fileKeys;
    QTimer m_rest;  ///< an edit that pauses this long gets its levels though it isn't finished
    int m_synthesisCount = 0;
};

}  // namespace chiaro::app
