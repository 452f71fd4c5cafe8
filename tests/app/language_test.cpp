#include "app/language.h"

#include "app/export_dialog.h"
#include "app/help_window.h"
#include "app/main_window.h"
#include "app/mesh_export_dialog.h"
#include "app/theme.h"
#include "widgets/core_text.h"

#include <QtTest>
#include <QtWidgets>

using namespace chiaro;

namespace {

/// Every text that a window shows, says or tells in a tooltip.
QSet<QString> textsOf(QWidget& root) {
    QSet<QString> texts;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        texts << widget->toolTip() << widget->accessibleName() << widget->windowTitle()
              << widget->statusTip();
        if (const auto* label = qobject_cast<const QLabel*>(widget)) texts << label->text();
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) texts << button->text();
        if (const auto* box = qobject_cast<const QComboBox*>(widget))
            for (int i = 0; i < box->count(); ++i) texts << box->itemText(i);
        if (const auto* tabs = qobject_cast<const QTabBar*>(widget))
            for (int i = 0; i < tabs->count(); ++i) texts << tabs->tabText(i);
        if (const auto* field = qobject_cast<const QDoubleSpinBox*>(widget)) texts << field->suffix();
    }
    for (const QAction* action : root.findChildren<QAction*>()) texts << action->text() << action->toolTip();
    return texts;
}

QSet<QString> textsOfTheStudio() {
    app::ThemeSwitch theme(app::Theme::Dark);
    app::MainWindow window;
    window.addAppearance(theme);
    QSet<QString> texts = textsOf(window);
    app::ExportDialog picture({}, nullptr);
    app::MeshExportDialog mesh({}, nullptr);
    app::HelpWindow help;
    return texts + textsOf(picture) + textsOf(mesh) + textsOf(help);
}

/// The texts of resources/translations/chiaro_de.ts that are the same in German.
QSet<QString> sameInGerman() {
    QSet<QString> same;
    QFile file(CHIARO_GERMAN);
    if (!file.open(QIODevice::ReadOnly)) return same;
    QXmlStreamReader xml(&file);
    QString source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QString("source")) source = xml.readElementText();
        if (xml.name() == QString("translation") && xml.readElementText() == source)
            same << source << source.remove('&');
    }
    return same;
}

}  // namespace

class LanguageTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        Q_INIT_RESOURCE(resources);
        Q_INIT_RESOURCE(translations);
    }

    void theSystemsLanguageIsSpokenWhereItIsKnown() {
        QCOMPARE(app::languageCodes().front(), QString("en"));
        QCOMPARE(app::spokenLanguage("de"), QString("de"));
        QVERIFY(app::languageCodes().contains(app::spokenLanguage({})));
    }

    /// Last, since nothing takes a language away again.
    void nothingStaysEnglishInGerman() {
        const QSet<QString> english = textsOfTheStudio();
        QVERIFY(english.contains("Gradient Curve") && english.contains("Stroke density"));
        QVERIFY(app::installLanguage("de"));
        const QSet<QString> german = textsOfTheStudio();
        QVERIFY(german.contains("Verlaufskurve"));
        QCOMPARE(widgets::coreText("a name that an artist gave"), QString("a name that an artist gave"));

        const QSet<QString> same = sameInGerman();
        QVERIFY(same.contains("Position"));
        // Names of languages are in the language itself; Qt's own words are of another package.
        const QSet<QString> names{"English",    "Deutsch",     "Chiaro",       "Cancel", "Close",
                                  "Float",      "Scroll Left", "Scroll Right", "Open",   "Save",
                                  "Position X", "Position Y",  "Position Z"};
        static const QRegularExpression word("[a-zA-Z]{3}");
        QStringList untranslated;
        for (const QString& text : english& german)
            if (text.contains(word) && !same.contains(text) && !same.contains(text.trimmed()) &&
                !names.contains(text))
                untranslated << text;
        QVERIFY2(untranslated.isEmpty(), qPrintable(untranslated.join("\n")));
    }
};

QTEST_MAIN(LanguageTest)
#include "language_test.moc"
