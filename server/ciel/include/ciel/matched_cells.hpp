// MatchedCells: the cells of a mesh in stored order, with matched faces, but without a list of faces. An import uses
// MatchedCells to write a large mesh block by block. First half of the paper's Algorithm 5 (appendix A).
#pragma once

#include "ciel/assemble.hpp"

#include <memory>
#include <span>

namespace ciel {

// Cells, faces and vertices have the order of Assembled. Immutable after construction and thread-safe.
class MatchedCells {
public:
    // `owner` owns the arrays of `input`; MatchedCells keeps `owner` alive. Throws Error when `owner` is null, and when
    // an array has a wrong size or a cell type is unknown. A bad cell does not throw; it is left out and counted in the
    // report. Uses all threads of parallel_for.
    MatchedCells(const PolyhedraView& input, std::shared_ptr<const void> owner);
    ~MatchedCells();
    MatchedCells(MatchedCells&&) noexcept;
    MatchedCells& operator=(MatchedCells&&) noexcept;

    [[nodiscard]] const AssembleReport& report() const;
    [[nodiscard]] std::span<const Index> original_vertex() const; // stored vertex -> input vertex
    [[nodiscard]] std::span<const Index> original_cell() const;   // stored cell -> input cell
    [[nodiscard]] FaceMesh points() const; // the positions and cell types of the mesh, without faces
    // Returns points() with the boundary faces in the order of numbered_faces().
    [[nodiscard]] FaceMesh boundary() const;
    // Returns the vertices of a cell in ascending order.
    [[nodiscard]] std::vector<Index> corners(Index cell) const;

    struct Data; // defined in src/mesh/matched_cells.hpp, for the kernel only
    [[nodiscard]] const Data& data() const { return *data_; }

private:
    std::unique_ptr<Data> data_;
};

} // namespace ciel
