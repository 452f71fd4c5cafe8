#include "app/exporter.h"

#include "app/animation_dialog.h"
#include "app/animation_export.h"
#include "app/document.h"
#include "app/export_dialog.h"
#include "app/jobs/job_runner.h"
#include "app/mesh_export_dialog.h"
#include "app/meshes.h"
#include "app/object_textures.h"
#include "app/page_export.h"
#include "app/paints.h"
#include "app/playback.h"
#include "app/replace_question.h"
#include "core/export/relightable_page.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

QString nameOf(const std::filesystem::path& path) {
    return QString::fromStdString(path.filename().string());
}

}  // namespace

Exporter::Exporter(Document& document, JobRunner& jobs, Paints& paints, Meshes& meshes,
                   ObjectTextures& textures, Playback& playback, widgets::Viewport& viewport, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_jobs(jobs),
      m_paints(paints),
      m_meshes(meshes),
      m_textures(textures),
      m_playback(playback),
      m_viewport(viewport) {}

PictureSource Exporter::source() const {
    const QSize pixels = m_viewport.pixels();
    PictureSource source{m_document.project(),    m_meshes.scene(), m_viewport.camera(), {},
                         m_viewport.placements(), pixels.width(),   pixels.height()};
    for (int sample = 0; sample < int(source.project.samples.size()); ++sample) {
        const Paints::State& state = m_paints.state(sample);
        source.paints.push_back({state.levelsAreFinal ? state.levels : nullptr, m_paints.gradient(sample)});
    }
    source.scene.lights = m_playback.view().lights;
    const auto textures = m_textures.textures();
    for (int object = 0; object < int(source.scene.objects.size()); ++object)
        source.objectTextures.push_back(m_textures.isFinal(object) ? textures[std::size_t(object)] : nullptr);
    return source;
}

std::filesystem::path Exporter::suggestion(const QString& folder, const char* extension) const {
    return (folder + "/" + m_document.name() + extension).toStdString();
}

void Exporter::exportPicture(const QString& folder) {
    PictureSettings suggested;
    const QSize shown = m_viewport.size() * m_viewport.devicePixelRatioF();
    suggested.width = shown.width();
    suggested.height = shown.height();
    suggested.background = m_viewport.background();
    suggested.path = suggestion(folder, ".png");
    ExportDialog dialog(suggested, m_viewport.window());
    if (dialog.exec() != QDialog::Accepted) return;
    const PictureSettings settings = dialog.settings();
    m_jobs.start(
        {tr("Exporting %1").arg(nameOf(settings.path)), {}, {}, {}},
        [source = source(), settings](const Task& task) {
            app::exportPicture(source, settings, task);
            return true;
        },
        [this, path = settings.path](bool) {
            Q_EMIT exported(tr("The picture is at %1").arg(QString::fromStdString(path.string())));
        });
}

void Exporter::renderAnimation(const QString& folder) {
    AnimationSettings suggested;
    suggested.output = suggestion(folder, ".####.png");
    suggested.background = m_viewport.background();
    AnimationDialog dialog(m_document.project().animation, suggested, m_viewport.window());
    if (dialog.exec() != QDialog::Accepted) return;
    const AnimationSettings settings = dialog.settings();
    m_jobs.start(
        {tr("Rendering %1").arg(nameOf(settings.output)), {}, {}, {}},
        [project = m_document.project(), scene = m_meshes.scene(), settings](const Task& task) {
            exportAnimation(project, scene, settings, task);
            return true;
        },
        [this, path = settings.output](bool) {
            Q_EMIT exported(tr("The animation is at %1").arg(QString::fromStdString(path.string())));
        });
}

void Exporter::exportMesh(const QString& folder) {
    MeshExportDialog dialog({suggestion(folder, ".glb"), {}}, m_viewport.window());
    if (dialog.exec() != QDialog::Accepted) return;
    const MeshSettings settings = dialog.settings();
    m_jobs.start(
        {tr("Exporting %1").arg(nameOf(settings.path)), {}, {}, {}},
        [source = source(), settings](const Task& task) { return app::exportMesh(source, settings, task); },
        [this, settings](const exporting::AtlasReport& report) {
            QString note =
                tr("The painted mesh is at %1").arg(QString::fromStdString(settings.path.string()));
            if (report.charts > 0 && report.padding < settings.params.padding)
                note += tr(" · its texture has so many parts that they lie %1 px apart").arg(report.padding);
            Q_EMIT exported(note);
        });
}

void Exporter::exportPage(const QString& folder) {
    QFileDialog dialog(m_viewport.window(), tr("Export Relightable Page"), folder, tr("Web pages (*.html)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOption(QFileDialog::DontConfirmOverwrite);  // the name may still get its extension
    dialog.selectFile(nameOf(suggestion(folder, ".html")));
    if (dialog.exec() != QDialog::Accepted) return;
    std::filesystem::path path = dialog.selectedFiles().front().toStdString();
    if (!exporting::isPage(path)) path += ".html";
    if (!mayReplace(dialog, {path})) return;
    m_jobs.start(
        {tr("Exporting %1").arg(nameOf(path)), {}, {}, {}},
        [source = source(), path](const Task& task) {
            app::exportPage(source, path, task);
            return true;
        },
        [this, path](bool) {
            Q_EMIT exported(
                tr("The page is at %1 · open it in any browser").arg(QString::fromStdString(path.string())));
        });
}

}  // namespace chiaro::app
