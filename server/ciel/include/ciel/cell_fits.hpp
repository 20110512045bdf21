// CellFits: least-squares matrices of polyhedra for gradients (paper, section 3). The matrices depend on positions
// only, so that several fields can share them. Not in the paper, which solves the least squares again for each field.
#pragma once

#include "ciel/topology.hpp"

#include <cstddef>
#include <limits>
#include <memory>

namespace ciel {

// Keeps the least-squares matrix of each polyhedron whose gradient was computed: about 125 bytes for a cell of a
// Voronoi mesh. Keeps no matrices of standard cells, because these matrices are cheap to compute. The matrices belong
// to the positions of the first extraction that uses them; an extraction with other positions does not use them.
// Several fields may share one object (Field::set_cell_fits). Thread-safe.
class CellFits {
public:
    // `most_bytes`: when the matrices take this much memory, matrices of further blocks are not kept.
    explicit CellFits(const Topology& topology, std::size_t most_bytes = std::numeric_limits<std::size_t>::max());
    ~CellFits();
    CellFits(const CellFits&) = delete;
    CellFits& operator=(const CellFits&) = delete;

    // Frees all matrices. Afterwards the object keeps no new matrices.
    void forget();
    [[nodiscard]] std::size_t memory_bytes() const;

    struct Data; // defined in src/fields/cell_fits.hpp, for the kernel only
    [[nodiscard]] Data& data() const { return *data_; }

private:
    std::unique_ptr<Data> data_;
};

} // namespace ciel
