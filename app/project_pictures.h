#pragma once

#include <QIcon>
#include <QImage>
#include <QObject>

#include <filesystem>

namespace chiaro::widgets {
class Viewport;
}

namespace chiaro::app {

class Document;
class JobRunner;

/// Small pictures of projects in the user's cache folder, by which artists know them again: what the viewport
/// shows when a project is saved, and once all of it is there after it was opened or saved.
class ProjectPictures : public QObject {
    Q_OBJECT

public:
    ProjectPictures(Document& document, JobRunner& jobs, const widgets::Viewport& viewport, QObject* parent);

    static constexpr QSize size{56, 35};
    /// Where a project's picture is.
    static QString file(const QString& project);
    /// Null when there is none.
    static QImage find(const QString& project);
    /// Middle of the picture, in the right shape. Failing is no error.
    static void keep(const QString& project, const QImage& picture);

public Q_SLOTS:
    /// Keeps what the viewport shows at once, where that takes no more than a frame.
    void keepShown();

private:
    void take();

    Document& m_document;
    JobRunner& m_jobs;
    const widgets::Viewport& m_viewport;
    bool m_isDue = false;  ///< the project was opened or saved and isn't kept yet
};

}  // namespace chiaro::app
