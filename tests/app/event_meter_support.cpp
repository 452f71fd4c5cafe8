#include "tests/app/event_meter_support.h"

#include <QtWidgets>

#include <ctime>

namespace chiaro::test {

namespace {

/// Events in which a window with an OpenGL view puts its picture together, or the view draws.
bool isDrawing(const QObject* receiver, const QEvent& event) {
    if (receiver->inherits("QOpenGLWidget")) return true;
    return event.type() == QEvent::UpdateRequest || event.type() == QEvent::Expose;
}

QString nameOf(const QObject* receiver, const QEvent& event) {
    return QString("%1 of %2 %3")
        .arg(QDebug::toString(event.type()), receiver->metaObject()->className(), receiver->objectName());
}

void keep(MeteredApplication::Hold& longest, double milliseconds, const QString& what) {
    if (milliseconds > longest.milliseconds) longest = {milliseconds, what};
}

}  // namespace

double threadMilliseconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

MeteredApplication::Outer::Outer(MeteredApplication& application, QString what)
    : m_application(application),
      m_what(std::move(what)),
      m_isOutermost(application.m_depth++ == 0),
      m_begin(threadMilliseconds()) {
    if (m_isOutermost) m_application.m_drawn = 0;
}

MeteredApplication::Outer::~Outer() {
    --m_application.m_depth;
    if (!m_isOutermost) return;
    const double held = threadMilliseconds() - m_begin;
    keep(m_application.m_longest, held - m_application.m_drawn, m_what);
    keep(m_application.m_longestDrawing, m_application.m_drawn, m_what);
}

void MeteredApplication::reset() {
    m_longest = m_longestDrawing = {};
}

bool MeteredApplication::notify(QObject* receiver, QEvent* event) {
    // Threads of their own have events too.
    if (QThread::currentThread() != thread()) return QApplication::notify(receiver, event);
    const Outer outer(*this, m_depth == 0 ? nameOf(receiver, *event) : QString());
    if (m_isDrawing && event->type() == QEvent::Paint && !isDrawing(receiver, *event)) {
        const double begin = threadMilliseconds();
        const bool result = QApplication::notify(receiver, event);
        m_painted += threadMilliseconds() - begin;
        return result;
    }
    if (m_isDrawing || !isDrawing(receiver, *event)) return QApplication::notify(receiver, event);
    return notifyDrawing(receiver, event);
}

bool MeteredApplication::notifyDrawing(QObject* receiver, QEvent* event) {
    m_isDrawing = true;
    m_painted = 0;
    const double begin = threadMilliseconds();
    const bool result = QApplication::notify(receiver, event);
    m_drawn += threadMilliseconds() - begin - m_painted;
    m_isDrawing = false;
    return result;
}

}  // namespace chiaro::test
