// The cache of loaded data, and the catalog of dataset names.
#include "support/store_box/box.hpp"

#include "ciel/cell_locator.hpp"
#include "ciel/extract.hpp"
#include "store/cache/cache.hpp"
#include "store/catalog.hpp"
#include "store/mesh_arrays.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <thread>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;

Cache::Made number(int value, std::size_t bytes) { return {std::make_shared<int>(value), bytes}; }

TEST(CacheTest, DropsTheLeastRecentlyUsedOverItsBudget) {
    Cache cache(100);
    int made = 0;
    const auto get = [&](const char* key) { return *cache.get<int>(key, [&] { return ++made, number(made, 40); }); };
    EXPECT_EQ(get("a"), 1);
    EXPECT_EQ(get("b"), 2);
    EXPECT_EQ(get("a"), 1);
    EXPECT_EQ(get("c"), 3); // evicts b
    EXPECT_EQ(cache.bytes(), 80U);
    EXPECT_EQ(get("a"), 1);
    EXPECT_EQ(get("b"), 4);
}

TEST(CacheTest, WhatIsInUseOutlivesTheCacheAndABigOneStands) {
    Cache cache(10);
    const auto big = cache.get<int>("big", [] { return number(7, 1000); });
    EXPECT_EQ(cache.bytes(), 1000U);
    (void)cache.get<int>("other", [] { return number(8, 1); });
    EXPECT_EQ(cache.bytes(), 1U);
    EXPECT_EQ(*big, 7);
}

TEST(CacheTest, KeepsNoMoreThanItsNumber) {
    Cache cache(1000, 2);
    for (const char* key : {"a", "b", "a", "c"}) (void)cache.get<int>(key, [] { return number(0, 1); });
    EXPECT_EQ(cache.bytes(), 2U);
    int made = 0;
    const auto again = [&](const char* key) { (void)cache.get<int>(key, [&] { return ++made, number(0, 1); }); };
    again("a");
    again("c");
    EXPECT_EQ(made, 0);
    again("b");
    EXPECT_EQ(made, 1);
}

TEST(CacheTest, DropsValuesWithoutAHolder) {
    Cache cache(1000);
    int made = 0;
    const auto get = [&](const char* key) { return cache.get<int>(key, [&] { return ++made, number(made, 40); }); };
    const auto held = get("held");
    (void)get("unused");
    (void)get("last");
    cache.drop_unused();
    EXPECT_EQ(cache.bytes(), 80U);
    EXPECT_EQ(*get("held"), 1);
    EXPECT_EQ(*get("last"), 3);
    EXPECT_EQ(*get("unused"), 4) << "was dropped";
}

TEST(CacheTest, AFailureIsNotKept) {
    Cache cache(10);
    EXPECT_THROW((void)cache.get<int>("a", []() -> Cache::Made { throw Error("no"); }), Error);
    EXPECT_EQ(*cache.get<int>("a", [] { return number(1, 1); }), 1);
}

TEST(CacheTest, ManyThreadsMakeOnce) {
    Cache cache(1000);
    std::atomic<int> made = 0;
    std::vector<std::future<void>> all;
    for (int t = 0; t < 8; ++t)
        all.push_back(std::async(std::launch::async, [&] {
            for (int i = 0; i < 50; ++i)
                EXPECT_EQ(*cache.get<int>(std::to_string(i), [&] { return ++made, number(i, 1); }), i);
        }));
    for (auto& each : all) each.get();
    EXPECT_EQ(made, 50);
}

class LoadedTest : public testing::Test {
protected:
    LoadedTest() { test::write_box(directory, test::box(2, 2, 2)); }

    test::Folder scratch;
    fs::path directory = scratch / "box.ciel";
};

std::vector<double> numbers(const ScalarField& scalar) {
    std::vector<double> all(scalar.topology->counts().vertices);
    for (Index v = 0; v < all.size(); ++v) all[v] = scalar.field->value(v);
    return all;
}

