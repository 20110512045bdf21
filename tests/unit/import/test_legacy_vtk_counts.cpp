#include "ciel/types.hpp"
#include "import/parsers/legacy_vtk_counts.hpp"

#include <gmock/gmock.h>
#include <sstream>

namespace server::importer {
using namespace ciel;
namespace {

// Returns the message of the refusal, or an empty string. `size`: file size in bytes; 0 for the length of the content.
std::string refusal(const std::string& content, std::uint64_t size = 0) {
    std::istringstream file(content);
    try {
        check_legacy_vtk_counts(file, size != 0 ? size : content.size(), "a.vtk");
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

std::string text(const std::string& body) { return "# vtk DataFile Version 3.0\nbinary\nASCII\n" + body; }
std::string binary(const std::string& body) { return "# vtk DataFile Version 3.0\nPOINTS 9e9 int\nBINARY\n" + body; }

TEST(LegacyVtkCounts, what_fits_is_accepted) {
    EXPECT_EQ(refusal(text("DATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\n"
                           "CELL_TYPES 1\n10\nPOINT_DATA 4\nSCALARS cells float 1\nLOOKUP_TABLE default\n1 2 3 4\n"
                           "SCALARS points int\nLOOKUP_TABLE t\n400000 2 3 4\nTEXTURE_COORDINATES t 2 float\n"
                           "0 0 0 0 0 0 0 0\nFIELD FieldData 3\nfield 3 4 float\n1 2 3 4 5 6 7 8 9 1 2 3\n"
                           "cells 1 4 int\n1 2 3 4\nempty 0 4 string\n")),
              "");
    EXPECT_EQ(refusal(""), "");
    EXPECT_EQ(refusal("no such file"), "");
}

TEST(LegacyVtkCounts, every_count_is_held_against_the_size) {
    for (const std::string declaration :
         {"POINTS 5000000000 float", "points 99999999999999999999 double", "CELLS 1 5000000000", "CELLS 5000000000 1",
          "POLYGONS 900 900", "CELL_TYPES 5000000000", "X_COORDINATES 500 float", "POINT_DATA 5000000000",
          "CELL_DATA 5000000000", "FIELD FieldData 2000000000", "a 1 5000000000 float", "a 4000000000 4000000000 int",
          "POINT_DATA 4\nSCALARS s float 2000000000", "POINT_DATA 4\nCOLOR_SCALARS s 2000000000",
          "POINT_DATA 4\nTEXTURE_COORDINATES t 2000000000 float", "b 1 5000 bit", "POINTS\n5000000000\nfloat"}) {
        const std::string sentence = refusal(text(declaration + "\n1 2 3\n"));
        EXPECT_THAT(sentence, ::testing::StartsWith("a.vtk: declares \"")) << declaration;
        EXPECT_THAT(sentence, ::testing::HasSubstr("has only")) << declaration;
    }
    EXPECT_THAT(refusal(text("POINTS 5000000000 float\n")), ::testing::HasSubstr("points 5000000000 float"));
    EXPECT_EQ(refusal(text("b 1 400 bit\n")), "") << "eight to a byte";
}

TEST(LegacyVtkCounts, negative_counts_are_refused) {
    for (const char* declaration : {"POINTS -1 float", "CELLS -1 4", "CELLS 1 -4", "a -1 4 float", "a 1 -4 float"})
        EXPECT_THAT(refusal(text(std::string(declaration) + "\n")), ::testing::HasSubstr("negative")) << declaration;
}

TEST(LegacyVtkCounts, binary_values_are_not_taken_for_words) {
    const std::string values = "\nPOINTS 999999 int \n 1234567";
    ASSERT_EQ(values.size() % 4, 0U);
    const std::string count = std::to_string(values.size() / 4);
    EXPECT_EQ(refusal(binary("FIELD f 1\na 1 " + count + " float\n" + values)), "");
    EXPECT_NE(refusal(text("FIELD f 1\na 1 " + count + " float\n" + values)), "");
    EXPECT_NE(refusal(binary("FIELD f 1\na 1 " + count + " float\n" + values + "\nPOINTS 999999 int\n")), "");
    EXPECT_EQ(refusal(binary("POINTS 4 float \n"), 1000), "") << "cut short: VTK says so";
}

} // namespace
} // namespace server::importer
