// Damaged, truncated, foreign and hostile directories are refused with a message that names the file.
#include "ciel/types.hpp"
#include "support/store_box/box.hpp"

#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/mesh_arrays.hpp"

#include <cstring>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

using Damage = std::function<void(const fs::path&)>;

struct Malformed {
    const char* name;
    Damage damage;
    const char* file;  // file name that the message contains
    const char* error; // text that the message contains
};

Damage remove(const char* file) {
    return [=](const fs::path& d) { fs::remove_all(d / file); };
}
Damage write(const char* file, const std::string& content) {
    return [=](const fs::path& d) { test::overwrite_file(d / file, content); };
}
Damage resize(const char* file, int by) {
    return [=](const fs::path& d) {
        fs::resize_file(d / file, fs::file_size(d / file) + static_cast<std::uintmax_t>(by));
    };
}
Damage edit(const char* file, const std::function<void(json&)>& change) {
    return [=](const fs::path& d) {
        json document = json::parse(test::read_file(d / file));
        change(document);
        test::overwrite_file(d / file, document.dump());
    };
}
// Adds a table of steps to the marker, with some entries changed.
auto as_table(const json& changes) {
    return [=](json& j) {
        j["ciel_steps"] = 2;
        j["table"] = {{"steps", 2}, {"checksum", "xxh3:0123456789abcdef"}, {"arrays", json::array()}, {"chunks", {1}}};
        j["table"].update(changes);
    };
}
Damage flip(const char* file, std::size_t byte) {
    return [=](const fs::path& d) {
        std::string content = test::read_file(d / file);
        content.at(byte) = static_cast<char>(content[byte] ^ 1);
        test::overwrite_file(d / file, content);
    };
}

// Sets one entry of a topology array of mesh 0 and corrects the checksum. Only a check of the values finds this damage.
template <typename T>
Damage poke(const char* name, std::size_t index, T value) {
    return [=](const fs::path& d) {
        const fs::path mesh = d / "meshes/0", chunk = mesh / name / "0";
        std::string content = test::read_file(chunk);
        std::memcpy(content.data() + index * sizeof value, &value, sizeof value);
        test::overwrite_file(chunk, content);
        json attributes = json::parse(test::read_file(mesh / ".zattrs"));
        attributes["ciel"]["checksums"][name] = checksum(bytes_of(content));
        test::overwrite_file(mesh / ".zattrs", attributes.dump());
    };
}

// Gives a topology array of 32-bit ids another length and corrects the checksum.
Damage resize_array(const char* name, std::size_t entries) {
    return [=](const fs::path& d) {
        const fs::path mesh = d / "meshes/0";
        edit((std::string("meshes/0/") + name + "/.zarray").c_str(),
             [&](json& j) { j["shape"] = j["chunks"] = {entries}; })(d);
        std::string content = test::read_file(mesh / name / "0");
        content.resize(entries * sizeof(std::uint32_t));
        test::overwrite_file(mesh / name / "0", content);
        edit("meshes/0/.zattrs", [&](json& j) { j["ciel"]["checksums"][name] = checksum(bytes_of(content)); })(d);
    };
}

Damage poke_position(float value) {
    return [=](const fs::path& d) {
        const fs::path chunk = d / "meshes/0/positions/0.0.0";
        std::string content = test::read_file(chunk);
        std::memcpy(content.data() + 8, &value, sizeof value);
        test::overwrite_file(chunk, content);
        json attributes = json::parse(test::read_file(d / "meshes/0/.zattrs"));
        attributes["ciel"]["coordinate_checksums"][0] = checksum(bytes_of(content));
        test::overwrite_file(d / "meshes/0/.zattrs", attributes.dump());
    };
}

