#include "core/project/json_reader.h"

#include "core/base/atomic_file.h"

namespace chiaro::project {

Json readJson(const std::filesystem::path& file, std::uintmax_t limit, const std::string& remedy) {
    const std::string text = readFile(file, limit);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw Error(file.string(), fmt::format("is not JSON (byte {} can't be read)", error.byte), remedy);
    } catch (const Json::exception& error) {
        throw Error(file.string(), std::string("is not JSON (") + error.what() + ")", remedy);
    }
}

}  // namespace chiaro::project
