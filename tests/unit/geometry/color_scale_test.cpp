// Color scales made from a scene's `color`, by cases in a file that the web client's tests use, too.
#include "annotations/color_ticks.hpp"
#include "annotations/ticks.hpp"
#include "geometry/color_scale_of.hpp"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numeric>

namespace server::geometry {
namespace {

using nlohmann::json;

const json& cases() {
    static const json document = json::parse(std::ifstream(CIEL_SOURCE_DIR "/tests/support/color_cases.json"));
    return document;
}

scene::Coloring coloring_of(const json& words) {
    json document{{"dataset", "d"}, {"layers", {{"s", {{"type", "surface"}, {"color", words}}}}}};
    return std::get<scene::SurfaceLayer>(scene::parse(document).layers.at(0).kind).color;
}

std::string hex(const color::Rgb8& color) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", color[0], color[1], color[2]);
    return text.data();
}

TEST(ColorScale, FollowsTheCasesWorkedOutByHand) {
    for (const json& one : cases()["cases"]) {
        SCOPED_TRACE(one["name"].get<std::string>());
        const auto scale = color_scale_of(coloring_of(one["coloring"]), one["data"]);
        const auto range = one["range"].get<std::array<float, 2>>();
        EXPECT_FLOAT_EQ(scale.range[0], range[0]);
        EXPECT_FLOAT_EQ(scale.range[1], range[1]);
        for (const json& row : one["colors"]) {
            const double value = row[0].is_null() ? NAN : row[0].get<double>();
            EXPECT_EQ(hex(color_of(scale, value)), row[1].get<std::string>()) << row[0];
        }
        if (!one.contains("ticks")) continue;
        const auto ticks = annotations::color_ticks(scale);
        ASSERT_EQ(ticks.size(), one["ticks"].size());
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            const json& row = one["ticks"][i];
            EXPECT_NEAR(ticks[i].value, row[0].get<double>(), 1e-6 * std::abs(row[0].get<double>())) << i;
            EXPECT_NEAR(ticks[i].at, row[1].get<double>(), 1e-6) << i;
            EXPECT_EQ(ticks[i].label, row[2].get<std::string>()) << i;
        }
    }
}

const json& tick_cases() {
    static const json document = json::parse(std::ifstream(CIEL_SOURCE_DIR "/tests/support/tick_cases.json"));
    return document;
}

double number_of(const json& value) { return value.is_null() ? NAN : value.get<double>(); }

TEST(ColorScale, MarksOfALinearScaleFollowTheCases) {
    for (const json& row : tick_cases()["scales"]) {
        const annotations::Scale scale = annotations::nice_scale(row[0], row[1], row[2]);
        std::string labels;
        for (const annotations::Tick& tick : scale.ticks) labels += (labels.empty() ? "" : " ") + tick.label;
        EXPECT_EQ(labels + annotations::times_power_of_ten(scale.exponent), row[3].get<std::string>()) << row;
    }
}

TEST(ColorScale, NumbersFollowTheCases) {
    for (const json& row : tick_cases()["numbers"])
        EXPECT_EQ(annotations::number_label(number_of(row[0]), row[1], row[2]), row[3].get<std::string>()) << row;
    for (const json& row : tick_cases()["alone"])
        EXPECT_EQ(annotations::number_label(number_of(row[0])), row[1].get<std::string>()) << row;
    for (const json& row : tick_cases()["rounded"])
        EXPECT_EQ(annotations::number_label(row[0].get<double>(), row[1].get<int>()), row[2].get<std::string>()) << row;
}

TEST(ColorScale, OfManyStepsOnlyMarksThatCanBeToldApartFollowTheCases) {
    for (const json& row : tick_cases()["marks"])
        for (const bool log : {false, true}) {
            color::ColorScale scale;
            scale.steps = row[0];
            scale.log = log;
            scale.range = {1, 1e4F};
            const auto ticks = annotations::color_ticks(scale, 6, row[1]);
            const int steps = row[0], marks = row[2], labels = row[3];
            ASSERT_EQ(ticks.size(), row[4].get<std::size_t>()) << row;
            for (int i = 0; i < row[4]; ++i) {
                const annotations::ColorTick& tick = ticks[static_cast<std::size_t>(i)];
                EXPECT_NEAR(tick.at, static_cast<double>(i) * marks / steps, 1e-9) << row;
                EXPECT_EQ(tick.label.empty(), i * marks % labels != 0) << row;
            }
        }
}

TEST(ColorScale, TakesACommonPowerOfTenOutOfItsNumbersUnlessItIsLogarithmic) {
    color::ColorScale scale;
    scale.range = {1.2e-5F, 3.4e-5F};
    EXPECT_EQ(annotations::exponent_of(scale), -5);
    EXPECT_EQ(annotations::label_on(scale, 2.5e-5), "2.5");
    scale.log = true;
    EXPECT_EQ(annotations::exponent_of(scale), 0);
    EXPECT_EQ(annotations::label_on(scale, 2.5e-5), "2.5 ×10⁻⁵");
    EXPECT_EQ(annotations::label_on(scale, 1e-5), "10⁻⁵");
}

// Ticks at powers of ten are slightly off because of rounding. Their labels must not get a mantissa of 10.
TEST(ColorScale, NoLabelOfALogarithmicScaleHasTenBeforeItsPower) {
    for (const int decades : {1, 6, 12})
        for (int low = -30; low <= 20; ++low)
            for (const int steps : {0, 5, 6, 10, 12}) {
                color::ColorScale scale;
                scale.log = true;
                scale.steps = steps;
                scale.range = {static_cast<float>(std::pow(10.0, low)),
                               static_cast<float>(std::pow(10.0, low + decades))};
                for (const annotations::ColorTick& tick : annotations::color_ticks(scale))
                    EXPECT_FALSE(tick.label.starts_with("10 ×")) << tick.label << " from " << low;
                EXPECT_FALSE(annotations::label_on(scale, scale.range[1]).starts_with("10 ×")) << low;
            }
}

