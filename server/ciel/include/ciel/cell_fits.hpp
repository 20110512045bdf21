// CellFits: the part of the cells' gradients (paper, section 3) that depends on positions only. Not in the paper, which
// solves the least squares again for each field.
#pragma once

#include "ciel/topology.hpp"

#include <cstddef>
#include <limits>
#include <memory>

namespace ciel {

// Keeps the least-squares matrices for the gradients in polyhedra, each made at its first use: about 125 bytes for a
// cell of a Voronoi mesh. Keeps none for standard cells, because their matrices are cheap to compute. Several fields
// may share the matrices (Field::set_cell_fits). The matrices belong to the positions with which the first of these
// fields is cut; a field that is cut with other positions does not use them. Thread-safe.
class CellFits {
public:
    // Once the fits take `most_bytes`, those of further blocks are not kept. The topology must outlive this object.
    explicit CellFits(const Topology& topology, std::size_t most_bytes = std::numeric_limits<std::size_t>::max());
    ~CellFits();
    CellFits(const CellFits&) = delete;
    CellFits& operator=(const CellFits&) = delete;

    // Frees the memory of the fits. From then on no fits are kept.
    void forget();
    [[nodiscard]] std::size_t memory_bytes() const;

    struct Data; // fields/cell_fits.hpp
    [[nodiscard]] Data& data() const { return *data_; }

private:
    std::unique_ptr<Data> data_;
};

} // namespace ciel
