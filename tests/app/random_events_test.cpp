#include "core/base/atomic_file.h"
#include "core/base/random.h"
#include "tests/app/app_support.h"
#include "tests/app/window_support.h"
#include "widgets/viewport/viewport.h"

#include <QtTest>
#include <QtWidgets>

#include <cstdio>

using namespace chiaro;
using app::MainWindow;

namespace {

/// Does at random what hands at the mouse and the keyboard can do to a window, except to end the program and
/// to choose files.
class Hands : public QObject {
public:
    Hands(MainWindow& window, std::uint64_t seed) : m_window(window), m_random(seed) {
        window.installEventFilter(this);
        for (const QAction* entry : window.menuBar()->actions())
            (entry->text() == "&File" ? m_closed : m_menus) << entry->menu();
        for (QMenu* menu : m_closed)
            for (QAction* action : actionsOf(*menu)) action->setEnabled(false);
        connect(&m_dialogs, &QTimer::timeout, this, &Hands::closeDialogs);
        m_dialogs.start(30);
    }

    /// One event; returns what it was.
    QString act() {
        static constexpr std::array<QString (Hands::*)(), 8> ways{
            &Hands::clickSomewhere, &Hands::dragSomewhere, &Hands::typeSomething, &Hands::turnTheWheel,
            &Hands::chooseFromMenu, &Hands::moveADock,     &Hands::undoOrRedo,    &Hands::resizeOrWait};
        static constexpr std::array<int, 8> weights{26, 20, 18, 10, 13, 5, 4, 4};
        int way = 0;
        for (int left = below(100); left >= weights[std::size_t(way)]; ++way)
            left -= weights[std::size_t(way)];
        return (this->*ways[std::size_t(way)])();
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched != &m_window || event->type() != QEvent::Close) return false;
        event->ignore();
        return true;
    }

private:
    int below(qsizetype end) { return int(m_random.below(std::uint64_t(std::max<qsizetype>(end, 1)))); }
    template <class List>
    auto one(const List& list) {
        return list[below(std::size(list))];
    }

    static QList<QAction*> actionsOf(const QMenu& menu) {
        QList<QAction*> actions;
        for (QAction* action : menu.actions())
            if (action->menu())
                actions << actionsOf(*action->menu());
            else if (!action->isSeparator())
                actions << action;
        return actions;
    }

    /// Some widget that can be seen: of a menu or dialog that is open, else of any window.
    QWidget* someWidget() {
        QWidget* top = QApplication::activePopupWidget();
        if (!top) top = QApplication::activeModalWidget();
        if (!top) {
            QWidgetList windows;
            for (QWidget* window : QApplication::topLevelWidgets())
                if (window->isVisible() && !window->inherits("QTipLabel")) windows << window;
            if (windows.isEmpty()) return &m_window;
            top = one(windows);
        }
        // Mostly what does something; sometimes what lies around it.
        const bool isForUse = below(5) != 0;
        QWidgetList widgets;
        for (QWidget* child : top->findChildren<QWidget*>()) {
            const bool isUsed = child->focusPolicy() != Qt::NoFocus && child->isEnabled();
            if (child->isVisible() && !child->size().isEmpty() && !child->inherits("QMenuBar") &&
                isUsed == isForUse)
                widgets << child;
        }
        return widgets.isEmpty() ? top : one(widgets);
    }
    QPoint somePoint(const QWidget& widget) { return {below(widget.width()), below(widget.height())}; }
    Qt::MouseButton someButton() {
        return one(
            std::array{Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::RightButton, Qt::MiddleButton});
    }
    Qt::KeyboardModifiers someModifiers() {
        return one(std::array<Qt::KeyboardModifiers, 6>{Qt::NoModifier, Qt::NoModifier, Qt::NoModifier,
                                                        Qt::ShiftModifier, Qt::ControlModifier,
                                                        Qt::ShiftModifier | Qt::ControlModifier});
    }
    static QString nameOf(const QWidget& widget) {
        return QString("%1 %2 in %3")
            .arg(widget.metaObject()->className(), widget.objectName(),
                 widget.window()->metaObject()->className());
    }

