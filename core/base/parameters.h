#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace chiaro {

/// What a parameter is called, what it means and what it may be: declared once beside the struct that holds
/// it. The form, the project file, the command line's flags, the validation and the tables in the README come
/// from it.
struct ParameterSpec {
    enum class Kind { Integer, Real, Boolean, Choice };

    std::string key;      ///< in project files and, after two dashes, on the command line: `search-scale`
    std::string label;    ///< in forms: "Search scale"
    std::string tooltip;  ///< one sentence for an artist
    std::string unit;     ///< "px", "°"; empty for a plain number
    Kind kind = Kind::Real;
    double minimum = 0;
    double maximum = 1;
    double step = 0;                   ///< of the form's arrows; the value itself may lie between steps
    std::vector<std::string> choices;  ///< of a Choice: its value is an index into these keys

    static ParameterSpec integer(std::string key, std::string label, std::string unit, double minimum,
                                 double maximum, std::string tooltip);
    static ParameterSpec real(std::string key, std::string label, std::string unit, double minimum,
                              double maximum, double step, std::string tooltip);
    static ParameterSpec boolean(std::string key, std::string label, std::string tooltip);
    static ParameterSpec choice(std::string key, std::string label, std::vector<std::string> choices,
                                std::string tooltip);

    /// "8..128 px", "on or off", "mask or seam".
    std::string rangeText() const;
    /// "32", "on", "seam".
    std::string valueText(double value) const;
    /// The inverse of valueText. Throws Error naming the key when the text is not such a value.
    double parse(std::string_view text) const;
    /// Throws Error naming the key, the value and the range when the value lies outside.
    void check(double value) const;
};

/// The specs of the parameters of one stage, bound to the members of its struct. Every value reads and writes
/// as a double: integers exactly up to 2^53, booleans as 0 or 1, choices as their index.
template <class Params>
class ParameterTable {
public:
    template <class Value>
    ParameterTable& add(Value Params::*member, ParameterSpec spec) {
        m_specs.push_back(std::move(spec));
        m_accessors.push_back(
            {[member](const Params& params) { return static_cast<double>(params.*member); },
             [member](Params& params, double value) { params.*member = static_cast<Value>(value); }});
        return *this;
    }

    const std::vector<ParameterSpec>& specs() const { return m_specs; }

    std::vector<double> values(const Params& params) const {
        std::vector<double> values;
        for (const Accessor& accessor : m_accessors) values.push_back(accessor.get(params));
        return values;
    }
    /// One value per spec, in order; members without a spec keep what they were.
    void assign(Params& params, std::span<const double> values) const {
        for (std::size_t i = 0; i < m_accessors.size(); ++i) m_accessors[i].set(params, values[i]);
    }
    /// Throws Error when a value lies outside its range.
    void check(const Params& params) const {
        for (std::size_t i = 0; i < m_accessors.size(); ++i) m_specs[i].check(m_accessors[i].get(params));
    }

private:
    struct Accessor {
        std::function<double(const Params&)> get;
        std::function<void(Params&, double)> set;
    };
    std::vector<ParameterSpec> m_specs;
    std::vector<Accessor> m_accessors;
};

/// An object with one member a spec, keyed by its key.
nlohmann::json parametersToJson(std::span<const ParameterSpec> specs, std::span<const double> values);
/// Overwrites the values whose keys are present. Throws Error, beginning with `subject`, when one is of the
/// wrong type or outside its range.
void parametersFromJson(const nlohmann::json& json, std::string_view subject,
                        std::span<const ParameterSpec> specs, std::span<double> values);

template <class Params>
auto parametersToJson(const Params& params) {
    return parametersToJson(Params::table().specs(), Params::table().values(params));
}
template <class Params>
void parametersFromJson(const nlohmann::json& json, std::string_view subject, Params& params) {
    std::vector<double> values = Params::table().values(params);
    parametersFromJson(json, subject, Params::table().specs(), values);
    Params::table().assign(params, values);
}

}  // namespace chiaro
