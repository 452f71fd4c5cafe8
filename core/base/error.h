#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace chiaro {

/// What core throws when its input can't be used or the work failed: one sentence a painter understands.
///
/// The text reads `SUBJECT: what is wrong; what would be right`. The subject is a file or a parameter.
class Error : public std::runtime_error {
public:
    Error(std::string_view subject, std::string_view problem, std::string_view remedy)
        : std::runtime_error(std::string(subject) + ": " + std::string(problem) + "; " +
                             std::string(remedy)) {}
    /// Another error told of the file that it lies in: `FILE, SUBJECT: ...`.
    Error(std::string_view file, const Error& cause)
        : std::runtime_error(std::string(file) + ", " + cause.what()) {}
};

}  // namespace chiaro
