// Histograms. Those stored beside arrays equal the counts of the values.
#include "store/format/histogram.hpp"

#include "store/format/layout.hpp"
#include "store/loaded.hpp"
#include "store/no_value.hpp"
#include "support/store_box/box.hpp"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace server::store {
using namespace ciel;
namespace {

using testing::ElementsAre;

TEST(HistogramTest, CountsWhatLiesInEachBin) {
    Histogram histogram({0, 4}, 4);
    histogram.add(std::vector<float>{0, 0.5F, 1, 3.999F, 4, -0.001F, 4.001F, 7, INFINITY, NAN});
    histogram.add(std::vector<double>{2, 2, std::nextafter(2, 0)});
    EXPECT_THAT(histogram.counts, ElementsAre(2, 2, 2, 2));
    EXPECT_EQ(histogram.below, 1U);
    EXPECT_EQ(histogram.above, 2U);
    EXPECT_EQ(histogram.invalid, 2U);
}

TEST(HistogramTest, OfEqualValuesHasThemInTheFirstBin) {
    const Histogram histogram = histogram_of(std::vector<float>{3, NAN, 3}, 4);
    EXPECT_EQ(histogram.range, (std::array{3.0, 3.0}));
    EXPECT_THAT(histogram.counts, ElementsAre(2, 0, 0, 0));
    EXPECT_EQ(histogram_of(std::vector<float>{NAN}, 4).range, (std::array{0.0, 0.0}));
}

// Merging bins (with_bins) gives the same counts as counting with fewer bins, also for values at the edges of bins and
// for ranges whose width is subnormal or overflows.
TEST(HistogramTest, FewerBinsAreThoseThatCountingGives) {
    std::mt19937 random(7);
    const std::vector<std::array<double, 2>> ranges{{0, 1},      {-3, 1e-3},          {101325, 101325.001},
                                                    {0, 5e-322}, {-1.7e308, 1.7e308}, {1e-310, 3e-310},
                                                    {0.1, 0.7},  {-1e300, 12},        {5, 5}};
    for (const auto& range : ranges) {
        std::vector<double> values{range[0], range[1]};
        std::uniform_real_distribution<double> share(-0.01, 1.01);
        for (int i = 0; i < 5000; ++i) values.push_back(std::lerp(range[0], range[1], share(random)));
        for (int edge = 0; edge <= 256; ++edge)
            for (const double towards : {-INFINITY, INFINITY}) {
                values.push_back(std::lerp(range[0], range[1], edge / 256.0));
                values.push_back(std::nextafter(values.back(), towards));
            }
        Histogram fine(range, stored_bins);
        fine.add(values);
        for (std::size_t bins = 1; bins <= stored_bins; bins *= 2) {
            Histogram counted(range, bins);
            counted.add(values);
            EXPECT_EQ(fine.with_bins(bins), counted) << bins << " bins of " << range[0] << " to " << range[1];
        }
    }
    const Histogram of_twelve({0, 1}, 12);
    EXPECT_TRUE(of_twelve.with_bins(3));
    for (const std::size_t bins : {0U, 4U, 5U, 24U}) EXPECT_FALSE(of_twelve.with_bins(bins)) << bins;
}

TEST(HistogramTest, HasQuantiles) {
    Histogram histogram({10, 14}, 4);
    histogram.counts = {2, 0, 6, 2};
    EXPECT_EQ(histogram.quantile(0), 10);
    EXPECT_EQ(histogram.quantile(0.1), 10.5);
    EXPECT_EQ(histogram.quantile(0.2), 11);
    EXPECT_EQ(histogram.quantile(0.5), 12.5);
    EXPECT_EQ(histogram.quantile(1), 14);
    histogram.below = 10;
    EXPECT_EQ(histogram.quantile(0.2), 10) << "it lies below the range";
    EXPECT_EQ(histogram.quantile(0.75), 12.5);
    histogram.above = 20;
    EXPECT_EQ(histogram.quantile(0.9), 14) << "it lies above the range";
    EXPECT_EQ(Histogram({-1, 1}, 4).quantile(0.5), -1) << "of no values";
}

// Arrays on points, cells and boundary faces, floats and doubles, with missing and wrong values.
class StoredHistogramTest : public testing::Test {
protected:
    StoredHistogramTest() {
        const FaceMesh mesh = test::box(12, 11, 10);
        const std::size_t vertices = mesh.positions.size() / 3, cells = mesh.cell_types.size();
        const auto boundary = static_cast<std::size_t>(std::ranges::count(mesh.neighbour, none));
        Writer writer(directory, {"test", "box", 0, 0, 0, {}});
        writer.add_mesh(mesh, test::identity(vertices), test::identity(cells), {});
        writer.add_step(
            0, 0, 0,
            std::vector<ArrayValues>{{{"p", Association::point, 1, "", ""}, random<float>(vertices)},
                                     {{"U", Association::point, 3, "", ""}, random<double>(3 * vertices)},
                                     {{"c", Association::cell, 3, "", ""}, random<float>(3 * cells)},
                                     {{"many", Association::cell, 5, "", ""}, random<double>(5 * cells)},
                                     {{"b", Association::boundary_face, 1, "", ""}, random<float>(boundary)}});
        writer.finish();
    }
    template <class T>
    std::vector<T> random(std::size_t count) {
        std::lognormal_distribution<double> distribution(0, 1);
        std::vector<T> values(count);
        for (T& value : values) value = static_cast<T>(distribution(generator_));
        values[3] = std::numeric_limits<T>::infinity();
        values[count / 2] = static_cast<T>(no_value);
        return values;
    }
    template <class F>
    static void for_scalars(const Dataset& dataset, F&& f) {
        for (const ArrayInfo& array : dataset.info().arrays)
            for (const std::string& name : scalar_names(array)) {
                const ScalarName scalar = parse_scalar(dataset, name);
                f(name, scalar, one_scalar(array, dataset.values(array.name, 0), scalar));
            }
    }

