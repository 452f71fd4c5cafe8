#pragma once

#include <cstddef>
#include <string_view>

namespace chiaro {

/// How deep and how broad a JSON text is, told from its brackets, commas and quotes alone: what to know
/// before a parser spends time and memory on it. Whether it is valid is for the parser to say.
struct JsonShape {
    static constexpr std::size_t deepest = 100;  ///< nothing that is read here nests half as deep
    std::size_t depth = 0;    ///< of nested lists and objects; counting stops beyond `deepest`
    std::size_t values = 0;   ///< in all lists and objects
    std::size_t members = 0;  ///< of the largest object
};

JsonShape jsonShape(std::string_view text);

}  // namespace chiaro
