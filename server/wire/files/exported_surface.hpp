// A surface with values to be written to a file of any format.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/values_view.hpp"
#include "ciel/vector_operators.hpp"

#include <array>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace server::wire {

struct NamedValues {
    std::string name;
    std::vector<double> values; // one per surface vertex
    bool doubles = false;       // written as float64, else as float32

    [[nodiscard]] std::size_t value_bytes() const { return doubles ? sizeof(double) : sizeof(float); }
    [[nodiscard]] static NamedValues copy_of(std::string name, ciel::ValuesView values) {
        return {std::move(name), {values.begin(), values.end()}, values.has_doubles()};
    }
};

void write_value(std::ostream& out, const NamedValues& values, ciel::Index vertex);

struct ExportSurface {
    const ciel::Surface& surface;
    ciel::Vec3d origin{}; // added to the positions in double; formats with doubles keep all digits
    std::vector<NamedValues> values;
    bool triangles = false;    // write triangles instead of polygons (STL always has triangles)
    ciel::Vec3d file_origin{}; // subtracted from the coordinates; stated in the file unless zero
    std::span<const ciel::Vec3d>
        places{}; // vertex positions, as precise as the mesh; empty: origin + surface.positions

    [[nodiscard]] ciel::Vec3d place(ciel::Index vertex) const {
        using ciel::operator+, ciel::operator-;
        if (!places.empty()) return places[vertex] - file_origin;
        const ciel::Vec3f& at = surface.positions[vertex];
        return ciel::Vec3d{at[0], at[1], at[2]} + (origin - file_origin);
    }
};

// Returns the point to subtract from coordinates in formats with floats, and in others on request. It is zero if floats
// are precise enough, otherwise the center of the mesh's `bounds` (minimum and maximum per axis) in whole numbers. It
// depends only on the bounds, so that files of one mesh fit together.
[[nodiscard]] ciel::Vec3d file_origin(const std::array<double, 6>& bounds);

struct ExportedCounts {
    std::size_t polygons = 0, vertices = 0;
};

// Returns "X Y Z" with 17 significant digits per number.
[[nodiscard]] std::string origin_text(ciel::Vec3d origin);

// The polygons to write. Polygons without an area are left out. They arise where a mesh vertex has exactly the
// iso-value.
struct ExportedPolygons {
    std::vector<ciel::Index> vertices;  // indices of the used surface vertices
    std::vector<ciel::Index> offset{0}; // start of each polygon in `corner`, and the end of the last polygon
    std::vector<ciel::Index> corner;    // indices into `vertices`

    [[nodiscard]] ExportedCounts counts() const { return {offset.size() - 1, vertices.size()}; }
};
[[nodiscard]] ExportedPolygons exported_polygons(const ciel::Surface& surface, bool triangles);

} // namespace server::wire
