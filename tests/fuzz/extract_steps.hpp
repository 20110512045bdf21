// A small mesh with valid and damaged cells, fields and values, each read from a few bytes.
#pragma once

#include "fuzz/bytes.hpp"
#include "support/meshes.hpp"

namespace ciel::test {

[[nodiscard]] inline Polyhedra lattice_from(Bytes& bytes) {
    const int kind = bytes.next() % 10;
    Box box{{bytes.next() % 3 + 1, bytes.next() % 3 + 1, bytes.next() % 3 + 1}, 0, 1, 1};
    box.jitter = bytes.next() % 4 * 0.1;
    box.seed = bytes.next();
    switch (kind) {
    case 0:
        return hexahedra(box);
    case 1:
        return tetrahedra(box);
    case 2:
        return wedges(box);
    case 3:
        return pyramids(box);
    case 4:
        return hanging_nodes(box);
    case 5:
        return voronoi(box.cubes[0] * box.cubes[1] * 3, box.seed);
    case 6:
        return hexagonal_prisms(box.cubes[0], box.cubes[1], box.cubes[2]);
    case 7:
        return collapsed_edges(box);
    case 8:
        return o_grid(box.cubes[0], box.cubes[1] + 2, box.cubes[2]);
    default:
        return zoo(box);
    }
}

inline void spoil(Polyhedra& mesh, Bytes& bytes) {
    for (int edits = bytes.next() % 8; edits > 0 && mesh.vertex_count() > 0; --edits) {
        const std::uint8_t what = bytes.next(), where = bytes.next();
        const std::size_t at = where % mesh.vertex_count();
        switch (what % 8) {
        case 0:
            mesh.positions[3 * at + what / 8 % 3] = number(bytes.next());
            break;
        case 1: // moves the vertex onto another one
            for (std::size_t d = 0; d < 3; ++d)
                mesh.positions[3 * at + d] = mesh.positions[3 * ((at + what) % mesh.vertex_count()) + d];
            break;
        case 2: { // replaces a vertex id by another one
            Id& id = mesh.face_vertex[(256U * what + where) % mesh.face_vertex.size()];
            id = bytes.next() % mesh.vertex_count();
            break;
        }
        case 3:
            mesh = keep_cells(mesh, [where](Id cell) { return (cell * 37 + where) % 5 != 0; });
            break;
        case 4:
            mesh = agglomerated(mesh, where % 5 + 2, what);
            break;
        case 5:
            mesh = with_turned_faces(mesh, 0.2, where);
            break;
        case 6:
            mesh = with_turned_cells(mesh, 0.3, where);
            break;
        default:
            mesh = shuffled(mesh, where).mesh;
            break;
        }
        if (mesh.face_vertex.empty()) return;
    }
}

// Few distinct numbers, distributed over the vertices, give ties, plateaus and missing values.
[[nodiscard]] inline std::vector<float> field_from(Bytes& bytes, std::size_t vertices) {
    std::vector<float> numbers(bytes.next() % 12 + 1U);
    for (float& one : numbers) one = number(bytes.next());
    std::uint32_t state = bytes.next();
    std::vector<float> values(vertices);
    for (float& value : values) {
        state = state * 1664525 + 1013904223;
        value = numbers[(state >> 16) % numbers.size()];
    }
    return values;
}

} // namespace ciel::test
