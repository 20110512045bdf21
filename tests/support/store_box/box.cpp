#include "support/store_box/box.hpp"

#include <array>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>

namespace ciel::test {
using namespace server;
namespace {

struct Grid {
    Index nx, ny, nz;
    [[nodiscard]] Index vertex(Index i, Index j, Index k) const { return i + (nx + 1) * (j + (ny + 1) * k); }
    [[nodiscard]] Index cell(Index i, Index j, Index k) const { return i + nx * (j + ny * k); }
};

// The face perpendicular to `axis` at lattice position `at`, counter-clockwise around +axis.
std::array<Index, 4> loop_across(const Grid& grid, int axis, std::array<Index, 3> at) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<Index, 4> loop{};
    constexpr int steps[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int corner = 0; corner < 4; ++corner) {
        auto p = at;
        p[u] += steps[corner][0];
        p[v] += steps[corner][1];
        loop[corner] = grid.vertex(p[0], p[1], p[2]);
    }
    return loop;
}

void add_face(FaceMesh& mesh, std::array<Index, 4> loop, bool reversed, Index owner, Index neighbour) {
    if (reversed) loop = {loop[3], loop[2], loop[1], loop[0]};
    mesh.face_vertex.insert(mesh.face_vertex.end(), loop.begin(), loop.end());
    mesh.face_offset.push_back(mesh.face_vertex.size());
    mesh.owner.push_back(owner);
    mesh.neighbour.push_back(neighbour);
}

void add_faces(FaceMesh& mesh, const Grid& grid, std::array<Index, 3> at) {
    const std::array<Index, 3> extent{grid.nx, grid.ny, grid.nz};
    const Index cell = grid.cell(at[0], at[1], at[2]);
    for (int axis = 0; axis < 3; ++axis) {
        if (at[axis] == 0) add_face(mesh, loop_across(grid, axis, at), true, cell, none);
        auto next = at;
        ++next[axis];
        const bool last = next[axis] == extent[axis];
        add_face(mesh, loop_across(grid, axis, next), false, cell, last ? none : grid.cell(next[0], next[1], next[2]));
    }
}

} // namespace

FaceMesh box(Index nx, Index ny, Index nz) {
    const Grid grid{nx, ny, nz};
    FaceMesh mesh;
    for (Index k = 0; k <= nz; ++k)
        for (Index j = 0; j <= ny; ++j)
            for (Index i = 0; i <= nx; ++i)
                for (const Index x : {i, j, k}) mesh.positions.push_back(static_cast<float>(x));
    mesh.cell_types.assign(std::size_t{nx} * ny * nz, static_cast<std::uint8_t>(CellType::hexahedron));
    for (Index k = 0; k < nz; ++k)
        for (Index j = 0; j < ny; ++j)
            for (Index i = 0; i < nx; ++i) add_faces(mesh, grid, {i, j, k});
    return mesh;
}

std::vector<Index> identity(std::size_t count) {
    std::vector<Index> ids(count);
    std::iota(ids.begin(), ids.end(), 0U);
    return ids;
}

std::vector<float> values_of(std::size_t count, std::size_t step) {
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(i + 1000 * step);
    return values;
}

void write_box(const std::filesystem::path& directory, const FaceMesh& mesh) {
    using store::Association;
    const std::size_t vertices = mesh.positions.size() / 3, cells = mesh.cell_types.size();
    store::Writer writer(directory, {"box.vtu", "m", vertices, 12, cells, {"a note"}});
    const std::vector<store::NamedGroup> groups{{store::Group::Of::faces, "wall", {2, 0, 1}},
                                                {store::Group::Of::cells, "inner/zone \xC3\xA9", {0}}};
    writer.add_mesh(mesh, identity(vertices), identity(cells), groups);
    for (std::size_t step = 0; step < 3; ++step) {
        const auto p = values_of(vertices, step), u = values_of(3 * vertices, step), c = values_of(cells, step);
        std::vector<store::ArrayValues> arrays{{{"U", Association::point, 3, "m/s", "velocity"}, u},
                                               {{"cell:p", Association::cell, 1, "Pa", ""}, c}};
        if (step != 1) arrays.push_back({{"p", Association::point, 1, "Pa", "pressure"}, p});
        writer.add_step(0.5 * static_cast<double>(step), 0, 0, arrays);
    }
    writer.finish();
}

std::string read_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void overwrite_file(const std::filesystem::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
}

std::string hex_dump(const std::string& bytes) {
    std::ostringstream text;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        if (at % 16 == 0) text << std::hex << std::setw(4) << std::setfill('0') << at << ' ';
        if (at % 8 == 0) text << ' ';
        text << std::setw(2) << static_cast<unsigned>(static_cast<unsigned char>(bytes[at]))
             << (at % 16 == 15 || at + 1 == bytes.size() ? '\n' : ' ');
    }
    return text.str();
}

} // namespace ciel::test
