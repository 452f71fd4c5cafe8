#pragma once

#include <QTemporaryDir>

namespace chiaro::app {

/// As long as it lives, QSettings finds nothing that was remembered, and what it is told is forgotten at the end: for
/// pictures that are the same on every machine, and for a studio that starts safely.
class ForgottenSettings {
public:
    ForgottenSettings();

private:
    QTemporaryDir m_folder;
};

}  // namespace chiaro::app
