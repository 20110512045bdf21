#include "support/store_box/format_1.hpp"

#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "support/store_box/box.hpp"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

namespace ciel::test {
using namespace server;
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

template <class T>
std::string bytes_of(const std::vector<T>& numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

template <class T>
std::vector<T> numbers_in(const fs::path& file) {
    const std::string bytes = read_file(file);
    std::vector<T> numbers(bytes.size() / sizeof(T));
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

// Replaces an array of one chunk, and its checksum.
template <class T>
void write_array(const fs::path& mesh, const std::string& name, const std::vector<T>& numbers, json& checksums) {
    fs::create_directory(mesh / name);
    const json document{{"zarr_format", 2},
                        {"shape", {numbers.size()}},
                        {"chunks", {numbers.size()}},
                        {"dtype", sizeof(T) == 8 ? "<u8" : "<u4"},
                        {"compressor", nullptr},
                        {"filters", nullptr},
                        {"order", "C"},
                        {"fill_value", 0}};
    overwrite_file(mesh / name / ".zarray", document.dump());
    overwrite_file(mesh / name / "0", bytes_of(numbers));
    checksums[name] = store::checksum(store::bytes_of(bytes_of(numbers)));
}

// Returns the id of each numbered face in the mesh.
std::vector<Index> ids_of_numbers(const fs::path& stored, const FaceMesh& mesh) {
    const auto owner = numbers_in<Index>(stored / "faces/owner/0");
    const auto neighbour = numbers_in<Index>(stored / "faces/neighbour/0");
    std::vector<Index> ids;
    for (Index face = 0; face < mesh.owner.size(); ++face)
        if (mesh.neighbour[face] == none) ids.push_back(face);
    for (std::size_t number = ids.size(); number < owner.size(); ++number)
        for (Index face = 0; face < mesh.owner.size(); ++face) // two cells of a test mesh share one face at most
            if (mesh.owner[face] == owner[number] && mesh.neighbour[face] == neighbour[number]) ids.push_back(face);
    return ids;
}

} // namespace

void make_format_1(const fs::path& dataset, const FaceMesh& mesh) {
    const fs::path stored = dataset / "meshes/0";
    json attributes = json::parse(read_file(stored / ".zattrs")), root = json::parse(read_file(dataset / ".zattrs"));
    json& checksums = attributes["ciel"]["checksums"];
    const std::vector<Index> ids = ids_of_numbers(stored, mesh);
    const json& groups = attributes["ciel"]["groups"];
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i]["of"] != "faces") continue;
        const std::string name = "groups/" + std::to_string(i);
        auto of_group = numbers_in<Index>(stored / name / "0");
        for (Index& number : of_group) number = ids.at(number);
        std::ranges::sort(of_group);
        write_array(stored, name, of_group, checksums);
    }
    for (const char* name : {"face_offset", "face_vertex", "owner", "neighbour"})
        checksums.erase(std::string("faces/") + name);
    fs::remove_all(stored / "faces");
    write_array(stored, "face_offset", mesh.face_offset, checksums);
    write_array(stored, "face_vertex", mesh.face_vertex, checksums);
    write_array(stored, "owner", mesh.owner, checksums);
    write_array(stored, "neighbour", mesh.neighbour, checksums);
    root["ciel"]["format_version"] = 1;
    overwrite_file(stored / ".zattrs", attributes.dump());
    overwrite_file(dataset / ".zattrs", root.dump());
}

void remove_blocks(const fs::path& dataset) {
    std::vector<fs::path> removed;
    for (const auto& entry : fs::recursive_directory_iterator(dataset))
        if (entry.path().filename() == "blocks" || entry.path().filename() == "ranges") removed.push_back(entry.path());
    for (const fs::path& path : removed) fs::remove_all(path);
}

} // namespace ciel::test