const std::vector<Malformed> table{
    {"missing", [](const fs::path& d) { fs::remove_all(d); }, "box.ciel", "does not exist"},
    {"a zip", [](const fs::path& d) { fs::remove_all(d), test::overwrite_file(d, "PK\3\4..."); }, "box.ciel",
     "is a file"},
    {"empty directory", [](const fs::path& d) { fs::remove_all(d), fs::create_directory(d); }, "box.ciel",
     "is not a CIEL dataset"},
    {"no .zgroup", remove(".zgroup"), "box.ciel", "is not a CIEL dataset"},
    {"zarr 3", write(".zgroup", R"({"zarr_format": 3})"), ".zgroup", "must be 2"},
    {"foreign zarr group", write(".zattrs", R"({"creator": "xarray"})"), ".zattrs", "not a CIEL dataset"},
    {"zarr group without attributes", remove(".zattrs"), "box.ciel", "not a CIEL dataset"},
    {"newer version", edit(".zattrs", [](json& j) { j["ciel"]["format_version"] = 3; }), ".zattrs", "newer CIEL"},
    {"version 0", edit(".zattrs", [](json& j) { j["ciel"]["format_version"] = 0; }), ".zattrs", "must not be 0"},
    {"attributes cut off", resize(".zattrs", -10), ".zattrs", "not valid JSON"},
    {"attributes a list", write(".zattrs", "[1, 2]"), ".zattrs", "not a CIEL dataset"},
    {"no input counts", edit(".zattrs", [](json& j) { j["ciel"].erase("input"); }), ".zattrs", "lacks 'input'"},
    {"no commit marker", remove("steps.json"), "steps.json", "is missing"},
    {"marker empty", write("steps.json", ""), "steps.json", "not valid JSON"},
    {"marker of a newer version", edit("steps.json", [](json& j) { j["ciel_steps"] = 3; }), "steps.json",
     "update CIEL"},
    {"table in a marker of version 1",
     edit("steps.json",
          [](json& j) {
              j["table"] = {{"steps", 1}};
          }),
     "steps.json", "must be 2"},
    {"table without rows", edit("steps.json", as_table(json::object())), "steps/rows", "is missing"},
    {"table of too many steps", edit("steps.json", as_table({{"steps", 100'000'000}})), "steps/rows", "is missing"},
    {"table of no step", edit("steps.json", as_table({{"steps", 0}})), "steps.json", "must be 1 to 100000000"},
    {"table without a checksum", edit("steps.json", as_table({{"checksum", "md5"}})), "steps.json", "xxh3"},
    {"table on more meshes", edit("steps.json", as_table({{"chunks", {1, 1}}})), "steps.json", "more entries than"},
    {"table of an array on no mesh",
     edit("steps.json", as_table({{"arrays", json::array({json{{"name", "p"}, {"meshes", {1}}}})}})), "steps.json",
     "number of a mesh"},
    {"marker without steps", edit("steps.json", [](json& j) { j.erase("steps"); }), "steps.json", "lacks 'steps'"},
    {"no meshes", edit("steps.json", [](json& j) { j["meshes"] = 0; }), "steps.json", "'meshes' must be 1"},
    {"meshes beyond all", edit("steps.json", [](json& j) { j["meshes"] = 18446744073709551615U; }), "steps.json",
     "'meshes'"},
    {"a mesh that is not there", edit("steps.json", [](json& j) { j["meshes"] = 2; }), "meshes/1", "is missing"},
    {"step on no mesh", edit("steps.json", [](json& j) { j["steps"][1]["mesh"] = 7; }), "steps.json", "is on mesh 7"},
    {"negative mesh", edit("steps.json", [](json& j) { j["steps"][1]["mesh"] = -1; }), "steps.json", "'steps[1].mesh'"},
    {"time a string", edit("steps.json", [](json& j) { j["steps"][1]["time"] = "1"; }), "steps.json",
     "'steps[1].time'"},
    {"time overflows", write("steps.json", R"({"ciel_steps": 1, "meshes": 1, "steps": [{"time": 1e999}]})"),
     "steps.json", "JSON"},
    {"times not in order", edit("steps.json", [](json& j) { j["steps"][2]["time"] = 0.1; }), "steps.json", "not later"},
    {"no such coordinates", edit("steps.json", [](json& j) { j["steps"][0]["coordinates"] = 1; }), "steps.json",
     "coordinate set"},
    {"chunk beyond the array", edit("steps.json", [](json& j) { j["steps"][0]["arrays"]["p"]["chunk"] = 3; }),
     "arrays/p", "lists step 3"},
    {"array that is not there", edit("steps.json", [](json& j) { j["steps"][0]["arrays"]["q"] = json::object(); }),
     "arrays/q", "is missing"},
    {"array named like a path",
     edit("steps.json", [](json& j) { j["steps"][0]["arrays"]["../../x"] = json::object(); }),
     "arrays/%2E%2E%2F%2E%2E%2Fx", "is missing"},
    {"checksum of another kind", edit("steps.json", [](json& j) { j["steps"][0]["arrays"]["p"]["checksum"] = "md5"; }),
     "steps.json", "xxh3"},
    {"too few component ranges",
     edit("steps.json",
          [](json& j) {
              j["steps"][0]["arrays"]["U"]["component_ranges"] = {{0, 1}};
          }),
     "steps.json", "one entry per component"},
    {"extremes of one component",
     edit("steps.json",
          [](json& j) {
              j["steps"][0]["arrays"]["cell:p"]["extremes"].push_back(j["steps"][0]["arrays"]["cell:p"]["extremes"][0]);
          }),
     "steps.json", "'extremes' of 'cell:p'"},
    {"extreme in a cell that is not there",
     edit("steps.json", [](json& j) { j["steps"][0]["arrays"]["cell:p"]["extremes"][0]["lowest"]["cell"] = 4000; }),
     "steps.json", "must be cells of the mesh"},
    {"extreme in no cell",
     edit("steps.json",
          [](json& j) { j["steps"][0]["arrays"]["cell:p"]["extremes"][0]["lowest"]["cell"] = 4294967295U; }),
     "steps.json", "larger than any cell's id"},
    {"extreme without a place",
     edit("steps.json",
          [](json& j) {
              j["steps"][0]["arrays"]["cell:p"]["extremes"][0]["highest"]["place"] = {1, 2};
          }),
     "steps.json", "must be [x, y, z]"},
    {"origin of another kind", edit("meshes/0/arrays/p/.zattrs", [](json& j) { j["ciel"]["origin"] = "guessed"; }),
     "arrays/p/.zattrs", "\"interpolated\""},
    {"too few names of components",
     edit("meshes/0/arrays/U/.zattrs", [](json& j) { j["ciel"]["component_names"] = {"xx"}; }), "arrays/U/.zattrs",
     "must have one name per component"},
    {"no index of blocks", remove("meshes/0/blocks/index"), "blocks/index", "is missing"},
    {"index of blocks cut off", resize("meshes/0/blocks/index", -8), "blocks/index", "does not match its checksum"},
    {"index of blocks empty", write("meshes/0/blocks/index", ""), "blocks/index", "is too short"},
    {"index of blocks damaged", flip("meshes/0/blocks/index", 200), "blocks/index", "does not match its checksum"},
    {"index of blocks that is something else", flip("meshes/0/blocks/index", 1), "blocks/index",
     "does not begin with the bytes"},
    {"index of blocks of a newer version", flip("meshes/0/blocks/index", 13), "blocks/index", "newer CIEL"},
    {"index of blocks of another dataset", flip("meshes/0/blocks/index", 16), "blocks/index", "another dataset"},
    {"no records", remove("meshes/0/blocks/mates/0"), "blocks/mates/0", "is missing"},
    {"records cut off", resize("meshes/0/blocks/cells/0", -8), "blocks/cells/0", "bytes, but"},
    {"records of another dataset", flip("meshes/0/blocks/around/0", 16), "blocks/around/0", "another dataset"},
    {"records of another kind",
     [](const fs::path& d) {
         const fs::path blocks = d / "meshes/0/blocks";
         std::string records = test::read_file(blocks / "cells/0");
         records.replace(8, 4, "mate");
         test::overwrite_file(blocks / "cells/0", records);
     },
     "blocks/cells/0", "does not begin with the bytes"},
    {"a record damaged", flip("meshes/0/blocks/cells/0", 100), "blocks/cells/0", "checksum of block 0"},
    {"ranges damaged", flip("meshes/0/arrays/p/ranges/0", 150), "arrays/p/ranges/0", "does not match its checksum"},
    {"ranges cut off", resize("meshes/0/arrays/U/ranges/1", -8), "arrays/U/ranges/1", "does not match its checksum"},
    {"ranges of another dataset", flip("meshes/0/arrays/p/ranges/2", 20), "arrays/p/ranges/2", "another dataset"},
    {"ranges of another array",
     [](const fs::path& d) {
         fs::copy_file(d / "meshes/0/arrays/U/ranges/0", d / "meshes/0/arrays/p/ranges/0",
                       fs::copy_options::overwrite_existing);
     },
     "arrays/p/ranges/0", "belongs to another array"},
    {"a limit that is no number",
     [](const fs::path& d) {
         std::string ranges = test::read_file(d / "meshes/0/arrays/p/ranges/0");
         constexpr std::size_t lower_limits = 136;
         ranges.replace(lower_limits, 4, "\xff\xff\xff\x7f");
         const std::uint64_t sum = checksum_number(bytes_of(ranges).first(ranges.size() - sizeof sum));
         std::memcpy(ranges.data() + ranges.size() - sizeof sum, &sum, sizeof sum);
         test::overwrite_file(d / "meshes/0/arrays/p/ranges/0", ranges);
     },
     "arrays/p/ranges/0", "has a minimum or maximum that is NaN"},
    {"boxes damaged", flip("meshes/0/positions/ranges/0", 140), "positions/ranges/0", "does not match its checksum"},
    {"another number of boundary faces",
     edit("meshes/0/.zattrs",
          [](json& j) {
              auto& count = j["ciel"]["counts"]["boundary_faces"];
              count = count.get<int>() + 1;
          }),
     "meshes/0/.zattrs", "boundary faces, but there are"},
    {"chunk truncated", resize("meshes/0/arrays/p/0.0", -4), "arrays/p/0.0", "bytes, but"},
    {"chunk missing", remove("meshes/0/arrays/U/1.0.0"), "arrays/U/1.0.0", "is missing"},
    {"array compressed",
     edit("meshes/0/arrays/p/.zarray",
          [](json& j) {
              j["compressor"] = {{"id", "zlib"}};
          }),
     "arrays/p/.zarray", "compressor"},
    {"array in Fortran order", edit("meshes/0/arrays/p/.zarray", [](json& j) { j["order"] = "F"; }), "arrays/p/.zarray",
     "order"},
    {"array big endian", edit("meshes/0/arrays/p/.zarray", [](json& j) { j["dtype"] = ">f4"; }), "arrays/p/.zarray",
     ">f4"},
    {"array of another size",
     edit("meshes/0/arrays/p/.zarray",
          [](json& j) {
              j["shape"] = {3, 26};
          }),
     "arrays/p/.zarray", "27 x 1"},
    {"array of no dimension", edit("meshes/0/arrays/p/.zarray", [](json& j) { j["shape"] = json::array(); }),
     "arrays/p/.zarray", "one to three"},
    {"chunks of nothing",
     edit("meshes/0/arrays/p/.zarray",
          [](json& j) {
              j["chunks"] = {0, 27};
          }),
     "arrays/p/.zarray", "zero"},
    {"array renamed", edit("meshes/0/arrays/p/.zattrs", [](json& j) { j["ciel"]["name"] = "q"; }), "arrays/p/.zattrs",
     "named 'q'"},
    {"components beyond all", edit("meshes/0/arrays/U/.zattrs", [](json& j) { j["ciel"]["components"] = 4000000000U; }),
     "arrays/U/.zattrs", "1 to 64"},
    {"topology array missing", remove("meshes/0/faces/owner"), "meshes/0/faces/owner", "is missing"},
    {"topology truncated", resize("meshes/0/faces/face_vertex/0", -4), "face_vertex/0", "bytes, but"},
    {"topology too long", resize("meshes/0/faces/owner/0", 4), "owner/0", "bytes, but"},
    {"size beyond memory",
     edit("meshes/0/faces/owner/.zarray", [](json& j) { j["shape"] = j["chunks"] = {9223372036854775807U}; }),
     "owner/.zarray", "more than 2^63 bytes"},
    {"one bit of topology", flip("meshes/0/faces/face_vertex/0", 5), "face_vertex/0", "checksum"},
    {"one bit of a coordinate", flip("meshes/0/positions/0.0.0", 6), "positions/0.0.0", "checksum"},
    {"one bit of a group", flip("meshes/0/groups/0/0", 0), "groups/0/0", "checksum"},
    {"checksum not given", edit("meshes/0/.zattrs", [](json& j) { j["ciel"]["checksums"].erase("faces/neighbour"); }),
     "meshes/0/.zattrs", "faces/neighbour"},
    {"no blocks", remove("meshes/0/blocks"), "meshes/0/blocks", "is missing"},
    {"vertex out of range", poke<std::uint32_t>("faces/face_vertex", 3, 27), "face_vertex/0", "holds index 27"},
    {"owner out of range", poke<std::uint32_t>("faces/owner", 23, 8), "owner/0", "holds index 8"},
    {"owners not sorted", poke<std::uint32_t>("faces/owner", 0, 7), "owner/0", "not sorted"},
    {"neighbour out of range", poke<std::uint32_t>("faces/neighbour", 24, 8), "neighbour/0", "does not exist"},
    {"neighbour of itself", poke<std::uint32_t>("faces/neighbour", 24, 0), "neighbour/0", "does not exist"},
    {"neighbour on the boundary", poke<std::uint32_t>("faces/neighbour", 23, 7), "neighbour/0", "does not exist"},
    {"one more on the boundary", poke<std::uint32_t>("faces/neighbour", 24, none), ".zattrs", "there are 25"},
    {"boundary in the wrong place",
     [](const fs::path& d) {
         poke<std::uint32_t>("faces/neighbour", 0, 1)(d);
         poke<std::uint32_t>("faces/neighbour", 24, none)(d);
     },
     "neighbour/0", "among the boundary faces"},
    {"faces of other sizes", resize_array("faces/neighbour", 24), "neighbour/0", "24 entries, but must have 25"},
    {"offsets not from zero", poke<std::uint64_t>("faces/face_offset", 0, 4), "face_offset/0", "must begin with 0"},
    {"offsets backwards", poke<std::uint64_t>("faces/face_offset", 2, 1000000), "face_offset/0", "three corners"},
    {"face of two corners", poke<std::uint64_t>("faces/face_offset", 1, 2), "face_offset/0", "three corners"},
    {"unknown cell type", poke<std::uint8_t>("cell_types", 2, 11), "cell_types/0", "cell type"},
    {"group out of range", poke<std::uint32_t>("groups/1", 0, 8), "groups/1/0", "holds index 8"},
    {"coordinate not finite", poke_position(std::numeric_limits<float>::infinity()), "positions/0.0.0", "not finite"},
    {"counts that lie", edit("meshes/0/.zattrs", [](json& j) { j["ciel"]["counts"]["cells"] = 9; }), "meshes/0/.zattrs",
     "declares other numbers of"},
    {"a directory in place of a chunk",
     [](const fs::path& d) { fs::remove(d / "meshes/0/faces/owner/0"), fs::create_directory(d / "meshes/0/faces/owner/0"); },
     "owner/0", "not a regular file"},
};

