// A surface with values on its way into a file, whatever the format.
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
    Vec3d origin{}; // added in double, so files far from the origin keep their digits where the format can
    std::vector<NamedValues> values;
    bool triangles = false; // else polygons as they are (STL always has triangles)
    Vec3d file_origin{};    // coordinates in the file are relative to it, which the file says where it is not zero
};

// What surfaces of a mesh are moved to in a format of floats, and in others on request: the same for all of them, so
// that files fit together. Zero where floats are fine enough for the mesh's box (as Dataset has it); else the box's
// centre in whole numbers.
[[nodiscard]] Vec3d file_origin(const std::array<double, 6>& bounds);

struct ExportedCounts {
    std::size_t polygons = 0, vertices = 0;
};

// "X Y Z", with all digits.
[[nodiscard]] std::string origin_text(Vec3d origin);

// Without polygons that have no area (a value that hits vertices exactly makes them) and vertices that no polygon uses.
struct ExportedPolygons {
    std::vector<Index> vertices;  // of the surface
    std::vector<Index> offset{0}; // polygons + 1
    std::vector<Index> corner;    // into `vertices`

    [[nodiscard]] ExportedCounts counts() const { return {offset.size() - 1, vertices.size()}; }
};
[[nodiscard]] ExportedPolygons exported_polygons(const Surface& surface, bool triangles);

} // namespace ciel::wire
