#pragma once

#include <QObject>
#include <QStringList>

class QMenu;
class QWidget;

namespace chiaro::app {

/// The languages the studio speaks, "en" first: the source's own.
QStringList languageCodes();

/// What the artist chose last; empty as the system does.
QString rememberedLanguage();

/// The language for `wanted`, or where that is empty, of those that the system prefers the first that is
/// spoken here; else "en".
QString spokenLanguage(const QString& wanted);

/// Loads the texts in `code` for everything that is made from now on, Qt's own and the studio's. "en" needs
/// no file. False when the studio's texts in it are missing.
bool installLanguage(const QString& code);

/// The language that was installed last, "en" at first.
QString shownLanguage();

/// As the System and one entry a language, which is remembered for the next start; says so over `parent`.
void addLanguagesTo(QMenu& menu, QWidget* parent);

}  // namespace chiaro::app
