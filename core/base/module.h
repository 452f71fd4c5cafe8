#pragma once

#include <string>

namespace chiaro {

/// A function of a module of ours, a shared library that is loaded when it is first needed because what it
/// brings along would slow down every start. It is looked for in lib/chiaro beside the program's bin, as
/// built and as installed, else where this build put it, and stays loaded. Throws Error when it isn't there.
void* moduleFunction(const std::string& module, const char* function);

}  // namespace chiaro
