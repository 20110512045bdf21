#include "unit/ciel/meshes.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace ciel::test {

Index Polyhedra::vertex(double x, double y, double z) {
    for (const double p : {x, y, z}) positions.push_back(static_cast<float>(p));
    return static_cast<Index>(positions.size() / 3 - 1);
}

void Polyhedra::cell(CellType type, const std::vector<Index>& corners) {
    types.push_back(static_cast<std::uint8_t>(type));
    append_standard_faces(type, corners, face_offset, face_vertex);
    cell_offset.push_back(face_offset.size() - 1);
}

void Polyhedra::polyhedron(const std::vector<std::vector<Index>>& faces) {
    types.push_back(static_cast<std::uint8_t>(CellType::polyhedron));
    for (const auto& face : faces) {
        face_vertex.insert(face_vertex.end(), face.begin(), face.end());
        face_offset.push_back(face_vertex.size());
    }
    cell_offset.push_back(face_offset.size() - 1);
}

PolyhedraView Polyhedra::view() const { return {{}, positions, types, cell_offset, face_offset, face_vertex}; }

Polyhedra one_tetrahedron() {
    Polyhedra mesh;
    mesh.vertex(0, 0, 0);
    mesh.vertex(1, 0, 0);
    mesh.vertex(0, 1, 0);
    mesh.vertex(0, 0, 1);
    mesh.cell(CellType::tetrahedron, {0, 1, 2, 3});
    return mesh;
}

namespace {

using Corners = std::array<Index, 8>; // in VTK's order for a hexahedron

Polyhedra grid(Index nx, Index ny, Index nz, const std::function<void(Polyhedra&, const Corners&, Index)>& add) {
    Polyhedra mesh;
    for (Index k = 0; k <= nz; ++k)
        for (Index j = 0; j <= ny; ++j)
            for (Index i = 0; i <= nx; ++i) mesh.vertex(i, j, k);
    const auto at = [&](Index i, Index j, Index k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
    Index number = 0;
    for (Index k = 0; k < nz; ++k)
        for (Index j = 0; j < ny; ++j)
            for (Index i = 0; i < nx; ++i)
                add(mesh,
                    {at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
                     at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)},
                    number++);
    return mesh;
}

} // namespace

Polyhedra hexahedra(Index nx, Index ny, Index nz) {
    return grid(nx, ny, nz, [](Polyhedra& mesh, const Corners& c, Index) {
        mesh.cell(CellType::hexahedron, {c.begin(), c.end()});
    });
}

Polyhedra tetrahedra(Index nx, Index ny, Index nz) {
    return grid(nx, ny, nz, [](Polyhedra& mesh, const Corners& c, Index) {
        // Kuhn's six tetrahedra around the diagonal 0-6.
        constexpr int paths[6][2] = {{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}};
        for (const auto& p : paths)
            mesh.cell(CellType::tetrahedron,
                      {c[0], c[static_cast<std::size_t>(p[0])], c[static_cast<std::size_t>(p[1])], c[6]});
    });
}

Polyhedra hexagonal_prisms(Index nx, Index ny, Index nz) {
    Polyhedra mesh;
    // Vertices of a honeycomb. Column i is a zigzag: (i, j) is at height 0.866 j, shifted in x by 0.25 alternately.
    const Index columns = nx + 1, rows = 2 * ny + 2;
    for (Index k = 0; k <= nz; ++k)
        for (Index i = 0; i < columns; ++i)
            for (Index j = 0; j < rows; ++j) mesh.vertex(1.5 * i + ((i + j) % 2 != 0 ? 0.25 : -0.25), 0.866 * j, k);
    const auto at = [&](Index i, Index j, Index k) { return (k * columns + i) * rows + j; };
    for (Index k = 0; k < nz; ++k)
        for (Index i = 0; i < nx; ++i)
            for (Index j = i % 2; j + 2 < rows; j += 2) {
                const std::vector<Index> low{at(i, j, k),         at(i + 1, j, k), at(i + 1, j + 1, k),
                                             at(i + 1, j + 2, k), at(i, j + 2, k), at(i, j + 1, k)};
                std::vector<Index> high;
                for (const Index v : low) high.push_back(v + columns * rows);
                std::vector<std::vector<Index>> faces{{low.rbegin(), low.rend()}, high};
                for (std::size_t s = 0; s < 6; ++s)
                    faces.push_back({low[s], low[(s + 1) % 6], high[(s + 1) % 6], high[s]});
                mesh.polyhedron(faces);
            }
    return mesh;
}

Polyhedra hanging_nodes() {
    Polyhedra mesh;
    for (int k = 0; k <= 2; ++k)
        for (int j = 0; j <= 2; ++j)
            for (int i = 0; i <= 1; ++i) mesh.vertex(2 + i, j, k);
    const auto fine = [](Index i, Index j, Index k) { return (k * 3 + j) * 2 + i; };
    for (Index k = 0; k < 2; ++k)
        for (Index j = 0; j < 2; ++j)
            mesh.cell(CellType::hexahedron,
                      {fine(0, j, k), fine(1, j, k), fine(1, j + 1, k), fine(0, j + 1, k), fine(0, j, k + 1),
                       fine(1, j, k + 1), fine(1, j + 1, k + 1), fine(0, j + 1, k + 1)});
    const Index a = mesh.vertex(0, 0, 0), b = mesh.vertex(0, 2, 0), c = mesh.vertex(0, 2, 2), d = mesh.vertex(0, 0, 2);
    const auto f = [&](Index j, Index k) { return fine(0, j, k); };
    mesh.polyhedron({{a, d, c, b},
                     {a, b, f(2, 0), f(1, 0), f(0, 0)},
                     {d, f(0, 2), f(1, 2), f(2, 2), c},
                     {a, f(0, 0), f(0, 1), f(0, 2), d},
                     {b, c, f(2, 2), f(2, 1), f(2, 0)},
                     {f(0, 0), f(1, 0), f(1, 1), f(0, 1)},
                     {f(1, 0), f(2, 0), f(2, 1), f(1, 1)},
                     {f(0, 1), f(1, 1), f(1, 2), f(0, 2)},
                     {f(1, 1), f(2, 1), f(2, 2), f(1, 2)}});
    return mesh;
}

