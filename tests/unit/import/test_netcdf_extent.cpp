// The file size that a netCDF header implies: closed forms, and wrong headers. tests/python/test_import_exodus.py
// compares with files of the netCDF library.
#include "import/parsers/netcdf_extent.hpp"

#include "ciel/types.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace server::importer {
using namespace ciel;
namespace {

std::string number(std::uint64_t value, int bytes = 4) {
    std::string text;
    for (int i = bytes; i-- > 0;) text += static_cast<char>(value >> 8 * i & 0xff);
    return text;
}

// Header of a file with a dimension x of 3, a record dimension t, doubles a(x) at byte 200, floats b(t, x) at byte 400,
// and two records.
std::string header(std::uint64_t records = 2, std::uint32_t length = 3, std::uint32_t type_of_a = 6) {
    const std::string x = number(1) + std::string("x\0\0\0", 4), t = number(1) + std::string("t\0\0\0", 4);
    const std::string no_list = number(0) + number(0);
    return "CDF\1" + number(records) + number(10) + number(2) + x + number(length) + t + number(0) + no_list +
           number(11) + number(2) + x + number(1) + number(0) + no_list + number(type_of_a) + number(24) + number(200) +
           t + number(2) + number(1) + number(0) + no_list + number(5) + number(12) + number(400);
}

std::optional<NetcdfExtent> extent_of(const std::string& content) {
    std::istringstream file(content);
    return read_netcdf_extent(file, "a.exo");
}

TEST(NetcdfExtent, FixedVariablesEndWhereTheLastOneDoes) {
    const auto extent = extent_of(header());
    ASSERT_TRUE(extent);
    EXPECT_EQ(extent->fixed_end, 224U);
    EXPECT_EQ(extent->record_begin, 400U);
    EXPECT_EQ(extent->record_bytes, 12U);
    EXPECT_EQ(extent->records, 2U);
}

TEST(NetcdfExtent, RecordsThatAreNotWholeDoNotCount) {
    const auto extent = extent_of(header());
    ASSERT_TRUE(extent);
    for (const auto& [bytes, whole] : {std::pair{0U, 0U},
                                       {400U, 0U},
                                       {408U, 0U},
                                       {411U, 0U},
                                       {412U, 1U},
                                       {420U, 1U},
                                       {423U, 1U},
                                       {424U, 2U},
                                       {9999U, 2U}})
        EXPECT_EQ(extent->records_within(bytes), whole) << bytes;
}

TEST(NetcdfExtent, OtherFilesAreNoneOfThese) {
    for (const std::string& content :
         {std::string(), std::string("CD"), std::string("\x89HDF\r\n\x1a\n"), std::string("CDF\3")})
        EXPECT_FALSE(extent_of(content)) << content;
}

TEST(NetcdfExtent, HeadersThatLieAreRefused) {
    const auto refusal = [](const std::string& content) -> std::string {
        try {
            (void)extent_of(content);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    const std::string whole = header();
    for (std::size_t length = 4; length < whole.size(); ++length)
        EXPECT_EQ(refusal(whole.substr(0, length)), "a.exo: its netCDF header is cut off") << length;
    EXPECT_EQ(refusal(header(2, 3, 99)), "a.exo: its netCDF header is damaged") << "a type that does not exist";
    EXPECT_EQ(refusal("CDF\1" + number(0) + number(12) + number(1)), "a.exo: its netCDF header is damaged")
        << "another tag";
    EXPECT_EQ(refusal("CDF\1" + number(0) + number(10) + number(0xffffffff)), "a.exo: its netCDF header is damaged");
    EXPECT_EQ(refusal("CDF\5" + number(0, 8) + number(10) + number(1, 8) + number(~std::uint64_t{0} - 2, 8)),
              "a.exo: its netCDF header is damaged")
        << "a name of 16 exabytes";
}

} // namespace
} // namespace server::importer
