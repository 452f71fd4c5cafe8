#include "app/animation_dialog.h"
#include "app/export_dialog.h"
#include "app/first_hints.h"
#include "app/help_window.h"
#include "app/main_window.h"
#include "app/mesh_export_dialog.h"
#include "app/missing_files_dialog.h"
#include "app/recovery_dialog.h"
#include "app/theme.h"
#include "tests/app/app_support.h"
#include "widgets/viewport/viewport.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;

namespace {

QString pathOf(const QWidget* widget) {
    QStringList names;
    for (; widget; widget = widget->parentWidget())
        names.prepend(QString("%1(%2)").arg(widget->metaObject()->className(), widget->objectName()));
    return names.join(" / ");
}

/// What Qt makes for itself inside a control that has a name: the field of a spin box, a scroll area's own
/// parts, a bar whose tabs are read one by one.
bool isInnerPart(const QWidget* widget) {
    return widget->objectName().startsWith("qt_") || qobject_cast<const QMenu*>(widget) ||
           qobject_cast<const QMenuBar*>(widget) || qobject_cast<const QHeaderView*>(widget) ||
           widget->metaObject()->className() == QByteArray("QTableCornerButton") ||
           widget->inherits("QComboBoxListView") || qobject_cast<const QTabBar*>(widget) ||
           qobject_cast<const QTabBar*>(widget->parentWidget()) ||
           (widget->parentWidget() && widget->parentWidget()->objectName().startsWith("qt_"));
}

QString accessibleName(QWidget* widget) {
    QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
    return interface ? interface->text(QAccessible::Name) : QString();
}

QStringList withoutName(QWidget& root) {
    QStringList found;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        const auto* label = qobject_cast<const QLabel*>(widget);
        if (label && label->text().isEmpty()) continue;  // has nothing to say yet
        if (widget->focusPolicy() != Qt::NoFocus && !isInnerPart(widget) && accessibleName(widget).isEmpty())
            found << pathOf(widget);
    }
    return found;
}

/// Buttons that show no word must say in a tooltip what they do.
QStringList withoutTooltip(QWidget& root) {
    QStringList found;
    for (const QAbstractButton* button : root.findChildren<QAbstractButton*>()) {
        const auto* tool = qobject_cast<const QToolButton*>(button);
        const bool isWordless =
            button->text().isEmpty() ||
            (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull());
        if (isWordless && !isInnerPart(button) && button->toolTip().isEmpty()) found << pathOf(button);
    }
    return found;
}

/// Where Tab goes up by more than a row within one column of `content`: a reader would lose their place.
QStringList jumpsUp(QWidget* content) {
    QStringList found;
    const QWidget* before = nullptr;
    QWidget* widget = content;
    do {
        widget = widget->nextInFocusChain();
        const bool takesTab = (widget->focusPolicy() & Qt::TabFocus) && widget->isVisibleTo(content) &&
                              content->isAncestorOf(widget) && widget->focusProxy() == nullptr &&
                              !isInnerPart(widget);
        if (!takesTab) continue;
        if (before) {
            const QRect a(before->mapTo(content, QPoint()), before->size());
            const QRect b(widget->mapTo(content, QPoint()), widget->size());
            const bool isBeside = b.left() >= a.right() - 4;
            if (b.bottom() < a.top() && !isBeside) found << pathOf(before) + " -> " + pathOf(widget);
        }
        before = widget;
    } while (widget != content);
    return found;
}

}  // namespace

class AccessibilityTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder m_folder;

    static void check(QWidget& root) {
        const QStringList nameless = withoutName(root);
        QVERIFY2(nameless.isEmpty(), qPrintable("without a name:\n" + nameless.join("\n")));
        const QStringList silent = withoutTooltip(root);
        QVERIFY2(silent.isEmpty(), qPrintable("without a tooltip:\n" + silent.join("\n")));
    }

private Q_SLOTS:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        Q_INIT_RESOURCE(resources);
    }

    void everyControlOfTheWindowHasAName() {
        app::ThemeSwitch theme(app::Theme::Dark);
        app::MainWindow window;
        window.addAppearance(theme);
        window.show();
        new app::FirstHints(window.viewport());
        const auto strip = test::writeStrip(m_folder / "strip.png");
        const auto mesh = test::writeTetrahedron(m_folder / "mesh.obj", "thing");
        window.open({QString::fromStdString(strip.string()), QString::fromStdString(mesh.string())});
        QVERIFY(QTest::qWaitFor([&] { return window.jobs().isIdle(); }, 60'000));
        check(window);
    }

    void everyControlOfTheDialogsHasAName() {
        app::ExportDialog picture({}, nullptr);
        check(picture);
        app::MeshExportDialog mesh({}, nullptr);
        check(mesh);
        app::AnimationDialog animation({}, {}, nullptr);
        check(animation);
        project::Project project;
        app::MissingFilesDialog missing(project);
        check(missing);
        app::RecoveryDialog recovery({app::Autosave::Leftover{}});
        check(recovery);
        app::HelpWindow help;
        check(help);
    }

    void tabGoesThroughEveryDockInTheOrderOfReading() {
        app::MainWindow window;
        window.resize(1600, 1200);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            QTest::qWait(20);
            const QStringList jumps = jumpsUp(dock->widget());
            QVERIFY2(jumps.isEmpty(), qPrintable(dock->objectName() + ":\n" + jumps.join("\n")));
        }
    }

    void everyMenuOpensByAKeyOfItsOwn() {
        app::MainWindow window;
        QSet<QString> keys;
        for (const QAction* menu : window.menuBar()->actions()) {
            const QKeySequence key = QKeySequence::mnemonic(menu->text());
            QVERIFY2(!key.isEmpty(), qPrintable(menu->text()));
            QVERIFY2(!keys.contains(key.toString()), qPrintable(menu->text()));
            keys.insert(key.toString());
        }
    }

    void noShortcutIsTakenTwice() {
        app::ThemeSwitch theme(app::Theme::Dark);
        app::MainWindow window;
        window.addAppearance(theme);
        QMap<QString, QString> owners;
        for (const QAction* action : window.findChildren<QAction*>())
            for (const QKeySequence& key : action->shortcuts()) {
                if (key.isEmpty() || action->shortcutContext() < Qt::WindowShortcut) continue;
                QVERIFY2(!owners.contains(key.toString()),
                         qPrintable(key.toString() + ": " + owners[key.toString()] + ", " + action->text()));
                owners[key.toString()] = action->text();
            }
        QVERIFY(owners.contains("F1"));
    }
};

QTEST_MAIN(AccessibilityTest)
#include "accessibility_test.moc"
