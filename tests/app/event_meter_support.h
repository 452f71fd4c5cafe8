#pragma once

#include <QApplication>

#include <array>

namespace chiaro::test {

/// An application that measures for how long each event holds up the thread of windows: its processor time
/// there, so that other programs on the machine make no difference.
///
/// Drawing by OpenGL is measured apart: with llvmpipe it is the processor that draws, and with a graphics
/// card it is not. What else is painted counts. An event inside another is part of the outer one.
class MeteredApplication : public QApplication {
public:
    using QApplication::QApplication;

    /// The longest of its kind since the last reset.
    struct Hold {
        double milliseconds = 0;
        QString what;  ///< the event and whose it was
    };
    const Hold& longest() const { return m_longest; }
    const Hold& longestDrawing() const { return m_longestDrawing; }
    void reset();

    bool notify(QObject* receiver, QEvent* event) override;

    /// Measures what a test does to the window itself.
    template <class Function>
    void measure(const QString& what, const Function& function) {
        const Outer outer(*this, what);
        function();
    }
    static MeteredApplication& instance() { return static_cast<MeteredApplication&>(*qApp); }

private:
    /// Measures from its beginning to its end.
    class Outer {
    public:
        Outer(MeteredApplication& application, QString what);
        ~Outer();
        Outer(const Outer&) = delete;
        Outer& operator=(const Outer&) = delete;

    private:
        MeteredApplication& m_application;
        QString m_what;
        bool m_isOutermost;
        double m_begin;
    };

    bool notifyDrawing(QObject* receiver, QEvent* event);

    Hold m_longest;
    Hold m_longestDrawing;
    int m_depth = 0;
    bool m_isDrawing = false;
    double m_drawn = 0;    ///< ms of the outermost event that were OpenGL's
    double m_painted = 0;  ///< ms of the drawing event that were not
};

/// Of the calling thread, ms.
double threadMilliseconds();

}  // namespace chiaro::test

/// As QTEST_MAIN, with a MeteredApplication; a test may take a quarter of an hour, as machines have other
/// work.
#define CHIARO_METERED_MAIN(TestObject)                             \
    int main(int argc, char** argv) {                               \
        qputenv("QTEST_FUNCTION_TIMEOUT", "900000");                \
        QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts); \
        chiaro::test::MeteredApplication application(argc, argv);   \
        TestObject test;                                            \
        QTEST_SET_MAIN_SOURCE_PATH                                  \
        return QTest::qExec(&test, argc, argv);                     \
    }