TEST_F(LoadedTest, ScalarsComponentsAndMagnitudes) {
    LoadedDataset loaded(Dataset::open(directory), 1 << 20);
    EXPECT_THAT(numbers(loaded.scalar("p", 0)), ElementsAreArray(test::values_of(27, 0)));
    const auto u = loaded.dataset()->values("U", 2);
    const auto y = loaded.scalar_values("U:y", 2), magnitude = loaded.scalar_values("U:magnitude", 2);
    ASSERT_EQ(y.size(), 27U);
    for (std::size_t i = 0; i < 27; ++i) {
        EXPECT_EQ(y[i], u[3 * i + 1]);
        EXPECT_FLOAT_EQ(magnitude[i], std::hypot(u[3 * i], u[3 * i + 1], u[3 * i + 2]));
    }
    EXPECT_THAT(numbers(loaded.scalar("U:magnitude", 2)), ElementsAreArray(magnitude));
    EXPECT_EQ(loaded.stored_scalar("cell:p", 0, Association::cell)->size(),
              loaded.dataset()->values("cell:p", 0).size());
    EXPECT_THROW((void)loaded.stored_scalar("p", 0, Association::cell), Error);
    EXPECT_THROW((void)loaded.scalar_values("cell:p", 0), Error);
    EXPECT_THAT(loaded.scalar("U:magnitude", 2).field->range(), ElementsAre(magnitude[0], magnitude[26]));
}

TEST_F(LoadedTest, OneTopologyAndOneFieldForAll) {
    LoadedDataset loaded(Dataset::open(directory), 1 << 20);
    const ScalarField a = loaded.scalar("p", 0), b = loaded.scalar("p", 0), c = loaded.scalar("p", 2);
    EXPECT_EQ(a.field, b.field);
    EXPECT_NE(a.field, c.field);
    EXPECT_EQ(a.topology, c.topology);
    EXPECT_EQ(a.topology->counts().cells, 8U);
    EXPECT_GE(loaded.memory_bytes(), a.topology->memory_bytes());
}

TEST_F(LoadedTest, AFieldOutlivesItsDataset) {
    ScalarField kept;
    {
        LoadedDataset loaded(Dataset::open(directory), 0);
        kept = loaded.scalar("U:x", 1);
    }
    fs::remove_all(directory);
    EXPECT_EQ(kept.field->value(1), 1003);
    EXPECT_EQ(kept.topology->counts().vertices, 27U);
}

TEST_F(LoadedTest, WhatIsMadeFromADatasetOutlivesIt) {
    std::optional<Query> query;
    std::optional<FaceMeshView> faces;
    std::shared_ptr<const CellLocator> locator;
    {
        const auto dataset = Dataset::open(directory);
        LoadedDataset loaded(dataset, 0);
        query = loaded.plane(1, {0, 0, 0.5}, {0, 0, 1}).query();
        locator = loaded.locator(1);
        faces = dataset->mesh_arrays().boundary(0, 0);
    }
    fs::remove_all(directory);
    Surface surface;
    query->extract(0, true, surface);
    EXPECT_EQ(surface.points.size(), 9U);
    EXPECT_NE(locator->cell_at({0.5, 0.5, 0.5}), none);
    EXPECT_EQ(faces->face_count(), 24U);
    EXPECT_EQ(faces->loop(0).size(), 4U);
}

TEST_F(LoadedTest, PlanesAreDistances) {
    LoadedDataset loaded(Dataset::open(directory), 1 << 20);
    const ScalarField plane = loaded.plane(0, {1, 0, 0}, {1, 0, 0});
    EXPECT_THAT(plane.field->range(), ElementsAre(-1, 1));
    EXPECT_EQ(plane.field, loaded.plane(1, {1, 0, 0}, {1, 0, 0}).field) << "the same mesh at another time";
    EXPECT_NE(plane.field, loaded.plane(0, {1, 0, 0}, {0, 1, 0}).field);
}

TEST_F(LoadedTest, ATurningSliceKeepsOnePlane) {
    LoadedDataset loaded(Dataset::open(directory), 1U << 30);
    const auto turned = [&](int degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return loaded.plane(0, {1, 1, 1}, {std::cos(angle), std::sin(angle), 0}).field;
    };
    std::vector<std::weak_ptr<const Field>> all;
    for (int degrees = 0; degrees < 90; ++degrees) all.push_back(turned(degrees));
    EXPECT_LE(std::ranges::count_if(all, [](const auto& each) { return !each.expired(); }), 1);
    EXPECT_EQ(turned(89), all[89].lock());
}

