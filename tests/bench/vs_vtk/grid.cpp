#include "vs_vtk/duel.hpp"

#include "ciel/cell_geometry.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <vtkCellType.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

namespace ciel::vs_vtk {
using namespace server;

namespace {

struct Loops {
    std::vector<std::uint64_t> begin; // index of each cell's first entry in `face`, plus the end
    std::vector<Index> face;
};

Loops faces_of_cells(const FaceMeshView& mesh) {
    Loops loops{std::vector<std::uint64_t>(std::size_t{mesh.cell_count()} + 1, 0), {}};
    const auto for_each = [&](auto&& visit) {
        for (Index face = 0; face < mesh.face_count(); ++face) {
            visit(mesh.owner[face], face);
            if (mesh.neighbour[face] != none) visit(mesh.neighbour[face], face);
        }
    };
    for_each([&](Index cell, Index) { ++loops.begin[cell + 1]; });
    std::partial_sum(loops.begin.begin(), loops.begin.end(), loops.begin.begin());
    loops.face.resize(loops.begin.back());
    std::vector<std::uint64_t> next(loops.begin.begin(), loops.begin.end() - 1);
    for_each([&](Index cell, Index face) { loops.face[next[cell]++] = face; });
    return loops;
}

using Loop = std::vector<vtkIdType>;

// The cell's face loops, wound outwards, in the source's vertex ids.
std::vector<Loop> loops_of(const FaceMeshView& mesh, std::span<const Index> source, const Loops& loops, Index cell) {
    std::vector<Loop> found;
    for (std::uint64_t at = loops.begin[cell]; at < loops.begin[cell + 1]; ++at) {
        const Index face = loops.face[at];
        Loop& loop = found.emplace_back();
        for (const Index vertex : mesh.loop(face)) loop.push_back(source[vertex]);
        if (mesh.owner[face] != cell) std::reverse(loop.begin(), loop.end());
    }
    return found;
}

// The vertex at the other end of the edge that leaves `base` at `corner`.
vtkIdType above(vtkIdType corner, const Loop& base, const std::vector<Loop>& loops) {
    for (const Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const vtkIdType a = loop[i], b = loop[(i + 1) % loop.size()];
            if (a == corner && std::find(base.begin(), base.end(), b) == base.end()) return b;
            if (b == corner && std::find(base.begin(), base.end(), a) == base.end()) return a;
        }
    return corner; // the edge is collapsed
}

// VTK's vertex order: a base wound inwards, then the vertices above it.
Loop corners_of(CellType type, const std::vector<Loop>& loops) {
    const std::size_t base_size = type == CellType::tetrahedron || type == CellType::wedge ? 3 : 4;
    const auto base = std::find_if(loops.begin(), loops.end(), [&](const Loop& l) { return l.size() == base_size; });
    Loop corners(base->rbegin(), base->rend());
    const Loop bottom = corners;
    if (type == CellType::tetrahedron || type == CellType::pyramid)
        corners.push_back(above(bottom[0], bottom, loops));
    else
        for (const vtkIdType corner : bottom) corners.push_back(above(corner, bottom, loops));
    if (type == CellType::wedge) std::swap(corners[1], corners[2]), std::swap(corners[4], corners[5]);
    return corners;
}

void insert(vtkUnstructuredGrid* grid, CellType type, const std::vector<Loop>& loops) {
    if (type != CellType::polyhedron) {
        const Loop corners = corners_of(type, loops);
        grid->InsertNextCell(static_cast<int>(type), static_cast<vtkIdType>(corners.size()), corners.data());
        return;
    }
    std::set<vtkIdType> points;
    Loop stream;
    for (const Loop& loop : loops) {
        stream.push_back(static_cast<vtkIdType>(loop.size()));
        stream.insert(stream.end(), loop.begin(), loop.end());
        points.insert(loop.begin(), loop.end());
    }
    const Loop ids(points.begin(), points.end());
    grid->InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(ids.size()), ids.data(),
                         static_cast<vtkIdType>(loops.size()), stream.data());
}

} // namespace

bool is_linear(const bench::Case& data) {
    return std::ranges::none_of(data.mesh.cell_types,
                                [](std::uint8_t type) { return static_cast<CellType>(type) == CellType::polyhedron; });
}

vtkSmartPointer<vtkUnstructuredGrid> as_grid(const bench::Case& data) {
    const std::span<const Index> source = data.dataset->original_vertex(0), cells = data.dataset->original_cell(0);
    vtkNew<vtkPoints> points;
    points->SetDataType(data.mesh.positions.has_doubles() ? VTK_DOUBLE : VTK_FLOAT);
    points->SetNumberOfPoints(static_cast<vtkIdType>(*std::ranges::max_element(source)) + 1);
    for (Index v = 0; v < source.size(); ++v) points->SetPoint(source[v], position(data.mesh, v).data());
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(points);
    const Loops loops = faces_of_cells(data.mesh);
    std::vector<Index> order(cells.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, [&](Index a, Index b) { return cells[a] < cells[b]; });
    for (const Index cell : order)
        insert(grid, static_cast<CellType>(data.mesh.cell_types[cell]), loops_of(data.mesh, source, loops, cell));
    set_values(grid, data, data.values);
    return grid;
}

void set_values(vtkUnstructuredGrid* grid, const bench::Case& data, const store::Values& values) {
    const std::span<const Index> source = data.dataset->original_vertex(0);
    vtkNew<vtkFloatArray> scalars;
    scalars->SetName("values");
    scalars->SetNumberOfValues(grid->GetNumberOfPoints());
    for (Index v = 0; v < source.size(); ++v) scalars->SetValue(source[v], static_cast<float>(values[v]));
    grid->GetPointData()->SetScalars(scalars);
}

} // namespace ciel::vs_vtk
