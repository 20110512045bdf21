// The kernel's view of a test mesh.
#pragma once

#include "ciel/assemble.hpp"
#include "support/polyhedra.hpp"

namespace ciel::test {

// Borrows from `mesh`.
[[nodiscard]] inline PolyhedraView view(const Polyhedra& mesh) {
    return {mesh.origin, mesh.positions, mesh.cell_types, mesh.cell_offset, mesh.face_offset, mesh.face_vertex};
}

} // namespace ciel::test