// Fields share the least squares of polyhedra, but only at the positions for which they were made.
TEST(LoadedFields, OfAMovingMeshHaveTheNormalsOfEachStep) {
    const test::Folder scratch;
    const Assembled assembled = assemble(test::view(test::voronoi(200, 3)));
    std::vector<float> moved = assembled.mesh.positions;
    for (std::size_t i = 0; i < moved.size(); i += 3) moved[i] *= 4;
    std::vector<float> p(moved.size() / 3);
    for (std::size_t v = 0; v < p.size(); ++v) p[v] = moved[3 * v] * moved[3 * v + 1] + moved[3 * v + 2];
    const auto count = static_cast<Index>(p.size());
    Writer writer(scratch / "m.ciel", {});
    writer.add_mesh(assembled.mesh, test::identity(count), test::identity(assembled.mesh.cell_types.size()), {});
    const ArrayInfo info{"p", Association::point, 1, "", ""};
    (void)writer.add_coordinates(0, moved);
    for (std::size_t step = 0; step < 4; ++step)
        writer.add_step(static_cast<double>(step), 0, step % 2, std::vector<ArrayValues>{{info, p}});
    writer.finish();

    LoadedDataset loaded(Dataset::open(scratch / "m.ciel"), std::size_t{1} << 30);
    for (std::size_t step = 0; step < 4; ++step) {
        const ScalarField scalar = loaded.scalar("p", step);
        const Values values = loaded.scalar_values("p", step);
        const Field fresh(*scalar.topology, values, values.keep_alive());
        Surface expected, found;
        for (const auto& [field, out] : {std::pair{&fresh, &expected}, std::pair{scalar.field.get(), &found}}) {
            Query query = scalar.query();
            query.set_field(*field);
            (void)query.extract(1, true, *out);
        }
        ASSERT_FALSE(expected.normals.empty());
        EXPECT_EQ(found.normals, expected.normals) << "step " << step;
    }
}

TEST_F(LoadedTest, WhatCannotBeContouredSaysWhy) {
    LoadedDataset loaded(Dataset::open(directory), 1 << 20);
    const auto error = [&](const char* name, std::size_t step) -> std::string {
        try {
            (void)loaded.scalar(name, step);
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_THAT(error("q", 0), HasSubstr("U:magnitude"));
    EXPECT_THAT(error("cell:p", 0), HasSubstr("on cells"));
    EXPECT_THAT(error("p", 1), HasSubstr("has no values at time 0.5; it has values at 0, 1"));
    EXPECT_THAT(error("p", 9), HasSubstr("no step 9"));
}

TEST_F(LoadedTest, RefreshKeepsWhatIsThere) {
    LoadedDataset loaded(Dataset::open(directory), 1 << 20);
    const auto before = loaded.scalar("p", 0);
    EXPECT_FALSE(loaded.refresh());
    const auto p = test::values_of(27, 5);
    Writer::append(directory).add_step(2, 0, 0, std::vector<ArrayValues>{{{"p", Association::point, 1, "Pa", ""}, p}});
    EXPECT_TRUE(loaded.refresh());
    EXPECT_EQ(loaded.scalar("p", 0).field, before.field);
    EXPECT_THAT(numbers(loaded.scalar("p", 3)), ElementsAreArray(p));
}

TEST_F(LoadedTest, AFileTruncatedUnderAReaderIsNamedAndTheProcessLives) {
    auto loaded = std::make_unique<LoadedDataset>(Dataset::open(directory), 1U << 20);
    const auto dataset = loaded->dataset();
    const auto before = dataset->values("p", 0);
    EXPECT_NO_THROW(dataset->check_intact());
    const fs::path chunk = directory / "meshes/0/arrays/p/0.0";
    ASSERT_TRUE(fs::exists(chunk));
    fs::resize_file(chunk, 0);
    EXPECT_EQ(std::accumulate(before.begin(), before.end(), 0.0F), 0.0F);
    try {
        dataset->check_intact();
        ADD_FAILURE() << "zeros taken for values";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr(chunk.string()), HasSubstr("shrunk")));
    }
    EXPECT_THROW((void)loaded->scalar("p", 0), Error);
    EXPECT_THROW((void)loaded->scalar_values("p", 0), Error);
}

class CatalogTest : public LoadedTest {
protected:
    static std::vector<std::string> names(const Catalog& catalog) {
        std::vector<std::string> result;
        for (const CatalogEntry& entry : catalog.list()) result.push_back(entry.name);
        return result;
    }
};

