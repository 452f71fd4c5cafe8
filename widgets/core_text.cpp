#include "widgets/core_text.h"

#include <QtCore>

namespace chiaro::widgets {

namespace {

struct CoreText {
    Q_DECLARE_TR_FUNCTIONS(chiaro::widgets::CoreText)
};

QString number(double value) {
    return QLocale().toString(value, 'g', QLocale::FloatingPointShortest);
}

}  // namespace

QString coreText(const std::string& english) {
    return english.empty() ? QString() : QCoreApplication::translate(coreContext, english.c_str());
}

QString rangeText(const ParameterSpec& spec) {
    if (spec.kind == ParameterSpec::Kind::Boolean) return CoreText::tr("on or off");
    if (spec.kind == ParameterSpec::Kind::Choice) {
        QStringList choices;
        for (const std::string& choice : spec.choices) choices << coreText(choice);
        if (choices.size() == 2) return CoreText::tr("%1 or %2").arg(choices.front(), choices.back());
        return choices.join(", ");
    }
    const QString unit = spec.unit.empty() ? QString() : " " + coreText(spec.unit);
    return CoreText::tr("%1 to %2", "a range").arg(number(spec.minimum), number(spec.maximum)) + unit;
}

QString valueText(const ParameterSpec& spec, double value) {
    if (spec.kind == ParameterSpec::Kind::Boolean)
        return value != 0 ? CoreText::tr("on") : CoreText::tr("off");
    if (spec.kind == ParameterSpec::Kind::Choice) return coreText(spec.valueText(value));
    return number(value);
}

}  // namespace chiaro::widgets
