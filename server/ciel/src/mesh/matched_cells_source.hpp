// The faces of MatchedCells, the input of Algorithm 5 (paper, appendix A), block by block.
#pragma once

#include "mesh/face_source.hpp"
#include "mesh/matched_cells.hpp"

namespace ciel::detail {

class MatchedCellsSource final : public FaceSource {
public:
    explicit MatchedCellsSource(const MatchedCells::Data& cells) : cells_(cells) {} // must outlive the object

    Index vertex_count() const override { return static_cast<Index>(cells_.original_vertex.size()); }
    void list(Index cell_begin, Index cell_end, FaceLoops& out) const override;
    void refuse() const override;

    [[nodiscard]] Index cell_count() const { return cells_.cell_count(); }
    [[nodiscard]] Index face_count() const { return cells_.own_begin.back(); }
    // Calls visit(number of corners, owner) for the faces of the cell. A face with repeated vertices may have another
    // number of corners in its other cell.
    template <class Visit>
    void for_faces_of(Index cell, Visit&& visit) const {
        cells_.for_faces(cell, [&](Index face, Index other) {
            if (other == cell) return; // the cell has the face three times; two of them were matched
            visit(cells_.input.size(cells_.order[cell], face), other < cell ? other : cell);
        });
    }
    // Calls visit(owner, neighbour or none, vertices) for all faces.
    template <class Visit>
    void for_faces(Visit&& visit) const {
        std::vector<Index> loop;
        for (Index cell = 0; cell < cell_count(); ++cell)
            cells_.for_faces(cell, [&](Index face, Index other) {
                if (other < cell) return;
                loop.clear();
                cells_.append_loop(cell, face, loop);
                visit(cell, other, loop);
            });
    }

private:
    const MatchedCells::Data& cells_;
};

} // namespace ciel::detail
