#pragma once

#include <QStringList>

class QMimeData;

namespace chiaro::app {

/// The files of this machine among what is dragged or pasted.
QStringList localFiles(const QMimeData& data);

}  // namespace chiaro::app
