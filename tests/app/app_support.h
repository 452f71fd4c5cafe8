#pragma once

#include "app/document.h"
#include "app/frame_textures.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/memo.h"
#include "app/meshes.h"
#include "app/object_textures.h"
#include "app/opener.h"
#include "app/paints.h"
#include "app/view_plans.h"
#include "tests/support/support.h"

#include <QElapsedTimer>
#include <QMessageBox>
#include <QTimer>

#include <filesystem>

namespace chiaro::test {

/// A strip from dark to light with brush marks, written to a file.
std::filesystem::path writeStrip(const std::filesystem::path& path, int width = 160, int height = 48);
/// A tetrahedron named `name`, as an OBJ file.
std::filesystem::path writeTetrahedron(const std::filesystem::path& path, const std::string& name);

/// What lies behind the studio's window, without the window.
struct Studio {
    app::Document document;
    app::Memo memo{std::size_t(256) << 20};
    app::JobRunner jobs;
    app::Paints paints{document, jobs, memo};
    app::Meshes meshes{document, jobs, memo};
    app::FrameTextures frameTextures{document, jobs, memo, paints, meshes};
    app::ViewPlans viewPlans{document, jobs, memo, meshes};
    app::ObjectTextures objectTextures{document, jobs, memo, paints, meshes, viewPlans};
    app::Opener opener{document, jobs, paints, meshes};
    std::vector<QString> errors;

    /// Small levels, so that tests are quick.
    Studio();
    /// Waits until nothing runs. False when that takes more than a minute.
    bool settle();
    /// Opens files and waits.
    bool open(const std::vector<std::filesystem::path>& paths);
};

/// The longest time that the thread of windows was held up since this began.
class Watchdog {
public:
    Watchdog();
    qint64 longest() const { return m_longest; }  ///< ms

private:
    QTimer m_heart;
    QElapsedTimer m_beat;
    qint64 m_longest = 0;
};

/// Answers the next question that appears within five seconds; asked, which must live as long, tells whether
/// one did. Of use where a call blocks until it is answered.
void answerNext(QMessageBox::StandardButton answer, bool& asked);

/// True when accepting a dialog whose file is there already asks first, changes nothing after a no, and is
/// done after a yes.
bool asksBeforeItReplaces(QDialog& dialog);

/// The project without its camera, which is no part of the history.
project::Project withoutCamera(project::Project project);

}  // namespace chiaro::test
