#include "ciel/mesh_faces.hpp"

#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "ciel/cell_geometry.hpp"
#include "ciel/parallel.hpp"
#include "ciel/vector_operators.hpp"
#include "fields/sparse_array.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace ciel {

using detail::Block;
using detail::CellLoops;
using detail::for_cells;
using detail::read_loops;
using detail::SparseArray;

namespace {

// Returns the faces of a cell in ascending order. Each loop begins at the lowest vertex of the face.
std::vector<std::vector<Index>> sorted_faces(const CellLoops& cell) {
    std::vector<std::vector<Index>> faces;
    for (std::size_t i = 0; i < cell.count(); ++i) {
        faces.emplace_back(cell.face(i).begin(), cell.face(i).end());
        std::vector<Index>& face = faces.back();
        std::rotate(face.begin(), std::ranges::min_element(face), face.end());
    }
    std::ranges::sort(faces);
    return faces;
}

} // namespace

std::vector<CellFace> boundary_faces(const FaceMeshView& mesh) {
    std::vector<CellFace> faces;
    for (Index face = 0; face < mesh.face_count(); ++face)
        if (mesh.neighbour[face] == none) faces.push_back({face, mesh.owner[face]});
    return faces;
}

std::vector<CellFace> faces_by_id(const FaceMeshView& mesh, std::vector<Index> ids,
                                  std::span<const std::uint8_t> kept) {
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::vector<CellFace> faces;
    for (const Index face : ids)
        if (const Index owner = mesh.owner[face]; kept.empty() || kept[owner] != 0) faces.push_back({face, owner});
    return faces;
}

std::vector<CellFace> boundary_faces_at(const FaceMeshView& mesh, const Field& field, double level, double tolerance) {
    std::vector<CellFace> faces;
    std::vector<Index> loop;
    for (Index face = 0; face < mesh.face_count(); ++face) {
        if (mesh.neighbour[face] != none) continue;
        read_loop(mesh, face, loop);
        mesh.load(loop);
        if (std::ranges::all_of(loop, [&](Index vertex) { return std::abs(field.value(vertex) - level) <= tolerance; }))
            faces.push_back({face, mesh.owner[face]});
    }
    return faces;
}

Index face_with_vertices(const FaceMeshView& mesh, std::span<const Index> ids, std::span<const Index> vertices) {
    const auto has_all = [&](Index face) {
        const Ids loop = mesh.loop(face);
        return std::ranges::all_of(
            vertices, [&](Index vertex) { return std::find(loop.begin(), loop.end(), vertex) != loop.end(); });
    };
    const auto found = std::find_if(ids.begin(), ids.end(), has_all);
    return found == ids.end() ? none : *found;
}

Surface vertices_of_cells(const Topology& topology, const FaceMeshView& points, std::span<const std::uint8_t> kept) {
    const Topology::Blocks& blocks = topology.blocks();
    if (points.vertex_count() != topology.counts().vertices ||
        (!kept.empty() && kept.size() != topology.counts().cells))
        fail("the positions or the cell flags belong to another mesh than the topology; pass those of the same mesh");
    SparseArray<std::uint8_t> used(points.vertex_count());
    const auto mark = [&used](Index vertex) {
        std::atomic_ref(used.get()[vertex]).store(1, std::memory_order_relaxed);
    };
    // Without flags, marks all vertices that belong to a cell. Vertices that belong to no cell have the last ids.
    if (kept.empty() && blocks.count() > 0)
        std::ranges::fill(used.all().first(blocks.numbers.vertex.back()), std::uint8_t{1});
    parallel_for(kept.empty() ? 0 : blocks.count(), 1, [&](std::size_t begin, std::size_t end) {
        CellLoops loops;
        for (auto b = static_cast<Index>(begin); b < end; ++b) {
            const Index first = blocks.numbers.cell[b];
            const auto flags = kept.subspan(first, blocks.numbers.cell[b + 1] - first);
            if (std::ranges::none_of(flags, [](std::uint8_t flag) { return flag != 0; })) continue;
            for_cells(blocks.cells(b), loops, [&](Index cell, const CellLoops& of_cell) {
                if (kept[cell] != 0) std::ranges::for_each(of_cell.vertex, mark);
            });
        }
    });
    Surface out;
    for (Index vertex = 0; vertex < used.size(); ++vertex) {
        if (used.get()[vertex] == 0) continue;
        points.load({&vertex, 1});
        out.positions.push_back(surface_position(points, vertex));
        out.points.push_back({vertex, vertex, 0});
    }
    return out;
}

std::vector<Index> corners_of_cell(const Topology& topology, Index cell) {
    const Topology::Blocks& blocks = topology.blocks();
    if (cell >= topology.counts().cells) fail("the mesh has no cell " + std::to_string(cell));
    const Block& block = blocks.cells(blocks.block_of_cell(cell));
    CellLoops loops;
    read_loops(block, cell - block.cell_begin, loops);
    std::ranges::sort(loops.vertex);
    loops.vertex.erase(std::unique(loops.vertex.begin(), loops.vertex.end()), loops.vertex.end());
    return std::move(loops.vertex);
}

bool same_cells(const Topology& a, const Topology& b) {
    if (a.counts().cells != b.counts().cells || a.counts().vertices != b.counts().vertices) return false;
    const Topology::Blocks &blocks = a.blocks(), &others = b.blocks();
    std::atomic<bool> same = true;
    parallel_for(blocks.count(), 4, [&](std::size_t begin, std::size_t end) {
        CellLoops loops, other;
        for (auto block = static_cast<Index>(begin); block < end && same; ++block)
            for_cells(blocks.cells(block), loops, [&](Index cell, const CellLoops& of_cell) {
                const Block& holder = others.cells(others.block_of_cell(cell));
                read_loops(holder, cell - holder.cell_begin, other);
                if (sorted_faces(of_cell) != sorted_faces(other)) same = false;
            });
    });
    return same;
}

FacesSize size_of_faces(const FaceMeshView& mesh, std::span<const Index> ids) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    FacesSize size{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, 0};
    std::vector<Index> loop;
    for (const Index face : ids) {
        read_loop(mesh, face, loop);
        mesh.load(loop);
        for (const Index vertex : loop) {
            const Vec3d at = mesh.origin + position(mesh, vertex);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                size.low[axis] = std::min(size.low[axis], at[axis]);
                size.high[axis] = std::max(size.high[axis], at[axis]);
            }
        }
        if (!loop.empty()) size.area += length(face_shape(mesh, loop).area);
    }
    return size;
}

} // namespace ciel