    QString clickSomewhere() {
        const QPointer<QWidget> widget = someWidget();
        const QString name = nameOf(*widget);
        const Qt::MouseButton button = someButton();
        const QPoint at = somePoint(*widget);
        const bool isDouble = below(5) == 0;
        QTest::mouseClick(widget, button, someModifiers(), at);
        if (isDouble && widget) QTest::mouseDClick(widget, button, Qt::NoModifier, at);
        return QString("%1 of button %2 at %3, %4 of %5")
            .arg(isDouble ? "double click" : "click")
            .arg(int(button))
            .arg(at.x())
            .arg(at.y())
            .arg(name);
    }

    QString dragSomewhere() {
        const QPointer<QWidget> widget = someWidget();
        const QString name = nameOf(*widget);
        const Qt::MouseButton button = someButton();
        const Qt::KeyboardModifiers modifiers = someModifiers();
        QPoint at = somePoint(*widget);
        QTest::mousePress(widget, button, modifiers, at);
        for (int i = below(6); i >= 0 && widget; --i) {
            at += QPoint(below(61) - 30, below(61) - 30);
            QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, button, modifiers);
            QApplication::sendEvent(widget, &move);
        }
        if (widget) QTest::mouseRelease(widget, button, modifiers, at);
        return QString("drag with button %1 over %2").arg(int(button)).arg(name);
    }

    QString typeSomething() {
        static constexpr std::array keys{Qt::Key_1,         Qt::Key_2,      Qt::Key_3,      Qt::Key_F,
                                         Qt::Key_G,         Qt::Key_H,      Qt::Key_I,      Qt::Key_K,
                                         Qt::Key_Z,         Qt::Key_A,      Qt::Key_C,      Qt::Key_V,
                                         Qt::Key_X,         Qt::Key_D,      Qt::Key_0,      Qt::Key_5,
                                         Qt::Key_9,         Qt::Key_Minus,  Qt::Key_Plus,   Qt::Key_Period,
                                         Qt::Key_Tab,       Qt::Key_Left,   Qt::Key_Right,  Qt::Key_Up,
                                         Qt::Key_Down,      Qt::Key_Home,   Qt::Key_End,    Qt::Key_Space,
                                         Qt::Key_Return,    Qt::Key_Delete, Qt::Key_F2,     Qt::Key_F5,
                                         Qt::Key_Backspace, Qt::Key_Escape, Qt::Key_PageUp, Qt::Key_PageDown};
        QWidget* widget = QApplication::focusWidget() ? QApplication::focusWidget() : someWidget();
        const Qt::Key key = one(keys);
        const Qt::KeyboardModifiers modifiers = someModifiers();
        const QString name = nameOf(*widget);
        QTest::keyClick(widget, key, modifiers);
        return QString("key %1 in %2").arg(QKeySequence(key | modifiers).toString(), name);
    }

    QString turnTheWheel() {
        QWidget* widget = below(3) == 0 ? &m_window.viewport() : someWidget();
        const QString name = nameOf(*widget);
        const QPoint at = somePoint(*widget);
        QWheelEvent wheel(at, widget->mapToGlobal(at), {}, {0, 120 * (below(7) - 3)}, Qt::NoButton,
                          someModifiers(), Qt::NoScrollPhase, false);
        QApplication::sendEvent(widget, &wheel);
        return "wheel over " + name;
    }

    QString chooseFromMenu() {
        QList<QAction*> actions;
        for (QMenu* menu : m_menus) {
            Q_EMIT menu->aboutToShow();
            actions << actionsOf(*menu);
        }
        QAction* action = one(actions);
        const QString text = action->text();
        action->trigger();
        return "menu: " + text;
    }

    QString moveADock() {
        auto* dock = one(m_window.findChildren<QDockWidget*>());
        const QString title = dock->windowTitle();
        switch (below(4)) {
            case 0:
                dock->setFloating(!dock->isFloating());
                return "float or dock " + title;
            case 1:
                dock->setVisible(!dock->isVisible());
                return "show or hide " + title;
            case 2:
                m_window.addDockWidget(one(std::array{Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea,
                                                      Qt::BottomDockWidgetArea}),
                                       dock);
                return "move " + title;
            default:
                dock->raise();
                return "raise " + title;
        }
    }

    QString undoOrRedo() {
        QUndoStack& undo = m_window.document().undoStack();
        const bool isUndo = below(3) != 0;
        for (int i = below(6); i >= 0; --i) isUndo ? undo.undo() : undo.redo();
        return isUndo ? "undo" : "redo";
    }

    QString resizeOrWait() {
        if (below(2) == 0) {
            QTest::qWait(below(60));
            return "wait";
        }
        m_window.resize(500 + below(500), 350 + below(350));
        return "resize";
    }

    /// What waits for an answer gets none for long; other windows don't pile up.
    void closeDialogs() {
        if (QWidget* popup = QApplication::activePopupWidget(); popup && below(4) == 0) popup->close();
        if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) dialog->reject();
        for (QWidget* window : QApplication::topLevelWidgets())
            if (auto* dialog = qobject_cast<QDialog*>(window);
                dialog && dialog->isVisible() && below(10) == 0)
                dialog->reject();
    }

    MainWindow& m_window;
    Random m_random;
    QTimer m_dialogs;
    QList<QMenu*> m_closed;
    QList<QMenu*> m_menus;
};

