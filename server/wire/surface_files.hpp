// A surface as a file's bytes: one format per .cpp (export_ply, export_stl, export_vtp).
#pragma once

#include "ciel/extract.hpp"

#include <array>
#include <cstdint>
#include <ostream>
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

enum class SurfaceFormat { ply, stl, vtp };
// STL has floats only.
[[nodiscard]] bool has_floats(SurfaceFormat format);
[[nodiscard]] SurfaceFormat surface_format(const std::string& extension); // ".ply"; throws Error with the known ones

struct ExportedCounts {
    std::size_t polygons = 0, vertices = 0;
};

// "X Y Z", with all digits.
[[nodiscard]] std::string origin_text(Vec3d origin);

// Polygons without area (a value that hits vertices exactly makes them) and vertices that no polygon uses are left out.
// What was written is returned; a failed stream is the caller's to check.
ExportedCounts write_ply(const ExportSurface& surface, std::ostream& out); // binary little-endian, double positions
ExportedCounts write_stl(const ExportSurface& surface, std::ostream& out); // binary; float32 positions and no values
ExportedCounts write_vtp(const ExportSurface& surface, std::ostream& out); // VTK XML, appended raw, double positions
ExportedCounts write_surface(SurfaceFormat format, const ExportSurface& surface, std::ostream& out);

// Of the file, but for its head, which is small: for those who want to know before it is made.
[[nodiscard]] std::uint64_t body_bytes(SurfaceFormat format, const ExportSurface& surface);

// What every format writes.
struct ExportedPolygons {
    std::vector<Index> vertices;  // of the surface
    std::vector<Index> offset{0}; // polygons + 1
    std::vector<Index> corner;    // into `vertices`

    [[nodiscard]] ExportedCounts counts() const { return {offset.size() - 1, vertices.size()}; }
};
[[nodiscard]] ExportedPolygons exported_polygons(const Surface& surface, bool triangles);

} // namespace ciel::wire
