#include "app/system_theme.h"

#include <QtDBus>
#include <QtGui>

#include <utility>

namespace chiaro::app {

namespace {

const char* const service = "org.freedesktop.portal.Desktop";
const char* const path = "/org/freedesktop/portal/desktop";
const char* const interface = "org.freedesktop.portal.Settings";
const char* const appearance = "org.freedesktop.appearance";
const char* const colorScheme = "color-scheme";

/// The portal's answer to Read is a variant in a variant.
QVariant unwrapped(QVariant value) {
    while (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
    return value;
}

}  // namespace

SystemTheme::SystemTheme(const QPalette& palette, QObject* parent)
    : QObject(parent), m_isDark(palette.color(QPalette::Window).lightnessF() < 0.5) {
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) return;
    bus.connect(service, path, interface, "SettingChanged", this, SLOT(take(QString, QString, QDBusVariant)));
    QDBusMessage question = QDBusMessage::createMethodCall(service, path, interface, "Read");
    question.setArguments({appearance, colorScheme});
    // Nobody waits for the answer: where the portal has to be started, that takes seconds.
    auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [this](QDBusPendingCallWatcher* done) {
        const QDBusPendingReply<QDBusVariant> reply = *done;
        if (!reply.isError()) setScheme(unwrapped(reply.value().variant()).toUInt());
        done->deleteLater();
    });
}

void SystemTheme::take(const QString& group, const QString& key, const QDBusVariant& value) {
    if (group == appearance && key == colorScheme) setScheme(unwrapped(value.variant()).toUInt());
}

/// 1 prefers dark, 2 prefers light, 0 has no preference: then the palette was right.
void SystemTheme::setScheme(uint scheme) {
    if (scheme != 1 && scheme != 2) return;
    if (std::exchange(m_isDark, scheme == 1) != (scheme == 1)) Q_EMIT changed();
}

}  // namespace chiaro::app
