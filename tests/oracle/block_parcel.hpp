// What a process needs to cut one block of a mesh, and the surface that it returns, as files.
#pragma once

#include "ciel/extract.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <istream>
#include <ostream>
#include <string>
#include <vector>

namespace ciel::test {

struct BlockParcel {
    std::array<Index, 1> block{};
    std::array<double, 1> nu{};
    Vec3d origin{};
    std::vector<std::uint64_t>
        tables; // result of Topology::tables with the entries of the block and its neighbors only
    std::vector<std::uint64_t> record; // the block's record of the kind `cells`
    std::vector<Index> vertices;       // mesh-wide ids of the block's vertices
    std::vector<float> values;         // of `vertices`
    std::vector<float> positions;      // of `vertices`: x, y, z
};

// Calls f for each array of a parcel or a surface, in the order of the file.
template <class F>
void for_arrays(BlockParcel& parcel, F&& f) {
    f(parcel.block), f(parcel.nu), f(parcel.origin), f(parcel.tables), f(parcel.record), f(parcel.vertices),
        f(parcel.values), f(parcel.positions);
}
template <class F>
void for_arrays(Surface& surface, F&& f) {
    f(surface.positions), f(surface.points), f(surface.polygon_offset), f(surface.polygon_vertex),
        f(surface.polygon_cell), f(surface.chunks);
}

template <class Whole>
void write(const std::string& file, Whole whole) {
    std::ofstream out(file, std::ios::binary);
    for_arrays(whole, [&out](const auto& array) {
        const std::uint64_t size = array.size();
        out.write(reinterpret_cast<const char*>(&size), sizeof size);
        out.write(reinterpret_cast<const char*>(array.data()), static_cast<std::streamsize>(size * sizeof(array[0])));
    });
}

template <class Whole>
[[nodiscard]] Whole read(const std::string& file) {
    Whole whole;
    std::ifstream in(file, std::ios::binary);
    in.exceptions(std::ios::failbit | std::ios::badbit);
    for_arrays(whole, [&in](auto& array) {
        std::uint64_t size = 0;
        in.read(reinterpret_cast<char*>(&size), sizeof size);
        if constexpr (requires { array.resize(size); }) array.resize(size);
        in.read(reinterpret_cast<char*>(array.data()), static_cast<std::streamsize>(size * sizeof(array[0])));
    });
    return whole;
}

} // namespace ciel::test