TEST_F(CatalogTest, NamesAreLookedUpAndNeverPaths) {
    Catalog catalog({directory});
    EXPECT_EQ(catalog.open("box")->dataset()->info().name, "box");
    EXPECT_EQ(catalog.open("box"), catalog.open("box"));
    for (const std::string& name :
         std::vector<std::string>{"box.ciel", "../box", directory.string(), "", ".", "./box", "box/"})
        EXPECT_THROW((void)catalog.open(name), Error) << name;
    try {
        (void)catalog.open("../../etc");
        FAIL() << "a path was taken for a name";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("there are: box"));
    }
}

TEST_F(CatalogTest, AFolderIsScannedAgainAndDuplicatesAreNumbered) {
    fs::create_directories(scratch / "folder");
    test::write_box(scratch / "folder/box.ciel", test::box(1, 1, 1));
    Catalog catalog({directory, scratch / "folder"});
    EXPECT_THAT(names(catalog), ElementsAre("box", "box-2"));
    EXPECT_EQ(catalog.open("box-2")->dataset()->info().meshes[0].cells, 1U);
    test::write_box(scratch / "folder/new.ciel", test::box(1, 1, 1));
    EXPECT_NO_THROW((void)catalog.open("new")) << "found without a list()";
    EXPECT_THAT(names(catalog), ElementsAre("box", "box-2", "new"));
    fs::remove_all(directory);
    EXPECT_THAT(names(catalog), ElementsAre("box-2", "new")) << "names stay with their directories";
}

TEST_F(LoadedTest, ValuesOfOneComponentAreThoseOfTheFile) {
    LoadedDataset loaded(Dataset::open(directory), 1 << 20);
    const std::size_t before = loaded.memory_bytes();
    EXPECT_EQ(loaded.scalar_values("p", 0).data(), loaded.dataset()->values("p", 0).data());
    EXPECT_EQ(loaded.memory_bytes(), before);
}

TEST_F(LoadedTest, UnusedFieldsAreDroppedAndUsedOnesStay) {
    LoadedDataset loaded(Dataset::open(directory), 1 << 20);
    const Values held = loaded.scalar_values("U:y", 0);
    (void)loaded.scalar_values("U:z", 0);
    const Values last = loaded.scalar_values("U:x", 0);
    const std::size_t before = loaded.memory_bytes();
    loaded.drop_unused_fields();
    EXPECT_EQ(loaded.memory_bytes(), before - held.size_bytes()) << "one array without a holder";
}

TEST_F(CatalogTest, ARemovedDatasetIsInMemoryWhileItIsHeld) {
    Catalog catalog({scratch.path()});
    auto held = catalog.open("box");
    fs::remove_all(directory);
    EXPECT_THAT(names(catalog), ElementsAre());
    EXPECT_THAT(catalog.loaded(), ElementsAre(held));
    held = nullptr;
    EXPECT_THAT(catalog.loaded(), ElementsAre());
}

TEST_F(CatalogTest, AHiddenFolderIsOneThatIsStillBeingWritten) {
    fs::create_directory(scratch / "folder");
    test::write_box(scratch / "folder/box.ciel", test::box(1, 1, 1));
    fs::rename(scratch / "folder/box.ciel", scratch / "folder/.half.ciel");
    const Catalog catalog({scratch / "folder"});
    EXPECT_THAT(names(catalog), ElementsAre());
}

TEST_F(CatalogTest, ADamagedOneIsListedWithItsProblem) {
    test::write_box(scratch / "bad.ciel", test::box(1, 1, 1));
    test::overwrite_file(scratch / "bad.ciel/steps.json", "{");
    Catalog catalog({scratch.path()});
    const auto entries = catalog.list();
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_THAT(entries[0].problem, HasSubstr("steps.json"));
    EXPECT_EQ(entries[1].problem, "");
    EXPECT_THROW((void)catalog.open("bad"), Error);
    fs::resize_file(directory / "meshes/0/faces/owner/0", 8); // list() does not read this file; open() does
    EXPECT_THROW((void)catalog.open("box"), Error);
    EXPECT_THAT(catalog.list()[1].problem, HasSubstr("owner"));
}

