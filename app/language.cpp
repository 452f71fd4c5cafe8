#include "app/language.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

const char* const settingsKey = "language";

struct Spoken {
    const char* code;
    const char* name;  ///< in the language itself
};

constexpr Spoken languages[] = {{"en", "English"}, {"de", "Deutsch"}};

QString& shown() {
    static QString code = "en";
    return code;
}

struct LanguageText {
    Q_DECLARE_TR_FUNCTIONS(chiaro::app::Language)
};

}  // namespace

QStringList languageCodes() {
    QStringList codes;
    for (const Spoken& language : languages) codes << language.code;
    return codes;
}

QString rememberedLanguage() {
    const QString code = QSettings().value(settingsKey).toString();
    return languageCodes().contains(code) ? code : QString();
}

QString spokenLanguage(const QString& wanted) {
    if (!wanted.isEmpty()) return wanted;
    for (const QString& tag : QLocale::system().uiLanguages()) {
        const QString code = tag.section('-', 0, 0);
        if (languageCodes().contains(code)) return code;
    }
    return "en";
}

bool installLanguage(const QString& code) {
    shown() = code;
    // Numbers are written as the language does; of the language that the system speaks too, as the region
    // does.
    if (QLocale::system().language() != QLocale(code).language()) QLocale::setDefault(QLocale(code));
    if (code == "en") return true;
    const auto install = [](const QString& file, const QString& folder) {
        auto* translator = new QTranslator(qApp);
        return translator->load(file, folder) && QCoreApplication::installTranslator(translator);
    };
    // Without Qt's own file only the buttons of its dialogs stay English.
    install("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    return install("chiaro_" + code, ":/translations");
}

QString shownLanguage() {
    return shown();
}

void addLanguagesTo(QMenu& menu, QWidget* parent) {
    auto* group = new QActionGroup(&menu);
    const auto add = [&](const QString& name, const QString& code) {
        QAction* action = menu.addAction(name);
        action->setObjectName("language-" + (code.isEmpty() ? "system" : code));
        action->setCheckable(true);
        action->setChecked(code == rememberedLanguage());
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, parent, [parent, code] {
            if (code == rememberedLanguage()) return;
            QSettings().setValue(settingsKey, code);
            QMessageBox::information(parent, LanguageText::tr("Language"),
                                     LanguageText::tr("Chiaro speaks it from its next start on."));
        });
    };
    add(LanguageText::tr("As the &System"), {});
    for (const Spoken& language : languages) add(QString::fromUtf8(language.name), language.code);
}

}  // namespace chiaro::app
