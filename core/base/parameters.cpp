#include "core/base/parameters.h"

#include "core/base/error.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>

namespace chiaro {

using Kind = ParameterSpec::Kind;

ParameterSpec ParameterSpec::integer(std::string key, std::string label, std::string unit, double minimum,
                                     double maximum, std::string tooltip) {
    return {std::move(key),
            std::move(label),
            std::move(tooltip),
            std::move(unit),
            Kind::Integer,
            minimum,
            maximum,
            1,
            {}};
}

ParameterSpec ParameterSpec::real(std::string key, std::string label, std::string unit, double minimum,
                                  double maximum, double step, std::string tooltip) {
    return {std::move(key),
            std::move(label),
            std::move(tooltip),
            std::move(unit),
            Kind::Real,
            minimum,
            maximum,
            step,
            {}};
}

ParameterSpec ParameterSpec::boolean(std::string key, std::string label, std::string tooltip) {
    return {std::move(key), std::move(label), std::move(tooltip), {}, Kind::Boolean, 0, 1, 1, {}};
}

ParameterSpec ParameterSpec::choice(std::string key, std::string label, std::vector<std::string> choices,
                                    std::string tooltip) {
    const double last = double(choices.size()) - 1;
    return {std::move(key),    std::move(label), std::move(tooltip), {}, Kind::Choice, 0, last, 1,
            std::move(choices)};
}

std::string ParameterSpec::rangeText() const {
    switch (kind) {
        case Kind::Boolean:
            return "on or off";
        case Kind::Choice:
            return fmt::format("{}", fmt::join(choices, " or "));
        default:
            return fmt::format("{:g}..{:g}{}{}", minimum, maximum, unit.empty() ? "" : " ", unit);
    }
}

std::string ParameterSpec::valueText(double value) const {
    switch (kind) {
        case Kind::Boolean:
            return value != 0 ? "on" : "off";
        case Kind::Choice:
            return choices.at(std::size_t(value));
        case Kind::Integer:
            return fmt::format("{:.0f}", value);
        default:
            return fmt::format("{:g}", value);
    }
}

double ParameterSpec::parse(std::string_view text) const {
    const auto invalid = [&] {
        return Error(key, fmt::format("\"{}\" is not a value it can have", text), "choose " + rangeText());
    };
    if (kind == Kind::Boolean) {
        if (text == "on" || text == "true" || text == "1") return 1;
        if (text == "off" || text == "false" || text == "0") return 0;
        throw invalid();
    }
    if (kind == Kind::Choice) {
        const auto found = std::find(choices.begin(), choices.end(), text);
        if (found == choices.end()) throw invalid();
        return double(found - choices.begin());
    }
    double value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size()) throw invalid();
    check(value);
    return value;
}

void ParameterSpec::check(double value) const {
    const bool whole = kind == Kind::Real || value == std::floor(value);
    if (whole && value >= minimum && value <= maximum) return;
    throw Error(key, fmt::format("is {:g}", value), "choose " + rangeText());
}

nlohmann::json parametersToJson(std::span<const ParameterSpec> specs, std::span<const double> values) {
    nlohmann::json json = nlohmann::json::object();
    for (std::size_t i = 0; i < specs.size(); ++i) {
        switch (specs[i].kind) {
            case Kind::Boolean:
                json[specs[i].key] = values[i] != 0;
                break;
            case Kind::Choice:
                json[specs[i].key] = specs[i].valueText(values[i]);
                break;
            case Kind::Integer:
                json[specs[i].key] = std::int64_t(values[i]);
                break;
            case Kind::Real:
                json[specs[i].key] = values[i];
                break;
        }
    }
    return json;
}

void parametersFromJson(const nlohmann::json& json, std::string_view subject,
                        std::span<const ParameterSpec> specs, std::span<double> values) {
    for (std::size_t i = 0; i < specs.size(); ++i) {
        const ParameterSpec& spec = specs[i];
        if (!json.contains(spec.key)) continue;
        const nlohmann::json& entry = json.at(spec.key);
        const std::string where = fmt::format("{}, {}", subject, spec.key);
        const bool number = spec.kind == Kind::Integer || spec.kind == Kind::Real;
        if ((number && !entry.is_number()) || (spec.kind == Kind::Boolean && !entry.is_boolean()) ||
            (spec.kind == Kind::Choice && !entry.is_string()))
            throw Error(where, "is " + entry.dump(), "write " + spec.rangeText());
        try {
            const double value = number                       ? entry.get<double>()
                                 : spec.kind == Kind::Boolean ? double(entry.get<bool>())
                                                              : spec.parse(entry.get<std::string>());
            spec.check(value);
            values[i] = value;
        } catch (const Error&) {
            throw Error(where, "is " + entry.dump(), "write " + spec.rangeText());
        }
    }
}

}  // namespace chiaro
