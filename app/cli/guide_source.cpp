#include "app/cli/guide_source.h"

#include "app/cli/data_pictures.h"
#include "core/base/error.h"
#include "core/scene/guide.h"

#include <spdlog/fmt/fmt.h>

#include <charconv>
#include <set>

namespace chiaro::cli {

namespace {

int idFrom(const std::string& text) {
    int id = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), id);
    return problem == std::errc() && end == text.data() + text.size() ? id : 0;
}

}  // namespace

void GuideSource::addTo(CLI::App& command) {
    CLI::Option* guide = command.add_option(
        "--guide", m_light,
        "Picture of light to paint in place of a mesh, 0 dark to 1 light; negative, NaN and transparent "
        "pixels are outside. Image-based only");
    for (const char* flag : {"--mesh", "--size", "--light", "--camera"})
        guide->excludes(command.get_option(flag));
    command
        .add_option(
            "--ids", m_ids,
            "Picture of object ids for --guide, 8 or 16-bit grey: 0 outside, 1.. the object; --object "
            "names them by number (default: all is object 1)")
        ->needs(guide);
}

scene::GBuffer GuideSource::read() const {
    const ScalarImage light = readLight(m_light);
    if (m_ids.empty()) return scene::gbufferFromGuide(light);
    const IdImage ids = readIds(m_ids);
    return scene::gbufferFromGuide(light, &ids);
}

project::WornPaints GuideSource::wornPaints(const project::Project& project, const scene::GBuffer& view,
                                            const std::vector<project::Paint>& paints) const {
    std::vector<bool> seen(greatestId + 1);
    for (const std::uint16_t id : view.objectId.pixels()) seen[id] = true;
    std::vector<int> present;
    for (int id = 1; id <= greatestId; ++id)
        if (seen[std::size_t(id)]) present.push_back(id);
    project::WornPaints worn(present.empty() ? 0 : std::size_t(present.back()), {&paints.front()});
    for (const project::ObjectSettings& object : project.objects) {
        const int id = idFrom(object.name);
        if (!std::ranges::binary_search(present, id))
            throw Error((m_ids.empty() ? m_light : m_ids).string(), "has no object \"" + object.name + "\"",
                        present.empty() ? "nothing in it is inside an object"
                                        : fmt::format("it has {}", fmt::join(present, ", ")).substr(0, 400));
        worn[std::size_t(id) - 1].paint = &paints[std::size_t(object.sample)];
    }
    return worn;
}

nlohmann::json GuideSource::parameters() const {
    nlohmann::json json{{"guide", m_light.filename().string()}};
    if (!m_ids.empty()) json["ids"] = m_ids.filename().string();
    return json;
}

}  // namespace chiaro::cli
