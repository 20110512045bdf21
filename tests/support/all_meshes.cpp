#include "support/meshes.hpp"

namespace ciel::test {
namespace {

constexpr Box small{{3, 4, 3}, 0, 11};
constexpr Box jittered{{4, 3, 4}, 0.15, 12};

Polyhedra cubes_touching(bool at_edge) {
    return keep_cells(hexahedra({{2, 2, 2}}), [&](Id c) { return c == 0 || c == (at_edge ? 3 : 7); });
}

Polyhedra with_voids(const Polyhedra& mesh) {
    return keep_cells(mesh, [](Id c) { return (c * 2654435761U >> 8) % 4 != 0; });
}

} // namespace

const std::vector<NamedMesh>& all_meshes() {
    static const std::vector<NamedMesh> meshes{
        {"no_cells", [] { return Polyhedra{}; }},
        {"one_tetrahedron",
         [] {
             return keep_cells(tetrahedra({{1, 1, 1}}), [](Id c) { return c == 0; });
         }},
        {"one_hexahedron",
         [] {
             return hexahedra({{1, 1, 1}});
         }},
        {"one_polyhedron", [] { return hexagonal_prisms(1, 1, 1); }},
        {"tetrahedra", [] { return tetrahedra(jittered); }},
        {"tetrahedra_shuffled", [] { return shuffled(tetrahedra(jittered), 21).mesh; }},
        {"five_tetrahedra", [] { return five_tetrahedra(small); }},
        {"hexahedra", [] { return hexahedra(small); }},
        {"hexahedra_jittered",
         [] {
             return hexahedra({{6, 5, 4}, 0.2, 13});
         },
         false},
        {"wedges", [] { return wedges(jittered); }, false},
        {"pyramids", [] { return pyramids(jittered); }, false},
        {"zoo",
         [] {
             return zoo({{5, 4, 4}, 0, 14});
         }},
        {"zoo_shuffled",
         [] {
             return shuffled(zoo({{5, 4, 4}, 0.1, 15}), 22).mesh;
         },
         false},
        {"voronoi", [] { return voronoi(150, 16); }},
        {"hexagonal_prisms", [] { return hexagonal_prisms(4, 4, 3); }},
        {"collapsed_edges",
         [] {
             return collapsed_edges({{6, 4, 4}, 0.1, 17});
         },
         false, true},
        {"o_grid", [] { return o_grid(3, 7, 3); }, true, true},
        {"hanging_nodes",
         [] {
             return hanging_nodes({{4, 4, 3}, 0, 18});
         }},
        {"hanging_nodes_jittered",
         [] {
             return hanging_nodes({{4, 3, 4}, 0.05, 19});
         },
         false},
        {"t_junctions",
         [] {
             return t_junctions({{3, 4, 3}, 0, 20});
         }},
        {"voids_in_hexahedra",
         [] {
             return with_voids(hexahedra({{5, 5, 5}}));
         }},
        {"voids_in_voronoi", [] { return with_voids(voronoi(150, 23)); }},
        {"agglomerated_hexahedra",
         [] {
             return agglomerated(hexahedra({{5, 5, 4}}), 4, 24);
         }},
        {"agglomerated_tetrahedra", [] { return agglomerated(tetrahedra(jittered), 5, 25); }},
        {"components",
         [] {
             return joined(voronoi(40, 26), joined(hexahedra(small), tetrahedra(small), {9, 0, 0}), {3, 3, 3});
         }},
        {"touching_at_an_edge", [] { return cubes_touching(true); }},
        {"touching_at_a_vertex", [] { return cubes_touching(false); }},
    };
    return meshes;
}

} // namespace ciel::test
