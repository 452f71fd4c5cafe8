#include "core/project/json_reader.h"

#include "core/base/atomic_file.h"
#include "core/base/json_shape.h"

namespace chiaro::project {

namespace {

constexpr std::size_t mostValues = 2'000'000;
constexpr std::size_t mostMembers = 1000;  // of an object: its parser compares each key with all before it

/// Refuses what no program writes, but what would cost the parser minutes, gigabytes or its stack.
void checkShape(const std::filesystem::path& file, const std::string& text, const std::string& remedy) {
    const JsonShape shape = jsonShape(text);
    const auto refuse = [&](const std::string& what) { throw Error(file.string(), what, remedy); };
    if (shape.depth > JsonShape::deepest)
        refuse(fmt::format("nests lists and objects more than {} deep", JsonShape::deepest));
    if (shape.values > mostValues)
        refuse(fmt::format("holds {} values, and {} at most are read", shape.values, mostValues));
    if (shape.members > mostMembers)
        refuse(fmt::format("has an object with {} members, and {} at most are read", shape.members,
                           mostMembers));
}

}  // namespace

Json readJson(const std::filesystem::path& file, std::uintmax_t limit, const std::string& remedy) {
    const std::string text = readFile(file, limit);
    checkShape(file, text, remedy);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw Error(file.string(), fmt::format("is not JSON (byte {} can't be read)", error.byte), remedy);
    } catch (const Json::exception& error) {
        throw Error(file.string(), std::string("is not JSON (") + error.what() + ")", remedy);
    }
}

}  // namespace chiaro::project
