// NaN and infinity in legacy VTK files: the words that are replaced, and where they are left unchanged.
#include "import/parsers/legacy_vtk_numbers.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace server::importer {
namespace {

const std::string nan = stand_ins[0].text, inf = stand_ins[1].text, minus_inf = stand_ins[2].text;

std::string with_stand_ins(const std::string& text) {
    std::istringstream file(text);
    return importer::with_stand_ins(file);
}

bool holds(const std::string& text) {
    std::istringstream file(text);
    return holds_no_numbers(file);
}

TEST(LegacyVtkNumbers, EverySpellingHasItsStandIn) {
    EXPECT_EQ(with_stand_ins("1 nan -NaN 2.5e3\r\n"), "1 " + nan + " " + nan + " 2.5e3\r\n");
    EXPECT_EQ(with_stand_ins("inf +Inf -inf\nInfinity\t-INFINITY"),
              inf + " " + inf + " " + minus_inf + "\n" + inf + "\t" + minus_inf);
}

TEST(LegacyVtkNumbers, LinesThatNameSomethingAreLeftAlone) {
    for (const std::string line : {"SCALARS nan double 1", "inf 1 27 double", "info nan", "nan nano"})
        EXPECT_EQ(with_stand_ins(line), line);
    EXPECT_EQ(with_stand_ins("nan 1 27\n"), nan + " 1 27\n") << "nothing says that it is a name";
}

TEST(LegacyVtkNumbers, StandInsAreTheSameAsFloatsAndAsDoubles) {
    for (const StandIn& stand_in : stand_ins) {
        EXPECT_EQ(std::stod(stand_in.text), stand_in.number);
        EXPECT_EQ(std::stof(stand_in.text), static_cast<float>(stand_in.number));
    }
}

TEST(LegacyVtkNumbers, WordsOfOtherLibrariesHaveTheirStandIns) {
    EXPECT_EQ(with_stand_ins("-nan(ind) nan(0x1) -1.#IND 1.#QNAN 1.#INF -1.#INF"),
              nan + " " + nan + " " + nan + " " + nan + " " + inf + " " + minus_inf);
}

TEST(LegacyVtkNumbers, AreFoundAmongValuesAlone) {
    for (const char* text : {"1 nan", "1 2\n3 -inf\r\n", "inf"}) EXPECT_TRUE(holds(text)) << text;
    for (const char* text :
         {"", "1 2 3", "SCALARS inflow double", "METADATA\nINFORMATION 0\n", "resonance 1 27 double"})
        EXPECT_FALSE(holds(text)) << text;
}

} // namespace
} // namespace server::importer