class MalformedTest : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedTest, IsRefusedByNameOfFile) {
    static const test::Folder pattern;
    if (!fs::exists(pattern / "box.ciel")) test::write_box(pattern / "box.ciel", test::box(2, 2, 2));
    const test::Folder scratch;
    const fs::path directory = scratch / "box.ciel";
    fs::copy(pattern / "box.ciel", directory, fs::copy_options::recursive);
    GetParam().damage(directory);
    try {
        Dataset::open(directory)->verify();
        FAIL() << "passed";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().file));
        EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().error));
    }
}

INSTANTIATE_TEST_SUITE_P(Table, MalformedTest, testing::ValuesIn(table), [](const auto& row) {
    std::string name = row.param.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

TEST(Damaged, AChunkIsVerifiedAtFirstTouch) {
    const test::Folder scratch;
    test::write_box(scratch / "box.ciel", test::box(2, 2, 2));
    flip("meshes/0/arrays/p/2.0", 9)(scratch / "box.ciel");
    const auto dataset = Dataset::open(scratch / "box.ciel");
    EXPECT_NO_THROW((void)dataset->values("p", 0));
    EXPECT_THROW((void)dataset->values("p", 2), Error);
    EXPECT_THROW((void)dataset->values("p", 2), Error) << "and stays refused";
}

// Returns the message with which the records of the box's only block are refused after `damage`; empty if they are not.
std::string refused_block(const Damage& damage) {
    const test::Folder scratch;
    test::write_box(scratch / "box.ciel", test::box(2, 2, 2));
    damage(scratch / "box.ciel");
    const Topology topology = Dataset::open(scratch / "box.ciel")->topology(0);
    try {
        (void)topology.half_edges(0);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Damaged, ABlockIsVerifiedAtFirstTouch) {
    EXPECT_EQ(refused_block([](const fs::path&) {}), "");
    EXPECT_EQ(refused_block(flip("meshes/0/blocks/mates/0", 100)), "") << "half_edges does without the mates";
    EXPECT_THAT(refused_block(flip("meshes/0/blocks/cells/0", 100)), testing::HasSubstr("checksum of block 0"));
}

// The file of records shrinks while the dataset is open. If it had shrunk before, opening would fail.
TEST(Damaged, RecordsThatShrinkWhileTheyAreOpenAreRefused) {
    const test::Folder scratch;
    test::write_box(scratch / "box.ciel", test::box(2, 2, 2));
    const Topology topology = Dataset::open(scratch / "box.ciel")->topology(0);
    resize("meshes/0/blocks/cells/0", -64)(scratch / "box.ciel");
    EXPECT_THROW((void)topology.half_edges(0), Error);
}

TEST(Damaged, ATopologyReadsItsDatasetAfterItWasReplaced) {
    const test::Folder scratch;
    test::write_box(scratch / "box.ciel", test::box(2, 2, 2));
    const Topology topology = Dataset::open(scratch / "box.ciel")->topology(0);
    fs::remove_all(scratch / "box.ciel");
    test::write_box(scratch / "box.ciel", test::box(3, 3, 3));
    EXPECT_EQ(topology.half_edges(0).size(), 24U);
}

TEST(Damaged, AFileThatShrankIsRefusedByRefresh) {
    const test::Folder scratch;
    test::write_box(scratch / "box.ciel", test::box(2, 2, 2));
    const auto dataset = Dataset::open(scratch / "box.ciel");
    (void)dataset->values("p", 0);
    EXPECT_EQ(dataset->refreshed(), nullptr);
    resize("meshes/0/arrays/p/0.0", -4)(scratch / "box.ciel");
    EXPECT_THROW((void)dataset->refreshed(), Error);
}

TEST(Damaged, AReplacedDatasetIsNotMistakenForAGrownOne) {
    const test::Folder scratch;
    test::write_box(scratch / "box.ciel", test::box(2, 2, 2));
    const auto dataset = Dataset::open(scratch / "box.ciel");
    const auto owner = dataset->mesh_arrays().numbered_faces(0, 0).owner;
    const std::vector<Index> before(owner.begin(), owner.end());
    fs::remove_all(scratch / "box.ciel");
    test::write_box(scratch / "box.ciel", test::box(3, 3, 3));
    EXPECT_THROW((void)dataset->refreshed(), Error);
    EXPECT_THAT(owner, testing::ElementsAreArray(before)) << "a mapping outlives its file";
}

TEST(SentenceForClients, HasNoPathOfAFileSystemError) {
    const fs::filesystem_error error("status", "/srv/data/box.ciel",
                                     std::make_error_code(std::errc::permission_denied));
    EXPECT_THAT(sentence_for_clients(error),
                testing::AllOf(testing::HasSubstr("Permission denied"), testing::Not(testing::HasSubstr("/srv"))));
}

TEST(Damaged, ALateArrayIsAnErrorUntilItsChunkIsThere) {
    const test::Folder scratch;
    const fs::path directory = scratch / "box.ciel";
    test::write_box(directory, test::box(2, 2, 2));
    const std::string chunk = test::read_file(directory / "meshes/0/arrays/p/0.0");
    fs::remove(directory / "meshes/0/arrays/p/0.0");
    edit("steps.json", [](json& j) { j["steps"][0]["arrays"]["p"] = {{"chunk", 0}, {"lazy", true}}; })(directory);
    const auto dataset = Dataset::open(directory);
    EXPECT_TRUE(dataset->steps()[0].arrays.at("p").late);
    EXPECT_THROW((void)dataset->values("p", 0), Error);
    test::overwrite_file(directory / "meshes/0/arrays/p/0.0", chunk);
    EXPECT_THAT(dataset->values("p", 0), testing::ElementsAreArray(test::values_of(27, 0)));
}

} // namespace
} // namespace server::store
