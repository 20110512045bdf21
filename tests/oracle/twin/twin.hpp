// The brute-force twin of the kernel: every cell is cut on its own, with no topology, no blocks and no memory of the
// value before. It shares no code with server/ciel and includes none of its headers.
#pragma once

#include "support/polyhedra.hpp"

#include <map>
#include <set>
#include <string>

namespace ciel::test {

// A surface vertex, named by the mesh edge it lies on: first < second.
using CutEdge = std::pair<Id, Id>;

// Without consecutive repetitions, rotated to begin with its least edge; wound so that the right-hand normal points to
// higher values.
struct CutPolygon {
    Id cell;
    std::vector<CutEdge> edges;
    friend auto operator<=>(const CutPolygon&, const CutPolygon&) = default;
};

// False when fewer than three distinct edges are left: such a polygon is not part of a cut.
[[nodiscard]] bool make_canonical(CutPolygon& polygon);

struct Cut {
    std::set<CutEdge> active_edges;   // that polygons run through: one end >= nu, the other below
    std::vector<CutPolygon> polygons; // sorted
    friend bool operator==(const Cut&, const Cut&) = default;
};

// How the high runs of an ambiguous face are joined: not at all; or where the bilinear interpolation of a quadrangle is
// high at its saddle, the mean of the corners of a face with more.
enum class Joined { never, asymptotic };

// Faces must be wound outwards. High means value >= nu. A cell that touches a vertex without a finite value is not cut.
[[nodiscard]] Cut cut_every_cell(const Polyhedra& mesh, std::span<const float> values, double nu,
                                 Joined joined = Joined::never);

// Empty when equal; otherwise one line that names the first difference.
[[nodiscard]] std::string difference(const Cut& expected, const Cut& actual);

// How often each directed segment between two surface vertices occurs.
using Segments = std::map<std::pair<CutEdge, CutEdge>, int>;
[[nodiscard]] Segments polygon_segments(const std::vector<CutPolygon>& polygons);
// Adds the segments that the surface leaves on one face, wound outwards.
void add_face_segments(std::span<const Id> loop, std::span<const float> values, double nu, Segments& segments,
                       Joined joined = Joined::never);
// The segments that the surface leaves on faces which not exactly two of the cells that are cut claim.
[[nodiscard]] Segments boundary_segments(const Polyhedra& mesh, std::span<const float> values, double nu,
                                         Joined joined = Joined::never);

// Empty when every polygon edge that does not lie on the boundary is matched by one in the opposite direction.
[[nodiscard]] std::string open_segment(const Segments& polygons, const Segments& boundary);

} // namespace ciel::test