TEST_F(CatalogTest, OneThatCouldNotBeMadeIsListedUntilItIs) {
    Catalog catalog({directory});
    catalog.add_failed(scratch / "cache/late.ciel", "late.vtu: is empty");
    catalog.add_failed(directory, "box.vtu: is empty");
    auto entries = catalog.list();
    ASSERT_THAT(names(catalog), ElementsAre("box", "late"));
    EXPECT_EQ(entries[0].problem, "box.vtu: is empty") << "the older one that stands there is not served";
    EXPECT_EQ(entries[1].problem, "late.vtu: is empty");
    EXPECT_THROW((void)catalog.open("box"), Error);
    EXPECT_THROW((void)catalog.open("late"), Error);
    fs::create_directory(scratch / "cache");
    test::write_box(scratch / "cache/late.ciel", test::box(1, 1, 1));
    EXPECT_EQ(catalog.list()[1].problem, "");
    EXPECT_NO_THROW((void)catalog.open("late"));
}

TEST_F(CatalogTest, PathsThatAreNoDatasetsAreRefused) {
    EXPECT_THROW(Catalog({scratch / "nothing"}), Error);
    test::overwrite_file(scratch / "file.vtu", "<VTKFile>");
    EXPECT_THROW(Catalog({scratch / "file.vtu"}), Error);
}

TEST_F(CatalogTest, ManyOpenersShareOne) {
    Catalog catalog({directory});
    std::vector<std::future<std::shared_ptr<LoadedDataset>>> all;
    for (int t = 0; t < 8; ++t) all.push_back(std::async(std::launch::async, [&] { return catalog.open("box"); }));
    const auto one = catalog.open("box");
    for (auto& each : all) EXPECT_EQ(each.get(), one);
}

// The same dataset under the names "a", "b" and "c".
class GiveBackTest : public CatalogTest {
protected:
    GiveBackTest() {
        fs::create_directory(scratch / "all");
        for (const char* name : {"all/a.ciel", "all/b.ciel", "all/c.ciel"})
            fs::copy(directory, scratch / name, fs::copy_options::recursive);
    }
    static std::size_t use(Catalog& catalog, const std::string& name) {
        const auto loaded = catalog.open(name);
        (void)loaded->scalar("p", 0);
        return loaded->memory_bytes();
    }
    static constexpr std::size_t enough = 1 << 30;
};

TEST_F(GiveBackTest, WhatNobodyHasUsedSince) {
    Catalog catalog({scratch / "all"}, enough);
    use(catalog, "a");
    const auto held = catalog.open("b");
    EXPECT_EQ(catalog.give_back({}), 0U);
    const auto later = Catalog::Clock::now();
    use(catalog, "c");
    EXPECT_EQ(catalog.give_back(later), 1U);
    EXPECT_EQ(catalog.loaded().size(), 2U);
    EXPECT_EQ(catalog.open("b"), held);
    EXPECT_GT(use(catalog, "a"), 0U) << "it is opened anew";
    EXPECT_EQ(catalog.give_back(Catalog::Clock::now() + std::chrono::hours(1)), 2U);
    EXPECT_EQ(catalog.open("b"), held);
}

TEST_F(GiveBackTest, TheLongestUnusedWhenAllTogetherAreTooLarge) {
    const std::size_t of_one = [&] {
        Catalog catalog({scratch / "all"}, enough);
        return use(catalog, "a");
    }();
    Catalog catalog({scratch / "all"}, enough, 2 * of_one);
    for (const char* name : {"a", "b", "a", "c"}) use(catalog, name);
    EXPECT_EQ(catalog.give_back({}), 1U);
    const auto a = catalog.open("a");
    EXPECT_GT(a->memory_bytes(), 0U) << "b was longer unused";
    EXPECT_EQ(use(catalog, "b"), of_one);
    EXPECT_EQ(catalog.give_back({}), 1U);
    EXPECT_EQ(catalog.loaded().size(), 2U);
    EXPECT_EQ(catalog.open("a"), a);
}

TEST_F(GiveBackTest, NeverTheLastOneUsedForItsSizeAlone) {
    Catalog catalog({scratch / "all"}, enough, 1);
    use(catalog, "a");
    EXPECT_EQ(catalog.give_back({}), 0U);
    use(catalog, "b");
    EXPECT_EQ(catalog.give_back({}), 1U);
    EXPECT_EQ(catalog.loaded().size(), 1U);
}

} // namespace
} // namespace server::store
