// Converts test meshes to the kernel's input views.
#pragma once

#include "ciel/assemble.hpp"
#include "support/polyhedra.hpp"

namespace ciel::test {

// The view borrows from `mesh`.
[[nodiscard]] inline PolyhedraView view(const Polyhedra& mesh) {
    return {mesh.origin, mesh.positions, mesh.cell_types, mesh.cell_offset, mesh.face_offset, mesh.face_vertex};
}

} // namespace ciel::test
