#pragma once

#include <filesystem>
#include <string>

namespace chiaro {

/// Where a file that comes with the programs is: in lib/chiaro beside the program's bin or beside the program
/// itself, as built and as installed, else where this build put it. It may not be there.
std::filesystem::path companionFile(const std::string& file);

/// A function of a module of ours, a shared library that is loaded when it is first needed because what it
/// brings along would slow down every start; a companionFile. It stays loaded. Throws Error when it isn't
/// there.
void* moduleFunction(const std::string& module, const char* function);

}  // namespace chiaro
