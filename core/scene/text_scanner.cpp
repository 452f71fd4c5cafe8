#include "core/scene/text_scanner.h"

#include <algorithm>
#include <charconv>

namespace chiaro::scene {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

void skipBlanks(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
}

void appendUtf8(std::string& text, std::uint32_t code) {
    if (code < 0x80) {
        text += char(code);
    } else if (code < 0x800) {
        text += {char(0xC0 | (code >> 6)), char(0x80 | (code & 0x3F))};
    } else if (code < 0x10000) {
        text += {char(0xE0 | (code >> 12)), char(0x80 | ((code >> 6) & 0x3F)), char(0x80 | (code & 0x3F))};
    } else {
        text += {char(0xF0 | (code >> 18)), char(0x80 | ((code >> 12) & 0x3F)),
                 char(0x80 | ((code >> 6) & 0x3F)), char(0x80 | (code & 0x3F))};
    }
}

/// Bytes of the well-formed UTF-8 character that the text begins with; 0 when it is none.
std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? std::uint8_t(text[i]) : std::uint8_t(0);
    };
    const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0) == 0x80; };
    const std::uint8_t first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return follows(1) ? 2 : 0;
    if ((first & 0xF0) == 0xE0) {
        const bool overlong = first == 0xE0 && byte(1) < 0xA0;
        const bool surrogate = first == 0xED && byte(1) >= 0xA0;
        return follows(1) && follows(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0 && first < 0xF5) {
        const bool overlong = first == 0xF0 && byte(1) < 0x90;
        const bool beyond = first == 0xF4 && byte(1) >= 0x90;
        return follows(1) && follows(2) && follows(3) && !overlong && !beyond ? 4 : 0;
    }
    return 0;
}

}  // namespace

std::string cleanName(std::string_view name, std::size_t longest) {
    std::string clean;
    while (!name.empty()) {
        const std::size_t length = characterLength(name);
        if (clean.size() + length > longest) break;
        if (length == 0) clean += '?';
        if (length > 1 || (length == 1 && name[0] >= ' ' && name[0] != 0x7F)) clean += name.substr(0, length);
        name.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return clean;
}

bool TextScanner::nextLine() {
    while (!m_text.empty()) {
        const std::size_t end = std::min(m_text.find('\n'), m_text.size());
        m_line = m_text.substr(0, end);
        m_text.remove_prefix(std::min(end + 1, m_text.size()));
        if (++m_lineNumber % 4096 == 0) m_source.task.checkpoint();
        if (m_comments) m_line = m_line.substr(0, m_line.find('#'));
        skipBlanks(m_line);
        if (!m_line.empty()) return true;
    }
    m_line = {};
    return false;
}

std::string_view TextScanner::word() {
    skipBlanks(m_line);
    const std::size_t end = std::min(m_line.find_first_of(blanks), m_line.size());
    const std::string_view word = m_line.substr(0, end);
    m_line.remove_prefix(end);
    // Old exporters break long faces over several lines.
    if (word == "\\" && m_line.find_first_not_of(blanks) == m_line.npos)
        return nextLine() ? this->word() : "";
    return word;
}

std::string_view TextScanner::wordAnywhere() {
    for (;;) {
        const std::string_view found = word();
        if (!found.empty() || !nextLine()) return found;
    }
}

std::string_view TextScanner::rest() {
    skipBlanks(m_line);
    const std::size_t last = m_line.find_last_not_of(blanks);
    return last == m_line.npos ? std::string_view() : m_line.substr(0, last + 1);
}

double TextScanner::numberOf(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size() || word.empty()) return std::nan("");
    if (failure == std::errc::result_out_of_range)  // either way beyond a double
        return word.find("e-") != word.npos || word.find("E-") != word.npos
                   ? 0
                   : std::numeric_limits<double>::infinity();
    return failure == std::errc() ? value : std::nan("");
}

std::optional<long long> TextScanner::integerOf(std::string_view word) {
    long long value = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

glm::vec3 TextScanner::position() {
    glm::vec3 position;
    for (int k = 0; k < 3; ++k) {
        const std::string_view text = word();
        if (text.empty()) throw error("the vertex has fewer than three coordinates", "give x, y and z");
        position[k] = float(numberOf(text));
        if (!std::isfinite(position[k]))
            throw error("the vertex is not finite (\"" + std::string(text.substr(0, 40)) + "\")",
                        "every coordinate must be a finite number");
    }
    return position;
}

glm::vec3 TextScanner::direction() {
    glm::vec3 direction;
    for (int k = 0; k < 3; ++k) direction[k] = float(numberOf(word()));
    return glm::any(glm::isnan(direction)) ? glm::vec3(0) : direction;
}

Error TextScanner::error(std::string_view problem, std::string_view remedy) const {
    return m_source.error("line " + std::to_string(m_lineNumber) + ": " + std::string(problem), remedy);
}

std::string decodedUtf16(std::string_view bytes) {
    const bool bigEndian = bytes.starts_with("\xFE\xFF");
    if (!bigEndian && !bytes.starts_with("\xFF\xFE")) return {};
    const auto unit = [&](std::size_t i) {
        const auto first = std::uint8_t(bytes[i]);
        const auto second = std::uint8_t(bytes[i + 1]);
        return std::uint32_t(bigEndian ? first << 8 | second : second << 8 | first);
    };
    std::string text;
    for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
        std::uint32_t code = unit(i);
        if (code >= 0xD800 && code < 0xDC00 && i + 3 < bytes.size()) {
            code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) & 0x3FF);
            i += 2;
        }
        appendUtf8(text, code);
    }
    return text;
}

}  // namespace chiaro::scene
