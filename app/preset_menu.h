#pragma once

#include "core/project/presets.h"

#include <QMenu>

#include <filesystem>
#include <functional>
#include <optional>

class QToolButton;

namespace chiaro::app {

/// The presets of one kind that the artist keeps, a file each: choosing one asks for it to be applied; the
/// one at hand can be saved, others renamed and removed. Files that are no such presets stand among them and
/// say what is wrong when they are chosen.
class PresetMenu : public QMenu {
    Q_OBJECT

public:
    /// `current` gives what would be saved, or nothing. `shows` tells which presets are listed; all without.
    PresetMenu(project::PresetKind kind, std::filesystem::path folder,
               std::function<std::optional<project::Preset>()> current,
               std::function<bool(const project::Preset&)> shows = {});

    /// A button that opens the menu, which belongs to it.
    QToolButton* makeButton();
    const std::filesystem::path& folder() const { return m_folder; }

    /// Where the artist's presets of a kind are, in the user's data folder.
    static std::filesystem::path standardFolder(project::PresetKind kind);

public Q_SLOTS:
    /// Saves the one at hand; one that has the name already is replaced. Tells when that fails.
    void save(const QString& name);
    void rename(const QString& name, const QString& changed);
    void remove(const QString& name);

Q_SIGNALS:
    void chosen(const chiaro::project::Preset& preset);
    /// A sentence.
    void failed(const QString& message);

private:
    void rebuild();
    void addPreset(const project::ListedPreset& listed);
    QMenu* addListMenu(const QString& title, const std::vector<project::ListedPreset>& listed,
                       void (PresetMenu::*ask)(const QString& name));
    void askToSave();
    void askToRename(const QString& name);
    void askToRemove(const QString& name);
    void openFolder();
    /// Tells what goes wrong in it.
    void attempt(const std::function<void()>& work);

    project::PresetKind m_kind;
    std::filesystem::path m_folder;
    std::function<std::optional<project::Preset>()> m_current;
    std::function<bool(const project::Preset&)> m_shows;
};

}  // namespace chiaro::app
