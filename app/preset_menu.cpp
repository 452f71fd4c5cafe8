#include "app/preset_menu.h"

#include "core/base/error.h"
#include "widgets/picture.h"
#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::app {

namespace fs = std::filesystem;

namespace {

constexpr QSize swatchSize(32, 16);

QIcon swatch(const gradient::ColorPath& path, double ratio) {
    QPixmap pixmap(swatchSize * ratio);
    pixmap.setDevicePixelRatio(ratio);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRect({0, 0}, swatchSize), widgets::toImage(path.sampled(64)));
    return pixmap;
}

/// In menus an ampersand marks a key.
QString menuText(const std::string& name) {
    return QString::fromStdString(name).replace('&', "&&");
}

}  // namespace

PresetMenu::PresetMenu(project::PresetKind kind, fs::path folder,
                       std::function<std::optional<project::Preset>()> current,
                       std::function<bool(const project::Preset&)> shows)
    : m_kind(kind), m_folder(std::move(folder)), m_current(std::move(current)), m_shows(std::move(shows)) {
    setObjectName("presets-menu");
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &PresetMenu::rebuild);
    rebuild();
}

QToolButton* PresetMenu::makeButton() {
    auto* button =
        widgets::makeToolButton("presets", tr("Presets"), tr("Presets: apply, save, rename, remove"));
    setParent(button, windowFlags());
    button->setMenu(this);
    button->setPopupMode(QToolButton::InstantPopup);
    return button;
}

fs::path PresetMenu::standardFolder(project::PresetKind kind) {
    static constexpr std::array names{"gradients", "methods", "view-plans"};
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return fs::path(data.toStdString()) / "presets" / names[std::size_t(kind)];
}

void PresetMenu::rebuild() {
    clear();
    qDeleteAll(findChildren<QMenu*>(Qt::FindDirectChildrenOnly));
    std::vector<project::ListedPreset> listed = project::listPresets(m_folder, m_kind);
    std::erase_if(listed, [this](const project::ListedPreset& one) {
        return one.preset && m_shows && !m_shows(*one.preset);
    });
    for (const project::ListedPreset& one : listed) addPreset(one);
    if (listed.empty()) addAction(tr("No presets yet"))->setEnabled(false);
    addSeparator();
    QAction* saving = addAction(widgets::icon("save"), tr("&Save Preset…"), this, &PresetMenu::askToSave);
    saving->setEnabled(m_current().has_value());
    addListMenu(tr("&Rename"), listed, &PresetMenu::askToRename);
    addListMenu(tr("Re&move"), listed, &PresetMenu::askToRemove);
    addAction(widgets::icon("open"), tr("&Open Folder"), this, &PresetMenu::openFolder)
        ->setToolTip(tr("Presets are shared by copying the files that are there"));
}

void PresetMenu::addPreset(const project::ListedPreset& listed) {
    QAction* action = addAction(menuText(listed.name));
    if (!listed.preset) {
        const QString problem = QString::fromStdString(listed.problem);
        action->setIcon(widgets::icon("error"));
        action->setToolTip(problem);
        connect(action, &QAction::triggered, this, [this, problem] { Q_EMIT failed(problem); });
        return;
    }
    if (const auto* path = std::get_if<gradient::ColorPath>(&*listed.preset))
        action->setIcon(swatch(*path, devicePixelRatioF()));
    connect(action, &QAction::triggered, this, [this, preset = *listed.preset] { Q_EMIT chosen(preset); });
}

QMenu* PresetMenu::addListMenu(const QString& title, const std::vector<project::ListedPreset>& listed,
                               void (PresetMenu::*ask)(const QString& name)) {
    QMenu* menu = addMenu(title);
    menu->setEnabled(!listed.empty());
    for (const project::ListedPreset& one : listed)
        connect(menu->addAction(menuText(one.name)), &QAction::triggered, this,
                [this, ask, name = QString::fromStdString(one.name)] { (this->*ask)(name); });
    return menu;
}

void PresetMenu::attempt(const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& problem) {
        Q_EMIT failed(QString::fromStdString(problem.what()));
    }
}

void PresetMenu::save(const QString& name) {
    attempt([&] {
        const std::optional<project::Preset> preset = m_current();
        if (preset) project::writePreset(project::presetFile(m_folder, name.toStdString()), *preset);
    });
}

void PresetMenu::rename(const QString& name, const QString& changed) {
    attempt([&] {
        project::renamePreset(project::presetFile(m_folder, name.toStdString()), changed.toStdString());
    });
}

void PresetMenu::remove(const QString& name) {
    attempt([&] {
        const fs::path file = project::presetFile(m_folder, name.toStdString());
        std::error_code error;
        if (!fs::remove(file, error) || error)
            throw Error(file.string(), "could not be removed", "check that it is there and its folder");
    });
}

void PresetMenu::askToSave() {
    bool isGiven = false;
    const QString name =
        QInputDialog::getText(parentWidget(), tr("Save Preset"), tr("Name"), QLineEdit::Normal, {}, &isGiven)
            .trimmed();
    if (!isGiven) return;
    attempt([&] {
        const fs::path file = project::presetFile(m_folder, name.toStdString());
        std::error_code ignored;
        if (fs::exists(file, ignored) &&
            QMessageBox::question(
                parentWidget(), tr("Save Preset"), tr("%1 is there already. Replace it?").arg(name),
                QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel) != QMessageBox::Yes)
            return;
        save(name);
    });
}

void PresetMenu::askToRename(const QString& name) {
    bool isGiven = false;
    const QString changed = QInputDialog::getText(parentWidget(), tr("Rename Preset"), tr("Name"),
                                                  QLineEdit::Normal, name, &isGiven)
                                .trimmed();
    if (isGiven) rename(name, changed);
}

void PresetMenu::askToRemove(const QString& name) {
    if (QMessageBox::question(
            parentWidget(), tr("Remove Preset"), tr("Remove the preset %1? Its file is deleted.").arg(name),
            QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel) == QMessageBox::Yes)
        remove(name);
}

void PresetMenu::openFolder() {
    std::error_code error;
    fs::create_directories(m_folder, error);
    if (error || !QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(m_folder.string()))))
        Q_EMIT failed(tr("%1: can't be shown; open it in a file manager")
                          .arg(QString::fromStdString(m_folder.string())));
}

}  // namespace chiaro::app
