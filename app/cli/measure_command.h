#pragma once

#include "app/cli/session.h"
#include "core/base/error.h"

namespace chiaro::cli {

/// What `measure` and `measure study` share.

/// A count of pixels, 0 for "all". Throws CLI::ValidationError.
int pixelsFrom(const std::string& text);

/// Calls work() and names the file in front of any Error it throws.
template <class Work>
auto naming(const std::filesystem::path& file, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        throw Error(file.string(), error);
    }
}

/// `measure study`.
void addStudyCommand(CLI::App& measure, Session& session);

}  // namespace chiaro::cli