TEST(ColorScale, TicksStayInsideAndInOrderWhateverTheRange) {
    for (const bool log : {false, true})
        for (const int steps : {0, 2, 7, 256})
            for (const auto& range : std::vector<std::array<double, 2>>{
                     {1, 1.0000001F}, {1e-30F, 1e30F}, {1e-37F, 1}, {99999, 100001}, {3, 3e12F}, {1e35F, 3e38F}}) {
                color::ColorScale scale;
                scale.log = log;
                scale.steps = steps;
                scale.range = range;
                const auto ticks = annotations::color_ticks(scale);
                ASSERT_FALSE(ticks.empty());
                EXPECT_LE(ticks.size(), 300U) << range[0] << ' ' << range[1];
                int labels = 0;
                for (std::size_t i = 0; i < ticks.size(); ++i) {
                    EXPECT_GE(ticks[i].at, i > 0 ? ticks[i - 1].at : 0.0);
                    EXPECT_LE(ticks[i].at, 1);
                    labels += ticks[i].label.empty() ? 0 : 1;
                }
                EXPECT_GE(labels, 1) << log << ' ' << steps << ' ' << range[0] << ' ' << range[1];
                EXPECT_LE(labels, 14) << log << ' ' << steps << ' ' << range[0] << ' ' << range[1];
            }
}

// Ranges with ends or a width beyond float32, with subnormal ends, narrow ones far from zero, and ranges of one value.
TEST(ColorScale, AnyRangeHasEndsThatAreWrittenAndAFiniteWidth) {
    for (const auto& range : {std::array{-1e308, 1e308},
                              {-3.4e38, 3.4e38},
                              {0.0, 1e308},
                              {1e-42, 3e-42},
                              {5e-324, 1e-320},
                              {1e9, 1e9 + 1e-3},
                              {1e9, 1e9 + 1000},
                              {-1e37, 1e-30},
                              {5.0, 5.0},
                              {0.0, 0.0}}) {
        scene::Coloring coloring;
        coloring.array = "p";
        coloring.range = range;
        const color::ColorScale scale = color_scale_of(coloring, {0, 1});
        const double width = static_cast<float>(scale.range[1] - scale.range[0]);
        ASSERT_TRUE(std::isfinite(scale.range[0]) && std::isfinite(scale.range[1]) && width >= 0) << range[0];
        EXPECT_EQ(color::has_width(scale), width > 0);
        if (width > 0) {
            EXPECT_TRUE(std::isnormal(static_cast<float>(std::min(1 / width, 3e38)))) << range[1];
        }
        for (const double end : scale.range) {
            EXPECT_NE(annotations::label_on(scale, end), "n/a") << range[0];
            EXPECT_LT(annotations::label_on(scale, end).size(), 15U) << annotations::label_on(scale, end);
        }
        double before = -INFINITY;
        const auto ticks = annotations::color_ticks(scale, 6);
        EXPECT_GE(ticks.size(), 1U);
        for (const annotations::ColorTick& tick : ticks) {
            EXPECT_TRUE(tick.value > before && tick.at >= 0 && tick.at <= 1) << range[0] << ' ' << tick.value;
            EXPECT_NE(tick.label, "n/a");
            before = tick.value;
        }
        const double middle = std::midpoint(scale.range[0], scale.range[1]);
        if (width > 1e-30) {
            EXPECT_NEAR(color::place_of(scale, middle), 0.5, 1e-3);
        }
    }
}

// The legend of a given range shows the numbers of the scene, not the nearest floats.
TEST(ColorScale, ARangeThatWasGivenIsWrittenAsItWas) {
    for (const json& row : cases()["ends"]) {
        const auto scale = color_scale_of(coloring_of(row[0]), {0, 1});
        std::vector<std::string> labels{annotations::label_on(scale, scale.range[0]),
                                        annotations::label_on(scale, scale.range[1])};
        for (const annotations::ColorTick& tick : annotations::color_ticks(scale)) labels.push_back(tick.label);
        EXPECT_EQ(labels, row[1].get<std::vector<std::string>>()) << row;
    }
}

TEST(ColorScale, WhatIsSentHasTheMembersThatAreNotTheDefault) {
    EXPECT_EQ(json_of(color::ColorScale()), json::object());
    const json words = {{"reverse", true},
                        {"log", true},
                        {"steps", 7},
                        {"nan", "#010203"},
                        {"below", "#0a0b0c"},
                        {"above", "#ff00ff"},
                        {"points", {{{"at", 0.0}, {"color", "#000000"}}, {{"at", 1.0}, {"color", "#fffffe"}}}}};
    EXPECT_EQ(json_of(color_scale_of(coloring_of(words), {1, 2})), words);
}

TEST(ColorScale, DataWithoutALogarithmAreSaidNotToBeShown) {
    const auto logarithmic = coloring_of({{"log", true}});
    EXPECT_TRUE(is_shown_by(logarithmic, {-1, 2}));
    EXPECT_FALSE(is_shown_by(logarithmic, {-1, 0}));
    EXPECT_TRUE(is_shown_by(coloring_of({{"log", true}, {"range", {1, 2}}}), {-1, 0}))
        << "whoever gives a range wants it";
    EXPECT_TRUE(is_shown_by(coloring_of(json::object()), {-1, 0}));
}

} // namespace
} // namespace server::geometry
