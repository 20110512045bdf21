// Ticks and their labels: a table of ranges, and rules for random ranges.
#include "annotations/color_ticks.hpp"
#include "annotations/ticks.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace server::annotations {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string joined(const annotations::Scale& scale) {
    std::string out;
    for (const annotations::Tick& tick : scale.ticks) out += (out.empty() ? "" : " ") + tick.label;
    return out + annotations::times_power_of_ten(scale.exponent);
}

TEST(Ticks, AreRoundNumbersWithFewDigits) {
    struct Row {
        double low, high;
        int most;
        const char* labels;
    };
    const Row rows[] = {
        {0, 1, 6, "0.0 0.2 0.4 0.6 0.8 1.0"},
        {0, 1, 5, "0.0 0.5 1.0"},
        {-1, 1, 5, "−1.0 −0.5 0.0 0.5 1.0"},
        {0.1926, 4.9775, 6, "1 2 3 4"},
        {-7.81575, 14.3622, 10, "−5 0 5 10"},
        {0, 101325, 5, "0 50000 100000"},
        {1.2e-5, 3.4e-5, 5, "1.5 2.0 2.5 3.0 ×10⁻⁵"},
        {-4e12, 9e12, 7, "−4 −2 0 2 4 6 8 ×10¹²"},
        {500000, 500010, 6, "500000 500002 500004 500006 500008 500010"},
        {0.0012, 0.0021, 5, "0.0012 0.0014 0.0016 0.0018 0.0020"},
        {3, 3, 5, "3"},
        {0, 0, 5, "0"},
        {0.9, 1.1, 1, "1.0"},
        {0.31, 0.39, 1, "0.35"},
    };
    for (const Row& row : rows)
        EXPECT_EQ(joined(annotations::nice_scale(row.low, row.high, row.most)), row.labels)
            << row.low << ' ' << row.high;
}

TEST(Ticks, OfARangeThatIsNoneAreNone) {
    for (const auto& [low, high] : {std::pair(1.0, 0.0), {nan, 1.0}, {0.0, nan}, {-infinity, 0.0}, {0.0, infinity}})
        EXPECT_TRUE(annotations::nice_scale(low, high, 5).ticks.empty());
    EXPECT_TRUE(annotations::nice_scale(0, 1, 0).ticks.empty());
}

TEST(Ticks, ThatTheNumbersCannotTellApartAreOne) {
    EXPECT_EQ(annotations::nice_scale(1e9, std::nextafter(1e9, 2e9), 6).ticks.size(), 1U);
    EXPECT_EQ(annotations::nice_scale(5e-324, 1e-323, 6).ticks.size(), 1U);
    EXPECT_GE(annotations::nice_scale(-1e308, 1e308, 6).ticks.size(), 1U); // the width of the range overflows a double
}

double number(std::string label) {
    if (label.starts_with("−")) label.replace(0, std::string("−").size(), "-");
    return std::stod(label);
}

TEST(Ticks, OfAnyRangeAreEvenInsideAndSayTheirValue) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> mantissa(-10, 10), power(-30, 30), relative(-6, 1);
    for (int round = 0; round < 20000; ++round) {
        const double low = mantissa(random) * std::pow(10, std::floor(power(random)));
        const double span = std::max(std::abs(low), 1e-30) * std::pow(10, relative(random));
        const int most = 1 + round % 10;
        const annotations::Scale scale = annotations::nice_scale(low, low + span, most);
        ASSERT_LE(scale.ticks.size(), static_cast<std::size_t>(most));
        if (most >= 3) {
            ASSERT_GE(scale.ticks.size(), 1U) << low << ' ' << span << ' ' << most;
        }
        for (std::size_t i = 0; i < scale.ticks.size(); ++i) {
            const annotations::Tick& tick = scale.ticks[i];
            ASSERT_GE(tick.value, low - 1e-8 * span);
            ASSERT_LE(tick.value, low + span * (1 + 1e-8));
            ASSERT_NEAR(number(tick.label) * std::pow(10.0, scale.exponent), tick.value, 1e-3 * span) << tick.label;
            if (i < 2) continue;
            const double step = scale.ticks[1].value - scale.ticks[0].value;
            ASSERT_NEAR(tick.value - scale.ticks[i - 1].value, step, 1e-6 * step);
        }
    }
}

TEST(Numbers, HaveTheDigitsOfTheirSpan) {
    EXPECT_EQ(annotations::number_label(0.317423, 3.2, 0), "0.32");
    EXPECT_EQ(annotations::number_label(4.9775, 4.8, 0), "4.98");
    EXPECT_EQ(annotations::number_label(-0.001, 4.8, 0), "0");
    EXPECT_EQ(annotations::number_label(101325, 98000, 0), "101325");
    EXPECT_EQ(annotations::number_label(1.23456e-7, 1e-7, -7), "1.23");
    EXPECT_EQ(annotations::number_label(nan, 1, 0), "n/a");
    EXPECT_EQ(annotations::number_label(0, 0, 0), "0");
    EXPECT_EQ(annotations::number_label(0.35), "0.35");
    EXPECT_EQ(annotations::number_label(-12345.678), "−12345.7");
    EXPECT_EQ(annotations::number_label(2.5e-6), "2.5 ×10⁻⁶");
    EXPECT_EQ(annotations::number_label(0), "0");
    EXPECT_EQ(annotations::number_label(infinity), "n/a");
    EXPECT_EQ(annotations::number_label(4.39584e-6, 3), "4.4 ×10⁻⁶");
    EXPECT_EQ(annotations::number_label(4395.84, 3), "4396");
}

TEST(Numbers, OfALogarithmicScaleHaveThreeDigitsOverAPowerOfTen) {
    color::ColorScale scale;
    scale.log = true;
    scale.range = {4.39584e-6F, 4.39584F};
    EXPECT_EQ(annotations::label_on(scale, 4.39584), "4.4");
    scale.range = {4.39584F, 4.39876F};
    EXPECT_EQ(annotations::label_on(scale, 4.39876), "4.39876");
}

TEST(Units, AreWrittenAsPeopleDo) {
    EXPECT_EQ(annotations::pretty_units("m^2/s^2"), "m²/s²");
    EXPECT_EQ(annotations::pretty_units("kg m^-3"), "kg m⁻³");
    EXPECT_EQ(annotations::pretty_units("m^12"), "m¹²");
    for (const char* plain : {"", "Pa", "^", "m^", "m^-", "m^x", "°C"})
        EXPECT_EQ(annotations::pretty_units(plain), plain);
}

} // namespace
} // namespace server::annotations
