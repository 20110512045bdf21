// A surface with values to be written to a file of any format.
#pragma once

#include "ciel/extract.hpp"

#include <array>
#include <string>
#include <vector>

namespace ciel::wire {

struct NamedValues {
    std::string name;
    std::vector<float> values; // one per surface vertex
};

struct ExportSurface {
    const Surface& surface;
    Vec3d origin{}; // added in double; formats with doubles keep all digits
    std::vector<NamedValues> values;
    bool triangles = false; // else polygons (STL always has triangles)
    Vec3d file_origin{};    // subtracted from the coordinates; stated in the file unless zero
};

// Returns the file origin for surfaces of a mesh: formats with floats need it, others use it on request. It depends
// only on the mesh's bounds (min and max per axis), so files of one mesh fit together. Zero where floats are fine
// enough for the bounds, else their centre rounded to whole numbers.
[[nodiscard]] Vec3d file_origin(const std::array<double, 6>& bounds);

struct ExportedCounts {
    std::size_t polygons = 0, vertices = 0;
};

// "X Y Z", with 17 significant digits.
[[nodiscard]] std::string origin_text(Vec3d origin);

// Polygons with an area, and the vertices that they use. An iso-value equal to a vertex value makes polygons without
// area.
struct ExportedPolygons {
    std::vector<Index> vertices;  // of the surface
    std::vector<Index> offset{0}; // polygons + 1
    std::vector<Index> corner;    // into `vertices`

    [[nodiscard]] ExportedCounts counts() const { return {offset.size() - 1, vertices.size()}; }
};
[[nodiscard]] ExportedPolygons exported_polygons(const Surface& surface, bool triangles);

} // namespace ciel::wire
