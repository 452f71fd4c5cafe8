#include "app/cli/sample_source.h"

namespace chiaro::cli {

void SampleSource::addTo(CLI::App& command) {
    addStripTo(command, "STRIP")->required();
    addParameterFlags(command, m_sample.gradient);
}

CLI::Option* SampleSource::addStripTo(CLI::App& command, const std::string& name) {
    CLI::Option* strip = command.add_option(
        name, m_sample.scan, "Scanned strip of paint, dark at the left: PNG, JPEG, TIFF, EXR or WebP");
    command.add_option_function<std::string>(
        "--crop",
        [this](const std::string& text) {
            const std::vector<float> numbers = numbersFrom("--crop", text, 8);
            for (std::size_t i = 0; i < 4; ++i) m_sample.strip.crop[i] = {numbers[2 * i], numbers[2 * i + 1]};
        },
        "Crop quadrilateral: x,y of the top-left, top-right, bottom-right and bottom-left corner, in "
        "fractions of "
        "width and height (default 0,0,1,0,1,1,0,1)");
    addParameterFlags(command, m_sample.strip);
    return strip;
}

ColorImage SampleSource::readStrip() const {
    return sample::readStrip(m_sample.scan, m_sample.strip);
}

nlohmann::json SampleSource::parameters() const {
    nlohmann::json json = parametersToJson(m_sample.strip);
    json.update(parametersToJson(m_sample.gradient));
    for (const glm::vec2& corner : m_sample.strip.crop) json["crop"].push_back({corner.x, corner.y});
    json["strip"] = m_sample.scan.filename().string();
    return json;
}

}  // namespace chiaro::cli
