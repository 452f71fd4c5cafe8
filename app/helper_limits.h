#pragma once

namespace chiaro::app {

/// From now on the studio reads files in helper processes, whose limits come from the environment, or else
/// from the settings import/memory (MB) and import/seconds. A limit that is out of range is named on stderr
/// and the usual ones hold.
void readFilesInHelpers();

}  // namespace chiaro::app
