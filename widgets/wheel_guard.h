#pragma once

#include <QObject>

namespace chiaro::widgets {

/// Keeps the wheel from changing a field that merely passes under the pointer while a dock scrolls: only a
/// field with the keyboard's focus takes it.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    /// Guards the field for as long as it lives.
    static void protect(QWidget* field);

private:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace chiaro::widgets
