// zarr-python reads a dataset of the store, and appends a step that an open dataset finds.
#include "store/format/zarr_array.hpp"
#include "store/mesh_arrays.hpp"
#include "support/store_box/box.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::store {
using namespace ciel;
namespace {

TEST(Zarr, PythonReadsAndAppends) {
    const std::string python = "/usr/bin/python3";
    if (std::system((python + " -c 'import zarr' 2>/dev/null").c_str()) != 0)
        GTEST_SKIP() << "python3-zarr is not installed";
    const test::Folder scratch;
    const auto directory = scratch / "box.ciel";
    test::write_box(directory, test::box(2, 2, 2));
    const auto dataset = Dataset::open(directory);
    ASSERT_EQ(
        std::system((python + " " CIEL_SOURCE_DIR "/tests/unit/store/zarr_append.py " + directory.string()).c_str()),
        0);
    const auto now = dataset->refreshed();
    ASSERT_NE(now, nullptr);
    ASSERT_EQ(now->steps().size(), 4U);
    std::vector<float> expected(27);
    std::iota(expected.begin(), expected.end(), 100.0F);
    EXPECT_THAT(now->values("p", 3), testing::ElementsAreArray(expected));
    EXPECT_THAT(now->steps()[3].arrays.at("p").range, testing::ElementsAre(100, 126)) << "found by the reader";
    EXPECT_TRUE(now->values("U", 3).empty());
    EXPECT_EQ(now->mesh_arrays().points(0, now->steps()[3].coordinates).positions[0], 1) << "moved";

    Writer writer = Writer::append(directory); // appends after a step that zarr-python wrote
    const ArrayInfo info{"p", Association::point, 1, "Pa", ""};
    writer.add_step(2.0, 0, 0, std::vector<ArrayValues>{{info, expected}});
    const auto later = now->refreshed();
    EXPECT_THAT(later->values("p", 4), testing::ElementsAreArray(expected));
    EXPECT_EQ(later->mesh_arrays().points(0, 1).positions[0], 1) << "what came by plain Zarr is kept";
}

TEST(Zarr, ABareNaNOfZarrPython3IsRead) {
    const std::string text = R"({"zarr_format": 2, "shape": [2, 27], "chunks": [1, 27], "dtype": "<f4", "order": "C",
        "compressor": null, "filters": null, "fill_value": NaN})";
    EXPECT_EQ(to_text(parse_zarr_array(text, "p")), to_text(ZarrArray{ElementType::f4, {2, 27}, {1, 27}}));
    for (const char* damaged : {R"({"fill_value")", R"({"fill_value" )", R"({"fill_value":)", R"({"fill_value": )",
                                R"({"fill_value": Na)", R"({"fill_value": NaNa})"})
        EXPECT_THROW((void)parse_zarr_array(damaged, "p"), Error) << damaged;
}

} // namespace
} // namespace server::store
