#pragma once

#include "core/scene/mesh_readers.h"

#include <optional>

namespace chiaro::scene {

/// Reads a text format word by word and tells the line in every complaint. Words are separated by blanks; `#`
/// starts a comment (unless told otherwise); a backslash at the end of a line continues it.
class TextScanner {
public:
    TextScanner(const MeshSource& source, std::string_view text, bool comments = true)
        : m_source(source), m_text(text), m_comments(comments) {}

    /// Goes to the next line that is not blank. False at the end. Checks for cancellation now and then.
    bool nextLine();
    /// The next word of this line; empty at its end.
    std::string_view word();
    /// The next word of this line or the lines after it; empty at the end of the text.
    std::string_view wordAnywhere();
    /// What is left of this line, without blanks around it.
    std::string_view rest();

    /// The word as a number; NaN when it spells none.
    static double numberOf(std::string_view word);
    static std::optional<long long> integerOf(std::string_view word);
    /// Three words of this line as a position. Throws Error when they are not three finite numbers.
    glm::vec3 position();
    /// Three words of this line as a direction, as they are; zero where they are no numbers.
    glm::vec3 direction();

    /// An error that begins with the line's number.
    Error error(std::string_view problem, std::string_view remedy) const;

private:
    const MeshSource& m_source;
    std::string_view m_text;  ///< not yet taken into lines
    std::string_view m_line;  ///< not yet taken into words
    bool m_comments;
    std::size_t m_lineNumber = 0;
};

/// The text in UTF-8 when it begins with a byte order mark of UTF-16, else empty.
std::string decodedUtf16(std::string_view bytes);

/// An object's name as it can be shown and saved: valid UTF-8 (other bytes become '?') without control
/// characters, at most `longest` bytes.
std::string cleanName(std::string_view name, std::size_t longest = 120);

}  // namespace chiaro::scene
