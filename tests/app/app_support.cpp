#include "tests/app/app_support.h"

#include "core/base/atomic_file.h"
#include "core/base/image_io.h"
#include "core/base/random.h"

#include <QtTest>
#include <QtWidgets>

namespace chiaro::test {

std::filesystem::path writeStrip(const std::filesystem::path& path, int width, int height) {
    ColorImage strip(width, height);
    Random random(7);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float light = float(x) / float(width - 1);
            const glm::vec3 color =
                glm::mix(glm::vec3(0.15F, 0.1F, 0.3F), glm::vec3(0.9F, 0.85F, 0.6F), light);
            strip(x, y) = color + float(random.uniform() - 0.5) * 0.15F;
        }
    writeImage(path, strip);
    return path;
}

std::filesystem::path writeTetrahedron(const std::filesystem::path& path, const std::string& name) {
    writeFileAtomically(path, "o " + name +
                                  "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                  "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    return path;
}

Studio::Studio() {
    project::Project project;
    project.levels.size = 64;
    project.levels.count = 4;
    project.levels.quilt.block = 16;
    document.replace(project, {}, {});
    const auto keep = [this](const QString& message) { errors.push_back(message); };
    QObject::connect(&jobs, &app::JobRunner::failed, &document, keep);
    QObject::connect(&opener, &app::Opener::failed, &document, keep);
}

bool Studio::settle() {
    return QTest::qWaitFor([this] { return jobs.isIdle(); }, 60'000);
}

bool Studio::open(const std::vector<std::filesystem::path>& paths) {
    QStringList names;
    for (const auto& path : paths) names << QString::fromStdString(path.string());
    opener.open(names);
    return settle();
}

Watchdog::Watchdog() {
    m_heart.setInterval(1);
    QObject::connect(&m_heart, &QTimer::timeout, &m_heart,
                     [this] { m_longest = std::max(m_longest, m_beat.restart()); });
    m_beat.start();
    m_heart.start();
}

void answerNext(QMessageBox::StandardButton answer, bool& asked) {
    asked = false;
    auto* looks = new QTimer(qApp);
    looks->start(50);
    QObject::connect(looks, &QTimer::timeout, looks, [answer, &asked, looks, left = 100]() mutable {
        auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (question == nullptr && --left > 0) return;
        looks->deleteLater();
        asked = question != nullptr;
        if (asked) question->button(answer)->click();
    });
}

bool asksBeforeItReplaces(QDialog& dialog) {
    dialog.show();
    bool askedFirst = false, askedAgain = false;
    answerNext(QMessageBox::Cancel, askedFirst);
    dialog.accept();
    const bool stayed = dialog.result() == 0 && dialog.isVisible();
    answerNext(QMessageBox::Yes, askedAgain);
    dialog.accept();
    return askedFirst && stayed && askedAgain && dialog.result() == QDialog::Accepted;
}

project::Project withoutCamera(project::Project project) {
    project.camera = {};
    project.frameCamera = true;
    return project;
}

}  // namespace chiaro::test
