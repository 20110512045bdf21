// Faces of cells that list their faces (the input of the paper, appendix A), and of standard cells that list their
// corners (PolyhedraView).
#pragma once

#include "ciel/assemble.hpp"

#include <array>

namespace ciel::detail {

// Numbers the faces of all cells, cell by cell. Thread-safe. The arrays of the input must outlive the object.
class InputFaces {
public:
    using Corners = std::array<Index, 4>; // the largest face of a standard cell has four

    // Throws Error when an array of `input` has a wrong size, a cell type is unknown, or there are too many faces.
    explicit InputFaces(const PolyhedraView& input);

    [[nodiscard]] const PolyhedraView& input() const { return input_; }
    [[nodiscard]] Index cell_count() const { return static_cast<Index>(input_.cell_types.size()); }
    [[nodiscard]] Index vertex_count() const { return static_cast<Index>(input_.positions.size() / 3); }
    [[nodiscard]] Index face_count() const { return begin_.back(); }
    // The faces of a cell have the ids begin(cell) to end(cell) - 1.
    [[nodiscard]] Index begin(Index cell) const { return begin_[cell]; }
    [[nodiscard]] Index end(Index cell) const { return begin_[cell + 1]; }
    [[nodiscard]] Index cell_of(Index face) const;

    // Returns the vertex ids of a face of the cell. For a standard cell, the ids are written to `scratch`, to which the
    // result points.
    [[nodiscard]] std::span<const Index> loop(Index cell, Index face, Corners& scratch) const;
    [[nodiscard]] std::size_t size(Index cell, Index face) const;
    [[nodiscard]] bool is_face(Index cell, Index face) const { return has_corners(cell) || size(cell, face) >= 3; }

private:
    [[nodiscard]] bool has_corners(Index cell) const {
        return !input_.corner_offset.empty() && input_.corner_offset[cell] != input_.corner_offset[cell + 1];
    }
    [[nodiscard]] std::uint64_t listed_faces(Index cell) const {
        return input_.cell_offset.empty() ? 0 : input_.cell_offset[cell + 1] - input_.cell_offset[cell];
    }
    void check_offsets() const;
    void check_cells() const;
    void number_faces();

    PolyhedraView input_;
    std::vector<Index> begin_; // C + 1: the first face of each cell
};

} // namespace ciel::detail
