// Brute-force reimplementation of the kernel: cuts every cell separately, without topology, blocks or state. Shares no
// code with server/ciel and includes none of its headers.
#pragma once

#include "support/polyhedra.hpp"

#include <map>
#include <set>
#include <string>

namespace ciel::test {

// A surface vertex, identified by the mesh edge that contains it: first < second.
using CutEdge = std::pair<Id, Id>;

// Edges have no consecutive duplicates and start with the least edge. By the right-hand rule the normal points to
// higher values.
struct CutPolygon {
    Id cell;
    std::vector<CutEdge> edges;
    friend auto operator<=>(const CutPolygon&, const CutPolygon&) = default;
};

// Returns false when fewer than three distinct edges are left. Such a polygon is not part of a cut.
[[nodiscard]] bool make_canonical(CutPolygon& polygon);

struct Cut {
    std::set<CutEdge> active_edges;   // edges at polygon vertices: one end >= nu, the other below
    std::vector<CutPolygon> polygons; // sorted by cell, then edges
    friend bool operator==(const Cut&, const Cut&) = default;
};

// Whether runs of high vertices on an ambiguous face are joined. `asymptotic`: when the value at the bilinear saddle of
// a quadrilateral, or the mean of a larger face, is high.
enum class Joined { never, asymptotic };

// Faces must be wound outwards. A vertex is high when its value >= nu. Cells at a vertex without a finite value are not
// cut.
[[nodiscard]] Cut cut_every_cell(const Polyhedra& mesh, std::span<const float> values, double nu,
                                 Joined joined = Joined::never);

// Returns an empty string when equal, otherwise one line about the first difference.
[[nodiscard]] std::string difference(const Cut& expected, const Cut& actual);

// Number of occurrences of each directed segment between two surface vertices.
using Segments = std::map<std::pair<CutEdge, CutEdge>, int>;
[[nodiscard]] Segments polygon_segments(const std::vector<CutPolygon>& polygons);
// Adds the segments of the surface on one face, which must be wound outwards.
void add_face_segments(std::span<const Id> loop, std::span<const float> values, double nu, Segments& segments,
                       Joined joined = Joined::never);
// Segments of the surface on mesh faces that do not have exactly two cells with values.
[[nodiscard]] Segments boundary_segments(const Polyhedra& mesh, std::span<const float> values, double nu,
                                         Joined joined = Joined::never);

// Returns an empty string when every polygon edge has an opposite one or lies on the boundary.
[[nodiscard]] std::string open_segment(const Segments& polygons, const Segments& boundary);

} // namespace ciel::test
