#include "core/base/json_shape.h"

#include <algorithm>
#include <vector>

namespace chiaro {

JsonShape jsonShape(std::string_view text) {
    struct Level {
        bool isObject;
        std::size_t count;
    };
    JsonShape shape;
    std::vector<Level> open;
    const auto count = [&] {
        ++shape.values;
        if (open.empty()) return;
        const std::size_t number = ++open.back().count;
        if (open.back().isObject) shape.members = std::max(shape.members, number);
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        switch (text[i]) {
            case '"':
                for (++i; i < text.size() && text[i] != '"'; ++i)
                    if (text[i] == '\\') ++i;
                break;
            case '{':
            case '[':
                open.push_back({text[i] == '{', 0});
                shape.depth = std::max(shape.depth, open.size());
                if (shape.depth > JsonShape::deepest) return shape;
                count();
                break;
            case '}':
            case ']':
                if (!open.empty()) open.pop_back();
                break;
            case ',':
                count();
                break;
            default:
                break;
        }
    }
    return shape;
}

}  // namespace chiaro
