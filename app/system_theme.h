#pragma once

#include <QObject>

class QDBusVariant;
class QDBusPendingCallWatcher;
class QPalette;

namespace chiaro::app {

/// Whether the desktop is dark: as its settings portal (org.freedesktop.appearance) says, or where there is none,
/// as the palette is that Qt takes from it.
class SystemTheme : public QObject {
    Q_OBJECT

public:
    /// `palette`: of an application that nobody has styled yet.
    SystemTheme(const QPalette& palette, QObject* parent);

    bool isDark() const { return m_isDark; }

Q_SIGNALS:
    void changed();

private Q_SLOTS:
    void take(const QString& group, const QString& key, const QDBusVariant& value);

private:
    void setScheme(uint scheme);

    bool m_isDark;
};

}  // namespace chiaro::app
