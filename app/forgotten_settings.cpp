#include "app/forgotten_settings.h"

#include <QSettings>

namespace chiaro::app {

ForgottenSettings::ForgottenSettings() {
    for (const QSettings::Scope scope : {QSettings::UserScope, QSettings::SystemScope})
        QSettings::setPath(QSettings::NativeFormat, scope, m_folder.path());
}

}  // namespace chiaro::app
