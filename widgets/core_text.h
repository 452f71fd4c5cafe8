#pragma once

#include "core/base/parameters.h"

#include <QString>

namespace chiaro::widgets {

/// The context of core's texts in translations: core knows no Qt, so tests/tools/core_texts.cpp lists them.
inline constexpr const char* coreContext = "Core";

/// A label, tooltip, unit or name of core's in the language of the studio; itself where it has no
/// translation, as names that the artist gave.
QString coreText(const std::string& english);

/// ParameterSpec::rangeText() and valueText() in the language of the studio.
QString rangeText(const ParameterSpec& spec);
QString valueText(const ParameterSpec& spec, double value);

}  // namespace chiaro::widgets
