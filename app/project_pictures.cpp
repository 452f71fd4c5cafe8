#include "app/project_pictures.h"

#include "app/document.h"
#include "app/jobs/job_runner.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "widgets/viewport/viewport.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

constexpr int pixelsAPoint = 2;          ///< sharp on a dense screen
constexpr int settleMilliseconds = 400;  ///< until the last results have reached the picture
constexpr std::uintmax_t largestFile = 1 << 20;

}  // namespace

ProjectPictures::ProjectPictures(Document& document, JobRunner& jobs, const widgets::Viewport& viewport,
                                 QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_viewport(viewport) {
    auto* settled = new QTimer(this);
    settled->setSingleShot(true);
    settled->setInterval(settleMilliseconds);
    const auto wait = [this, settled] {
        if (m_isDue && m_jobs.isIdle()) settled->start();
    };
    connect(&document, &Document::pathChanged, this, [this, wait] {
        m_isDue = !m_document.path().empty();
        wait();
    });
    connect(&jobs, &JobRunner::idle, this, wait);
    connect(settled, &QTimer::timeout, this, [this] {
        if (m_isDue && m_jobs.isIdle()) take();
    });
}

void ProjectPictures::keepShown() {
    // The CPU renderer would be waited for.
    if (!m_viewport.usesOpenGl()) return;
    const bool isSettled = m_jobs.isIdle();
    take();
    m_isDue = !isSettled;  // a better one follows
}

void ProjectPictures::take() {
    m_isDue = false;
    if (m_document.path().empty() || !m_viewport.isVisible()) return;
    keep(QString::fromStdString(m_document.path().string()), m_viewport.picture());
}

QString ProjectPictures::file(const QString& project) {
    const QByteArray hash =
        QCryptographicHash::hash(QFileInfo(project).absoluteFilePath().toUtf8(), QCryptographicHash::Sha1);
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/projects/" + hash.toHex() +
           ".png";
}

QImage ProjectPictures::find(const QString& project) {
    try {
        const std::string bytes = readFile(file(project).toStdString(), largestFile);
        return QImage::fromData(QByteArray::fromStdString(bytes), "PNG");
    } catch (const Error&) {
        return {};
    }
}

void ProjectPictures::keep(const QString& project, const QImage& picture) {
    if (picture.isNull()) return;
    const QSize wanted = size * pixelsAPoint;
    const QImage scaled = picture.scaled(wanted, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    const QRect middle(QPoint((scaled.width() - wanted.width()) / 2, (scaled.height() - wanted.height()) / 2),
                       wanted);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!scaled.copy(middle).save(&buffer, "PNG")) return;
    try {
        writeFileAtomically(file(project).toStdString(), bytes.toStdString());
    } catch (const Error&) {
        // The list shows the name alone.
    }
}

}  // namespace chiaro::app
