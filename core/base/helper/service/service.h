#pragma once

#include "core/base/helper/handler.h"

#include <map>
#include <string>

namespace chiaro::helper {

/// The helper's side: shuts this process in, then answers one request after the other on the socket that
/// ChildProcess left, each by the handler that its first text names, until the program is gone. Reports the
/// handlers' progress. Returns the exit status, 2 when the process was not started as a helper.
int serve(std::size_t megabytes, const std::map<std::string, Handler>& handlers);

}  // namespace chiaro::helper