Polyhedra mixed_cells() {
    Polyhedra mesh = hexahedra(1, 1, 1); // vertex id = x + 2 y + 4 z
    const Index apex = mesh.vertex(0.5, 0.5, 2);
    mesh.cell(CellType::pyramid, {4, 5, 7, 6, apex});
    const Index w0 = mesh.vertex(2, 0, 0), w1 = mesh.vertex(2, 0, 1);
    mesh.cell(CellType::wedge, {1, 3, w0, 5, 7, w1});
    mesh.cell(CellType::tetrahedron, {5, 7, w1, apex});
    const Index p = mesh.vertex(0.5, -1, 0.5);
    mesh.polyhedron({{0, 1, 5, 4}, {p, 0, 1}, {p, 1, 5}, {p, 5, 4}, {p, 4, 0}});
    return mesh;
}

Polyhedra collapsed_hexahedra(Index sectors) {
    Polyhedra mesh;
    for (int k = 0; k <= 1; ++k) mesh.vertex(0, 0, k);
    const auto ring = [&](Index r, Index s, Index k) { return 2 + ((k * 2 + r) * sectors + s % sectors); };
    for (int k = 0; k <= 1; ++k)
        for (int r = 1; r <= 2; ++r)
            for (Index s = 0; s < sectors; ++s) {
                const double angle = 2 * 3.14159265358979 * s / sectors;
                mesh.vertex(r * std::cos(angle), r * std::sin(angle), k);
            }
    for (Index s = 0; s < sectors; ++s) {
        mesh.cell(CellType::hexahedron,
                  {0, ring(0, s, 0), ring(0, s + 1, 0), 0, 1, ring(0, s, 1), ring(0, s + 1, 1), 1});
        mesh.cell(CellType::hexahedron, {ring(0, s, 0), ring(1, s, 0), ring(1, s + 1, 0), ring(0, s + 1, 0),
                                         ring(0, s, 1), ring(1, s, 1), ring(1, s + 1, 1), ring(0, s + 1, 1)});
    }
    return mesh;
}

Polyhedra cubes_that_share_an_edge() {
    return grid(2, 2, 1, [](Polyhedra& mesh, const Corners& c, Index number) {
        if (number == 0 || number == 3) mesh.cell(CellType::hexahedron, {c.begin(), c.end()});
    });
}

Polyhedra hollow_box() {
    return grid(3, 3, 3, [](Polyhedra& mesh, const Corners& c, Index number) {
        if (number != 13) mesh.cell(CellType::hexahedron, {c.begin(), c.end()});
    });
}

namespace {

// Joins the cells for which `merged` is true into one polyhedron, without the faces between them. Keeps the other
// cells.
Polyhedra merge(const Polyhedra& cells, const std::function<bool(Index)>& merged) {
    Polyhedra out;
    out.positions = cells.positions;
    std::map<std::set<Index>, std::vector<Index>> skin;
    for (Index c = 0; c < cells.types.size(); ++c) {
        std::vector<std::vector<Index>> faces;
        for (std::uint64_t f = cells.cell_offset[c]; f < cells.cell_offset[c + 1]; ++f)
            faces.emplace_back(cells.face_vertex.begin() + static_cast<std::ptrdiff_t>(cells.face_offset[f]),
                               cells.face_vertex.begin() + static_cast<std::ptrdiff_t>(cells.face_offset[f + 1]));
        if (!merged(c)) {
            out.polyhedron(faces);
            continue;
        }
        for (const auto& face : faces) {
            const std::set<Index> key(face.begin(), face.end());
            if (skin.erase(key) == 0) skin[key] = face;
        }
    }
    std::vector<std::vector<Index>> faces;
    for (const auto& [key, face] : skin) faces.push_back(face);
    out.polyhedron(faces);
    return out;
}

} // namespace

Polyhedra pinched_cell() {
    return merge(hexahedra(2, 2, 1), [](Index c) { return c == 0 || c == 3; });
}

Polyhedra cell_around_a_cell() {
    return merge(hexahedra(3, 3, 3), [](Index c) { return c != 13; });
}

std::vector<NamedMesh> all_meshes() {
    return {{"tetrahedron", one_tetrahedron().assembled().mesh},
            {"hexahedra", hexahedra(5, 4, 3).assembled().mesh},
            {"tetrahedra", tetrahedra(3, 3, 3).assembled().mesh},
            {"prisms", hexagonal_prisms(5, 4, 3).assembled().mesh},
            {"hanging", hanging_nodes().assembled().mesh},
            {"mixed", mixed_cells().assembled().mesh},
            {"collapsed", collapsed_hexahedra(7).assembled().mesh},
            {"shared edge", cubes_that_share_an_edge().assembled().mesh},
            {"hollow", hollow_box().assembled().mesh},
            {"pinched", pinched_cell().assembled().mesh},
            {"cell around a cell", cell_around_a_cell().assembled().mesh},
            {"nothing", FaceMesh{}}};
}

} // namespace ciel::test
