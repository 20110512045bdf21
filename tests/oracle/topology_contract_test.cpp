// Topology refuses arrays that violate the contract of FaceMeshView.
#include "ciel/topology.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ciel::test {
namespace {

struct Damage {
    const char* name;
    void (*change)(FaceMesh&);
    friend std::ostream& operator<<(std::ostream& out, const Damage& damage) { return out << damage.name; }
};

class DamagedMesh : public testing::TestWithParam<Damage> {};

TEST_P(DamagedMesh, IsRefused) {
    FaceMesh mesh = assemble(view(hexahedra({{3, 2, 2}}))).mesh;
    EXPECT_NO_THROW(Topology{mesh.view()});
    GetParam().change(mesh);
    EXPECT_THROW(Topology{mesh.view()}, Error);
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedMesh,
    testing::Values(Damage{"positions_cut", [](FaceMesh& m) { m.positions.pop_back(); }},
                    Damage{"vertex_beyond_the_last", [](FaceMesh& m) { m.face_vertex[7] = 36; }},
                    Damage{"vertices_too_few", [](FaceMesh& m) { m.positions.resize(9); }},
                    Damage{"offsets_cut", [](FaceMesh& m) { m.face_offset.pop_back(); }},
                    Damage{"offsets_gone", [](FaceMesh& m) { m.face_offset.clear(); }},
                    Damage{"offsets_fall", [](FaceMesh& m) { m.face_offset[4] = 400; }},
                    Damage{"offsets_end_beyond", [](FaceMesh& m) { m.face_offset.back() += 4; }},
                    Damage{"loops_cut", [](FaceMesh& m) { m.face_vertex.pop_back(); }},
                    Damage{"owner_cut", [](FaceMesh& m) { m.owner.pop_back(); }},
                    Damage{"neighbour_cut", [](FaceMesh& m) { m.neighbour.pop_back(); }},
                    Damage{"owner_beyond_the_last", [](FaceMesh& m) { m.owner.back() = 12; }},
                    Damage{"owners_not_sorted", [](FaceMesh& m) { std::swap(m.owner.front(), m.owner.back()); }},
                    Damage{"neighbour_beyond_the_last", [](FaceMesh& m) { m.neighbour[0] = 12; }},
                    Damage{"neighbour_is_owner", [](FaceMesh& m) { m.neighbour[0] = m.owner[0]; }},
                    Damage{"cells_too_few", [](FaceMesh& m) { m.cell_types.pop_back(); }},
                    Damage{"a_loop_turned",
                           [](FaceMesh& m) { std::reverse(m.face_vertex.begin(), m.face_vertex.begin() + 4); }},
                    Damage{"a_loop_with_another_vertex", [](FaceMesh& m) { m.face_vertex[0] = m.face_vertex[20]; }}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace ciel::test
