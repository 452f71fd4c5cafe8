#include "core/base/parameters.h"

#include "core/base/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace chiaro {
namespace {

struct Brush {
    enum class Tip { Round, Flat };
    int width = 32;
    double load = 0.5;
    bool dry = true;
    Tip tip = Tip::Flat;

    static const ParameterTable<Brush>& table() {
        static const auto table =
            ParameterTable<Brush>()
                .add(&Brush::width, ParameterSpec::integer("width", "Width", "px", 8, 128, "How wide."))
                .add(&Brush::load, ParameterSpec::real("load", "Load", "", 0, 1, 0.1, "How much paint."))
                .add(&Brush::dry, ParameterSpec::boolean("dry", "Dry", "No water."))
                .add(&Brush::tip, ParameterSpec::choice("tip", "Tip", {"round", "flat"}, "Its shape."));
        return table;
    }
};

const ParameterSpec& spec(int index) {
    return Brush::table().specs()[std::size_t(index)];
}

TEST(Parameters, TextsSayWhatAValueMayBe) {
    EXPECT_EQ(spec(0).rangeText(), "8..128 px");
    EXPECT_EQ(spec(2).rangeText(), "on or off");
    EXPECT_EQ(spec(3).rangeText(), "round or flat");
    EXPECT_EQ(spec(0).valueText(32), "32");
    EXPECT_EQ(spec(2).valueText(0), "off");
    EXPECT_EQ(spec(3).valueText(1), "flat");
}

TEST(Parameters, ParseIsTheInverseOfText) {
    EXPECT_EQ(spec(0).parse("64"), 64);
    EXPECT_EQ(spec(1).parse("0.25"), 0.25);
    EXPECT_EQ(spec(2).parse("on"), 1);
    EXPECT_EQ(spec(3).parse("flat"), 1);
    for (const char* text : {"", "7", "129", "1.5", "wide", "64px"})
        EXPECT_THROW(spec(0).parse(text), Error) << text;
    EXPECT_THROW(spec(3).parse("square"), Error);
    EXPECT_THROW(spec(1).parse("nan"), Error);
}

TEST(Parameters, RangesAreChecked) {
    EXPECT_NO_THROW(Brush::table().check({}));
    EXPECT_THROW(Brush::table().check({.width = 7}), Error);
    EXPECT_THROW(Brush::table().check({.load = 1.01}), Error);
    EXPECT_THROW(Brush::table().check({.load = std::numeric_limits<double>::quiet_NaN()}), Error);
}

TEST(Parameters, SurviveJson) {
    const Brush brush{16, 0.125, false, Brush::Tip::Round};
    Brush read;
    parametersFromJson(parametersToJson(brush), "brush", read);
    EXPECT_EQ(Brush::table().values(read), Brush::table().values(brush));
}

TEST(Parameters, JsonKeepsWhatItDoesNotNameAndRefusesWrongValues) {
    Brush brush;
    parametersFromJson(nlohmann::json{{"width", 64}}, "brush", brush);
    EXPECT_EQ(brush.width, 64);
    EXPECT_EQ(brush.load, 0.5);
    for (const nlohmann::json& json : {nlohmann::json{{"width", 1000}}, nlohmann::json{{"width", "wide"}},
                                       nlohmann::json{{"tip", "square"}}})
        EXPECT_THROW(parametersFromJson(json, "brush", brush), Error) << json;
    EXPECT_EQ(brush.width, 64);
}

}  // namespace
}  // namespace chiaro
