#include "ciel/threshold_surface.hpp"

#include "ciel/parallel.hpp"
#include "extraction/polygon.hpp"
#include "polygons/face_polygons.hpp"

#include <algorithm>

namespace ciel::detail {

namespace {

constexpr Index polygons_per_chunk = 4096;

} // namespace

void add_chunks(Surface& surface) {
    const auto polygons = static_cast<Index>(surface.polygon_cell.size());
    for (Index begin = 0; begin < polygons; begin += polygons_per_chunk)
        surface.chunks.push_back({begin / polygons_per_chunk, begin, std::min(begin + polygons_per_chunk, polygons)});
}

Surface FacePolygons::take() && {
    add_chunks(surface_);
    return std::move(surface_);
}

} // namespace ciel::detail

namespace ciel {

std::vector<std::uint8_t> cells_in_range(const FaceMeshView& mesh, ValuesView values, std::array<double, 2> range,
                                         InRange vertices) {
    if (values.size() != mesh.vertex_count())
        fail("a threshold needs one value for each vertex of the mesh; pass as many values as the mesh has vertices");
    std::vector<std::uint8_t> of_face(mesh.face_count());
    parallel_for(of_face.size(), 65536, [&](std::size_t begin, std::size_t end) {
        const auto inside = [&](Index v) { return values[v] >= range[0] && values[v] <= range[1]; };
        for (std::size_t f = begin; f < end; ++f) {
            const auto loop = mesh.loop(static_cast<Index>(f));
            of_face[f] =
                vertices == InRange::all ? std::ranges::all_of(loop, inside) : std::ranges::any_of(loop, inside);
        }
    });
    std::vector<std::uint8_t> kept(mesh.cell_count(), 0), outside(mesh.cell_count(), 0);
    for (Index f = 0; f < mesh.face_count(); ++f)
        for (const Index cell : {mesh.owner[f], mesh.neighbour[f]})
            if (cell != none) (of_face[f] != 0 ? kept : outside)[cell] = 1;
    if (vertices == InRange::all)
        for (std::size_t c = 0; c < kept.size(); ++c) kept[c] = kept[c] != 0 && outside[c] == 0 ? 1 : 0;
    return kept;
}

std::vector<std::uint8_t> cells_in_range(ValuesView of_cells, std::array<double, 2> range) {
    std::vector<std::uint8_t> kept(of_cells.size());
    of_cells.with([&](const auto& values) {
        std::ranges::transform(values, kept.begin(),
                               [&](auto value) { return value >= range[0] && value <= range[1] ? 1 : 0; });
    });
    return kept;
}

std::vector<CellFace> threshold_faces(const FaceMeshView& mesh, std::span<const std::uint8_t> kept) {
    std::vector<CellFace> faces;
    const auto keeps = [&](Index cell) { return cell != none && kept[cell] != 0; };
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const Index owner = mesh.owner[f], neighbour = mesh.neighbour[f];
        if (keeps(owner) != keeps(neighbour)) faces.push_back({f, keeps(owner) ? owner : neighbour});
    }
    return faces;
}

Surface face_surface(const FaceMeshView& mesh, std::span<const CellFace> faces) {
    detail::FacePolygons polygons(mesh);
    std::vector<Index> loop;
    for (const auto& [face, cell] : faces) {
        const Ids stored = mesh.loop(face);
        loop.assign(stored.begin(), stored.end());
        if (cell != mesh.owner[face]) std::ranges::reverse(loop);
        polygons.add(loop, cell, face);
    }
    return std::move(polygons).take();
}

Surface polygons_of_cells(const Surface& surface, std::span<const std::uint8_t> kept) {
    if (surface.points.size() != surface.positions.size())
        fail("a clipped surface cannot be filtered by cell: clipping made " +
             std::to_string(surface.positions.size() - surface.points.size()) +
             " of the surface's vertices, and these lie on no edge of the mesh; filter the surface before it is "
             "clipped");
    if (std::ranges::any_of(surface.polygon_cell, [&](Index cell) { return cell >= kept.size(); }))
        fail("a polygon belongs to a cell that has no flag, because there are only " + std::to_string(kept.size()) +
             " flags; pass one flag for each cell of the mesh");
    Surface out;
    std::vector<Index> place(surface.positions.size(), none);
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        if (kept[surface.polygon_cell[i]] == 0) continue;
        for (const Index point : detail::polygon(surface, i)) {
            if (place[point] == none) {
                place[point] = static_cast<Index>(out.positions.size());
                out.positions.push_back(surface.positions[point]);
                out.points.push_back(surface.points[point]);
                if (!surface.normals.empty()) out.normals.push_back(surface.normals[point]);
            }
            out.polygon_vertex.push_back(place[point]);
        }
        out.polygon_offset.push_back(static_cast<Index>(out.polygon_vertex.size()));
        out.polygon_cell.push_back(surface.polygon_cell[i]);
        if (!surface.polygon_face.empty()) out.polygon_face.push_back(surface.polygon_face[i]);
    }
    detail::add_chunks(out);
    return out;
}

} // namespace ciel