std::uint64_t seedOfRun() {
    bool isGiven = false;
    const auto seed = qEnvironmentVariable("CHIARO_SEED").toULongLong(&isGiven);
    return isGiven ? seed : 1;
}

}  // namespace

/// Long: 10,000 events instead of 500, with CHIARO_LONG_TESTS=1 in the environment. CHIARO_SEED=n does
/// others; CHIARO_TRACE=1 says what each is.
class RandomEventsTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    /// Of the project's file.
    QStringList linesOf(const project::Project& project) {
        project::writeProject(m_folder / "lines.chiaro", project);
        return QString::fromStdString(readFile(m_folder / "lines.chiaro", 1 << 24)).split('\n');
    }

private Q_SLOTS:
    void initTestCase() { test::prepareWindows(m_folder); }

    void whateverIsDoneCanBeUndone() {
        MainWindow window;
        window.resize(700, 500);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        project::Project project;
        project.levels.size = 64;
        project.levels.count = 3;
        project.levels.quilt.block = 16;
        project.views.count = 3;
        project.views.size = 64;
        window.document().replace(project, {}, {});
        QVERIFY(test::openAndSettle(window, {test::writeStrip(m_folder / "strip.png"),
                                             test::writeTetrahedron(m_folder / "mesh.obj", "tetrahedron")}));
        // What is open now is what all is undone to.
        window.document().save(m_folder / "before.chiaro");
        window.document().undoStack().clear();
        const project::Project before = test::withoutCamera(window.document().project());
        const QStringList written = linesOf(before);

        const std::uint64_t seed = seedOfRun();
        const int count = qEnvironmentVariableIsSet("CHIARO_LONG_TESTS") ? 10'000 : 500;
        qInfo("seed %llu, %d events", static_cast<unsigned long long>(seed), count);
        const bool isTold = qEnvironmentVariableIsSet("CHIARO_TRACE");
        int steps = 0;
        int edits = 0;
        connect(&window.document(), &app::Document::changed, this, [&] { ++edits; });
        {
            Hands hands(window, seed);
            for (int i = 0; i < count; ++i) {
                const QString what = hands.act();
                if (isTold) std::fprintf(stderr, "%d: %s\n", i, qPrintable(what));
                if (i % 16 == 0) QCoreApplication::processEvents();
                const QUndoStack& undo = window.document().undoStack();
                steps = std::max(steps, undo.count());
                const bool isAtBegin = undo.index() == 0;
                QVERIFY2(!isAtBegin || test::withoutCamera(window.document().project()) == before,
                         qPrintable(QString("event %1 (%2) is not in the history").arg(i).arg(what)));
            }
            // Dialogs that are open, and drags.
            QVERIFY(QTest::qWaitFor([] { return !QApplication::activeModalWidget(); }, 10'000));
        }
        qInfo("%d changes, up to %d steps", edits, steps);
        QVERIFY2(edits > count / 10, "the events hardly edit anything");
        window.document().finishEdit();
        window.document().undoStack().setIndex(0);
        const project::Project after = test::withoutCamera(window.document().project());
        for (const QString& line : linesOf(after))
            if (!written.contains(line)) qWarning("not undone: %s", qPrintable(line));
        QCOMPARE(linesOf(after), written);
        QCOMPARE(after, before);
        QVERIFY(window.isVisible());
        window.jobs().cancelAll();
        QVERIFY(test::settle(window));
    }
};

QTEST_MAIN(RandomEventsTest)
#include "random_events_test.moc"
