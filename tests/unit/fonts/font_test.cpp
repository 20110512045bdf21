// Text shaping with FreeType, and UTF-8 decoding against the examples of the Unicode standard.
#include "ciel/types.hpp"
#include "fonts/font.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::fonts {
using namespace ciel;
namespace {

TEST(Utf8, IsDecodedAndWhatIsNoneBecomesReplacements) {
    struct Row {
        std::string bytes;
        std::u32string text;
    };
    const Row rows[] = {
        {"m/s²", U"m/s²"},
        {"µ°∂×10⁻⁵", U"µ°∂×10⁻⁵"},
        {"\xF0\x9F\x8C\x8A", U"\U0001F30A"},
        {"", U""},
        {"a\x80z", U"a\uFFFDz"},
        {"\xC0\xAF", U"\uFFFD\uFFFD"},                                          // overlong encoding
        {"\xE0\x80\xAF", U"\uFFFD\uFFFD\uFFFD"},                                // overlong encoding
        {"\xED\xA0\x80", U"\uFFFD\uFFFD\uFFFD"},                                // surrogate
        {"\xF4\x90\x80\x80", U"\uFFFD\uFFFD\uFFFD\uFFFD"},                      // beyond U+10FFFF
        {"\xE1\x80\xE2\xF0\x91\x92\xF1\xBF\x41", U"\uFFFD\uFFFD\uFFFD\uFFFDA"}, // table 3-11 of Unicode 15
        {"\xF1", U"\uFFFD"},
        {"\xE2\x82", U"\uFFFD"},
        {std::string("a\0b", 3), std::u32string(U"a\0b", 3)},
    };
    for (const Row& row : rows) EXPECT_EQ(decode_utf8(row.bytes), row.text) << row.bytes;
}

TEST(Font, WidthGrowsWithTheSizeAndTheText) {
    Font font;
    const int at_13 = font.shape("Velocity", 13).width;
    EXPECT_NEAR(font.shape("Velocity", 130).width, 10 * at_13, 10);
    EXPECT_GT(font.shape("Velocity m/s", 13).width, at_13);
    EXPECT_EQ(font.shape("", 13).width, 0);
    EXPECT_EQ(font.shape("0", 100).width, font.shape("7", 100).width) << "digits stand below each other";
}

TEST(Font, PairsAreKerned) {
    Font font;
    const int apart = font.shape("A", 200).width + font.shape("V", 200).width;
    EXPECT_LT(font.shape("AV", 200).width, apart - 5);
}

TEST(Font, WhatItLacksIsABoxAndControlCharactersAreSpaces) {
    Font font;
    const Line line = font.shape("\U00012000", 40); // cuneiform sign, which no installed font has
    ASSERT_EQ(line.glyphs.size(), 1U);
    EXPECT_EQ(line.glyphs[0].glyph, 0U);
    EXPECT_GT(font.draw(0, 40).width, 5);
    const Line unit = font.shape("m/s² µ ° ⁻⁵ × ∂ − …", 40);
    EXPECT_TRUE(std::all_of(unit.glyphs.begin(), unit.glyphs.end(), [](const PlacedGlyph& g) { return g.glyph != 0; }));
    EXPECT_EQ(font.shape("\n", 40).glyphs[0].glyph, font.shape(" ", 40).glyphs[0].glyph);
    EXPECT_EQ(font.draw(font.shape(" ", 40).glyphs[0].glyph, 40).width, 0);
}

// The second font is fonts-wqy-microhei (deploy/packages.txt).
TEST(Font, WhatItLacksIsTakenFromAnotherFontOfTheMachine) {
    Font font;
    const Line line = font.shape("p 压力 圧力 압력", 40);
    ASSERT_EQ(line.glyphs.size(), 10U);
    for (const PlacedGlyph& placed : line.glyphs) EXPECT_NE(placed.glyph, 0U) << "install fonts-wqy-microhei";
    const GlyphImage sign = font.draw(line.glyphs[2].glyph, 40);
    EXPECT_GT(sign.width, 30);
    EXPECT_LT(sign.height, 60);
    EXPECT_NEAR(line.glyphs[3].x - line.glyphs[2].x, 40, 1) << "an em wide";
    EXPECT_NE(font.draw(line.glyphs[3].glyph, 40).coverage, sign.coverage);
    EXPECT_EQ(font.draw(font.shape("力", 40).glyphs[0].glyph, 40).coverage,
              font.draw(line.glyphs[6].glyph, 40).coverage);
    EXPECT_EQ(line.glyphs[0].glyph, Font().shape("p", 40).glyphs[0].glyph) << "its own letters stay its own";
    EXPECT_EQ(font.metrics(40).ascent, Font().metrics(40).ascent);
    const int before = font.draw(line.glyphs[2].glyph, 20).width;
    EXPECT_LT(before, sign.width) << "at every size";
    EXPECT_EQ(font.draw(line.glyphs[2].glyph, 40).width, sign.width);
}

TEST(Font, GlyphsHaveSolidLettersWithAHaloAroundThem) {
    Font font;
    for (const int pixels : {9, 13, 40, 200}) {
        const GlyphImage image = font.draw(font.shape("I", pixels).glyphs[0].glyph, pixels);
        ASSERT_EQ(image.coverage.size(), 2U * static_cast<std::size_t>(image.width * image.height));
        long letter = 0;
        long halo = 0;
        for (std::size_t i = 0; i < image.coverage.size(); i += 2) {
            letter += image.coverage[i];
            halo += image.coverage[i + 1];
            EXPECT_LE(image.coverage[i], image.coverage[i + 1] + 40) << "the halo lies under all of the letter";
        }
        EXPECT_GT(letter, 0);
        EXPECT_GT(halo, letter * 5 / 4) << pixels;
        EXPECT_GT(image.top, font.metrics(pixels).digit / 2);
    }
}

TEST(Font, ThatIsNotThereIsNamedWithItsPackage) {
    Font font("/nowhere/font.ttf");
    EXPECT_THAT([&] { static_cast<void>(font.shape("a", 13)); },
                testing::ThrowsMessage<Error>(testing::AllOf(testing::HasSubstr("font font.ttf"),
                                                             testing::Not(testing::HasSubstr("/nowhere")),
                                                             testing::HasSubstr("fonts-dejavu-core"))));
    Font text(CIEL_SOURCE_DIR "/README.md");
    EXPECT_THROW(static_cast<void>(text.metrics(13)), Error);
}

} // namespace
} // namespace server::fonts