    test::Folder scratch;
    const std::filesystem::path directory = scratch / "a.ciel";

private:
    std::mt19937 generator_{5};
};

TEST_F(StoredHistogramTest, IsOfAllValues) {
    const auto dataset = Dataset::open(directory);
    std::size_t count = 0, invalid = 0;
    for_scalars(*dataset, [&](const std::string& name, const ScalarName& scalar, const Values& values) {
        EXPECT_EQ(dataset->histogram(scalar, 0), histogram_of(values, stored_bins)) << name;
        invalid += dataset->histogram(scalar, 0)->invalid;
        ++count;
    });
    EXPECT_EQ(count, 1U + 4U + 4U + 5U + 1U);
    EXPECT_GE(invalid, 2U * 5U) << "two numbers of each array";
}

TEST_F(StoredHistogramTest, IsAnsweredWithAnyNumberOfBins) {
    const auto without = scratch / "without.ciel";
    std::filesystem::copy(directory, without, std::filesystem::copy_options::recursive);
    for (const char* array : {"p", "U", "c", "many", "b"})
        ASSERT_TRUE(std::filesystem::remove(layout::value_ranges(layout::values(layout::mesh(without, 0), array), 0)));
    for (const auto& folder : {directory, without}) {
        LoadedDataset loaded(Dataset::open(folder), 1U << 24);
        for_scalars(*loaded.dataset(), [&](const std::string& name, const ScalarName&, const Values& values) {
            for (const std::size_t bins : {1U, 10U, 128U, 256U, 512U})
                EXPECT_EQ(loaded.histogram(name, 0, bins), histogram_of(values, bins)) << name << ' ' << bins;
            Histogram part({0.5, 1.25}, 128);
            part.add(values);
            EXPECT_EQ(loaded.histogram(name, 0, 128, part.range), part) << name;
        });
    }
}

TEST_F(StoredHistogramTest, TellsHowManyValuesAreReadAndEndsWhenItIsCancelled) {
    LoadedDataset loaded(Dataset::open(directory), 1U << 24);
    const std::size_t vertices = loaded.dataset()->info().meshes[0].vertices;
    std::vector<std::size_t> done;
    std::size_t all = 0;
    const ValuesRead note = [&](std::size_t read, std::size_t of) {
        done.push_back(read);
        all = of;
    };
    (void)loaded.histogram("p", 0, 3, std::nullopt, note);
    EXPECT_EQ(all, 2 * vertices) << "read once for the range, once for the counts";
    EXPECT_TRUE(std::ranges::is_sorted(done));
    EXPECT_EQ(done.back(), all);
    (void)loaded.histogram("p", 0, 3, std::array{0.0, 1.0}, note);
    EXPECT_EQ(all, vertices);
    EXPECT_EQ(done.back(), all);
    done.clear();
    (void)loaded.histogram("p", 0, 256, std::nullopt, note);
    EXPECT_TRUE(done.empty()) << "the stored histogram is read";
    const ValuesRead cancel = [](std::size_t, std::size_t) { throw ciel::Error("cancelled"); };
    EXPECT_THROW((void)loaded.histogram("p", 0, 3, std::nullopt, cancel), ciel::Error);
}

} // namespace
} // namespace server::store
