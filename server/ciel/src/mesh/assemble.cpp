#include "ciel/assemble.hpp"

#include "ciel/parallel.hpp"
#include "mesh/matched_cells.hpp"

#include <algorithm>

namespace ciel {

namespace {

constexpr std::size_t cells_per_task = 4096;

using OwnFaces = std::vector<MatchedCells::Data::OwnFace>;

void list_faces(const MatchedCells::Data& cells, FaceMesh& out) {
    const std::size_t count = cells.own_begin.back();
    out.owner.reserve(count);
    out.neighbour.reserve(count);
    out.face_offset.reserve(count + 1);
    out.face_offset.assign(1, 0);
    OwnFaces faces;
    for (Index cell = 0; cell < cells.cell_count(); ++cell) {
        cells.list_own(cell, faces);
        for (const auto& [other, face] : faces) {
            out.owner.push_back(cell);
            out.neighbour.push_back(other);
            out.face_offset.push_back(out.face_offset.back() + cells.input.size(cells.order[cell], face));
        }
    }
}

void write_loops(const MatchedCells::Data& cells, FaceMesh& out) {
    out.face_vertex.resize(out.face_offset.back());
    parallel_for(cells.cell_count(), cells_per_task, [&](std::size_t begin, std::size_t end) {
        OwnFaces faces;
        std::vector<Index> loops; // of one cell
        for (auto cell = static_cast<Index>(begin); cell < end; ++cell) {
            cells.list_own(cell, faces);
            loops.clear();
            for (const auto& [other, face] : faces) cells.append_loop(cell, face, loops);
            std::ranges::copy(loops, out.face_vertex.begin() +
                                         static_cast<std::ptrdiff_t>(out.face_offset[cells.own_begin[cell]]));
        }
    });
}

} // namespace

Assembled assemble(const PolyhedraView& input) {
    // A pointer that owns nothing, because the caller owns the arrays during this call.
    const std::shared_ptr<const void> caller(std::shared_ptr<const void>(), &input);
    const MatchedCells matched(input, caller);
    const MatchedCells::Data& cells = matched.data();
    Assembled out;
    out.mesh = cells.points();
    list_faces(cells, out.mesh);
    write_loops(cells, out.mesh);
    out.original_vertex = cells.original_vertex;
    out.original_cell = cells.order;
    out.report = cells.report;
    return out;
}

} // namespace ciel
