// The data of MatchedCells (paper, appendix A): the order of the cells, and the cell on the other side of each face.
#pragma once

#include "ciel/matched_cells.hpp"
#include "mesh/input_faces.hpp"

namespace ciel {

struct MatchedCells::Data {
    struct OwnFace {
        Index other; // stored cell on the other side, or none
        Index face;  // input face of the owner
    };

    Data(const PolyhedraView& view, std::shared_ptr<const void> arrays) : input(view), owner(std::move(arrays)) {}

    detail::InputFaces input;
    std::shared_ptr<const void> owner;  // owns the arrays of `input`
    std::vector<Index> order;           // stored cell -> input cell
    std::vector<Index> neighbour;       // input face -> stored cell on the other side, or none
    std::vector<std::uint8_t> turn;     // input face -> 1 if its loop must be reversed
    std::vector<Index> own_begin;       // stored cell -> its first own face; then the number of faces
    std::vector<Index> stored_vertex;   // input vertex -> stored vertex, or none
    std::vector<Index> original_vertex; // stored vertex -> input vertex
    AssembleReport report;

    [[nodiscard]] Index cell_count() const { return static_cast<Index>(order.size()); }
    [[nodiscard]] CellType cell_type(Index cell) const;
    // Calls visit(input face, other cell or none) for all faces of a stored cell.
    template <class Visit>
    void for_faces(Index cell, Visit&& visit) const {
        const Index source = order[cell];
        for (Index face = input.begin(source); face < input.end(source); ++face)
            if (input.is_face(source, face)) visit(face, neighbour[face]);
    }
    // Sets `out` to the faces that a stored cell owns, in the order of their ids.
    void list_own(Index cell, std::vector<OwnFace>& out) const;
    [[nodiscard]] FaceMesh points() const; // without faces
    // Appends the stored vertices of a face of the cell, wound outwards.
    void append_loop(Index cell, Index face, std::vector<Index>& out) const;
};

} // namespace ciel
