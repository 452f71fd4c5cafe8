#pragma once

#include "app/cli/farm/engine.h"
#include "app/cli/session.h"

namespace chiaro::cli::farm {

void addSubmitCommand(CLI::App& farm, Session& session);
void addStatusCommand(CLI::App& farm, Session& session);
void addCollectCommand(CLI::App& farm, Session& session);

/// The job that a folder, the pattern of its frames, or the number that an engine gave it names. Throws
/// Error.
Job jobNamed(const std::string& name);

}  // namespace chiaro::cli::farm
