#include "import/mesh/joined_mesh.hpp"

#include "ciel/face_lists.hpp"
#include "ciel/vtk_shapes.hpp"
#include "import/mesh/cell_dimension.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

namespace server::importer {

namespace {

constexpr std::uint64_t max_count = ciel::none - 1ULL;

// Checks all point ids from the file, because later code does not check them.
class MemberJoiner {
public:
    MemberJoiner(JoinedMesh& mesh, std::size_t member)
        : mesh_(mesh), member_(member), data_(mesh.members[member].data), point_count_(data_->GetNumberOfPoints()) {}

    void add_cells() {
        mesh_.members[member_].mesh_cell_begin = static_cast<ciel::Index>(mesh_.cell_types.size());
        if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data_))
            add_unstructured(grid);
        else
            add_structured();
        mesh_.members[member_].mesh_cell_end = static_cast<ciel::Index>(mesh_.cell_types.size());
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        const std::string& name = mesh_.members[member_].name;
        throw ciel::Error(name.empty() ? what : "block \"" + name + "\": " + what);
    }

    ciel::Index vertex(vtkIdType id, vtkIdType cell) const {
        if (id < 0 || id >= point_count_)
            fail("cell " + std::to_string(cell) + " uses point " + std::to_string(id) + ", but there are only " +
                 std::to_string(point_count_) + " points");
        return mesh_.members[member_].first_point + static_cast<ciel::Index>(id);
    }

    // `end`: number of faces (or corners) of all cells so far. `offset` stays empty as long as `end` is 0.
    void end_cell(std::size_t end, store::DiskVector<std::uint64_t>& offset) const {
        if (end == 0) return;
        if (offset.empty()) offset.reserve(mesh_.cell_types.capacity() + 1);
        offset.resize(mesh_.cell_types.size(), 0);
        offset.push_back(end);
    }
    void close_cell(ciel::CellType type, vtkIdType cell) {
        mesh_.cell_types.push_back(static_cast<std::uint8_t>(type));
        end_cell(mesh_.face_offset.size() - 1, mesh_.cell_offset);
        end_cell(mesh_.corner.size(), mesh_.corner_offset);
        mesh_.source_cell.push_back(mesh_.members[member_].first_cell + static_cast<ciel::Index>(cell));
    }

    void add_shape(const ciel::VtkShape& shape, std::span<const vtkIdType> nodes, vtkIdType cell) {
        if (nodes.size() < shape.least_points)
            fail("cell " + std::to_string(cell) + " has " + std::to_string(nodes.size()) +
                 " nodes; the smallest number of nodes for its cell type is " + std::to_string(shape.least_points));
        ciel::VtkCorners corners{};
        for (std::size_t i = 0; i < shape.corners; ++i) corners[i] = vertex(nodes[i], cell);
        if (shape.reduced_from != nullptr) ++mesh_.reduced_cells[shape.reduced_from];
        if (shape.type == ciel::CellType::polyhedron) {
            append_faces(shape, corners);
        } else {
            const ciel::VtkCorners ordered = ciel::standard_corners(shape, corners);
            mesh_.corner.insert(mesh_.corner.end(), ordered.begin(), ordered.begin() + shape.corners);
        }
        close_cell(shape.type, cell);
    }

    void append_faces(const ciel::VtkShape& shape, const ciel::VtkCorners& corners) {
        auto& [offset, vertices] = ciel::of_this_thread<JoinedMesh::FacesOfCell>();
        offset.assign(1, 0);
        vertices.clear();
        ciel::append_vtk_faces(shape, corners, offset, vertices);
        const std::size_t before = mesh_.face_vertex.size();
        for (const std::uint64_t end : std::span(offset).subspan(1)) mesh_.face_offset.push_back(before + end);
        mesh_.face_vertex.insert(mesh_.face_vertex.end(), vertices.begin(), vertices.end());
    }

    // VTK's face stream: the number of faces, then for each face the number of points and the point ids.
    void add_polyhedron(std::span<const vtkIdType> stream, vtkIdType cell) {
        const auto damaged = [&] { fail("the face list of polyhedron " + std::to_string(cell) + " is damaged"); };
        if (stream.empty() || stream[0] < 0) damaged();
        std::size_t at = 1;
        for (vtkIdType face = 0; face < stream[0]; ++face) {
            if (at >= stream.size() || stream[at] < 0 || static_cast<std::size_t>(stream[at]) > stream.size() - at - 1)
                damaged();
            const auto corners = stream.subspan(at + 1, static_cast<std::size_t>(stream[at]));
            for (const vtkIdType corner : corners) mesh_.face_vertex.push_back(vertex(corner, cell));
            mesh_.face_offset.push_back(mesh_.face_vertex.size());
            at += 1 + corners.size();
        }
        close_cell(type_of_last_faces(static_cast<std::size_t>(stream[0])), cell);
    }

    // Six quadrilaterals with eight corners are a hexahedron, even if the file calls the cell a polyhedron.
    [[nodiscard]] ciel::CellType type_of_last_faces(std::size_t faces) const {
        return ciel::type_of_cell(std::span(mesh_.face_offset).last(faces + 1), mesh_.face_vertex);
    }

    [[nodiscard]] bool is_ghost(vtkIdType cell) const {
        const vtkUnsignedCharArray* ghosts = data_->GetCellGhostArray();
        constexpr int left_out =
            vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
        return ghosts != nullptr && cell < ghosts->GetNumberOfValues() && (ghosts->GetValue(cell) & left_out) != 0;
    }

    void check_tables(vtkUnstructuredGrid* grid) const {
        vtkCellArray* cells = grid->GetCells();
        const vtkIdType count = grid->GetNumberOfCells();
        if (grid->GetCellTypesArray() == nullptr || grid->GetCellTypesArray()->GetNumberOfValues() != count)
            fail("has " + std::to_string(count) + " cells but a different number of cell types; the file is damaged");
        vtkIdType previous = 0;
        for (vtkIdType i = 0; i <= count; ++i) {
            const auto offset = static_cast<vtkIdType>(cells->GetOffsetsArray()->GetComponent(i, 0));
            if (offset < previous || offset > cells->GetNumberOfConnectivityIds() || (i == 0 && offset != 0))
                fail("the file is damaged: the cell offsets are wrong at cell " + std::to_string(i));
            previous = offset;
        }
    }

    void add_unstructured(vtkUnstructuredGrid* grid) {
        check_tables(grid);
        JoinedMesh::FlatCells flat{member_, {}};
        for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell) {
            const int type = grid->GetCellType(cell);
            const Dimension dimension = cell_dimension(type);
            if (type == VTK_CONVEX_POINT_SET) {
                ++mesh_.convex_point_sets;
            } else if (dimension == Dimension::none) {
                ++mesh_.ignored_cells;
            } else if (dimension == Dimension::surface) {
                flat.cells.push_back(cell);
            } else if (is_ghost(cell)) {
                ++mesh_.blanked_cells;
            } else if (type == VTK_POLYHEDRON) {
                add_polyhedron(face_stream(grid, cell), cell);
            } else {
                vtkIdType size = 0;
                const vtkIdType* nodes = nullptr;
                grid->GetCells()->GetCellAtId(cell, size, nodes);
                add_shape(*ciel::find_vtk_shape(type), {nodes, static_cast<std::size_t>(size)}, cell);
            }
        }
        if (!flat.cells.empty()) mesh_.flat_cells.push_back(std::move(flat));
    }

    std::span<const vtkIdType> face_stream(vtkUnstructuredGrid* grid, vtkIdType cell) const {
        vtkIdTypeArray* faces = grid->GetFaces();
        vtkIdTypeArray* locations = grid->GetFaceLocations();
        if (faces == nullptr || locations == nullptr || cell >= locations->GetNumberOfValues())
            fail("polyhedron " + std::to_string(cell) + " has no faces");
        const vtkIdType begin = locations->GetValue(cell);
        const vtkIdType size = faces->GetNumberOfValues();
        if (begin < 0 || begin >= size) fail("polyhedron " + std::to_string(cell) + " has no faces");
        return {faces->GetPointer(begin), static_cast<std::size_t>(size - begin)};
    }

    [[nodiscard]] std::array<int, 3> dimensions() const {
        std::array<int, 3> dims{};
        if (auto* structured = vtkStructuredGrid::SafeDownCast(data_)) structured->GetDimensions(dims.data());
        if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data_)) rectilinear->GetDimensions(dims.data());
        if (auto* image = vtkImageData::SafeDownCast(data_)) image->GetDimensions(dims.data());
        return dims;
    }

    void add_structured() {
        const auto [ni, nj, nk] = dimensions();
        if (vtkIdType{ni} * nj * nk != point_count_)
            fail("the dimensions " + std::to_string(ni) + " x " + std::to_string(nj) + " x " + std::to_string(nk) +
                 " do not match the number of points: the file has " + std::to_string(point_count_) + " points");
        const std::vector<bool> holes = hole_points();
        const vtkIdType row = ni;
        const vtkIdType slab = row * nj;
        vtkIdType cell = 0;
        for (vtkIdType k = 0; k + 1 < nk; ++k)
            for (vtkIdType j = 0; j + 1 < nj; ++j)
                for (vtkIdType i = 0; i + 1 < ni; ++i, ++cell) {
                    const vtkIdType p = i + j * row + k * slab;
                    const std::array<vtkIdType, 8> nodes{p,        p + 1,        p + 1 + row,        p + row,
                                                         p + slab, p + 1 + slab, p + 1 + row + slab, p + row + slab};
                    const bool hole = !holes.empty() &&
                                      std::any_of(nodes.begin(), nodes.end(), [&](vtkIdType n) { return holes[n]; });
                    if (hole || (!blank_points_known_ && is_ghost(cell)))
                        ++mesh_.blanked_cells;
                    else
                        add_shape(*ciel::find_vtk_shape(VTK_HEXAHEDRON), nodes, cell);
                }
    }

    // In PLOT3D, iblank 0 marks a hole. Other values, such as 2 (wall) and negative values (interpolated), do not.
    std::vector<bool> hole_points() {
        vtkDataArray* iblank = data_->GetPointData()->GetArray("IBlank");
        blank_points_known_ = iblank != nullptr;
        std::vector<bool> holes;
        if (iblank == nullptr || iblank->GetNumberOfTuples() != point_count_) return holes;
        holes.resize(static_cast<std::size_t>(point_count_));
        for (vtkIdType i = 0; i < point_count_; ++i) holes[i] = iblank->GetComponent(i, 0) == 0;
        return holes;
    }

    JoinedMesh& mesh_;
    std::size_t member_;
    vtkDataSet* data_;
    vtkIdType point_count_;
    bool blank_points_known_ = false;
};

} // namespace

JoinedMesh number_members(const std::vector<InputGrid>& volumes, const std::filesystem::path& folder) {
    JoinedMesh mesh(folder);
    std::map<vtkPoints*, ciel::Index> shared;
    std::uint64_t points = 0;
    std::uint64_t cells = 0;
    for (const InputGrid& input_grid : volumes) {
        JoinedMesh::Member member{
            input_grid.name, input_grid.data, static_cast<ciel::Index>(points), static_cast<ciel::Index>(cells), 0, 0,
            input_grid.whole};
        auto* set = vtkPointSet::SafeDownCast(input_grid.data);
        vtkPoints* own = set != nullptr ? set->GetPoints() : nullptr;
        const auto known = own != nullptr ? shared.find(own) : shared.end();
        if (known != shared.end()) {
            member.first_point = known->second;
        } else {
            if (own != nullptr) shared[own] = member.first_point;
            points += static_cast<std::uint64_t>(input_grid.data->GetNumberOfPoints());
        }
        cells += static_cast<std::uint64_t>(input_grid.data->GetNumberOfCells());
        if (points > max_count || cells > max_count)
            throw ciel::Error("the mesh has more than 4,294,967,294 points or cells, the most that a dataset can hold");
        mesh.members.push_back(std::move(member));
    }
    mesh.point_count = static_cast<ciel::Index>(points);
    return mesh;
}

namespace {

struct ListedFaces {
    std::size_t count = 0, corners = 0;
};

// Adds to `faces` the faces and corners in VTK's face streams of polyhedra. A damaged stream ends the count.
void count_faces(vtkUnstructuredGrid* grid, ListedFaces& faces) {
    vtkIdTypeArray* streams = grid->GetFaces();
    const vtkIdType size = streams == nullptr ? 0 : streams->GetNumberOfValues();
    for (vtkIdType at = 0; at < size;) {
        vtkIdType left = streams->GetValue(at++);
        for (; left > 0 && at < size; --left) {
            const vtkIdType corners = streams->GetValue(at++);
            if (corners < 0 || corners > size - at) return;
            ++faces.count;
            faces.corners += static_cast<std::size_t>(corners);
            at += corners;
        }
    }
}

// Reserves memory in advance, because vectors that grow take up to three times their size.
void reserve_cells(JoinedMesh& mesh) {
    std::size_t cells = 0, corners = 0;
    ListedFaces faces;
    for (const JoinedMesh::Member& member : mesh.members) {
        const auto of_member = static_cast<std::size_t>(member.data->GetNumberOfCells());
        cells += of_member;
        auto* grid = vtkUnstructuredGrid::SafeDownCast(member.data);
        const bool is_listed = grid != nullptr && grid->GetCells() != nullptr;
        corners += is_listed ? static_cast<std::size_t>(grid->GetCells()->GetNumberOfConnectivityIds()) : 8 * of_member;
        if (grid != nullptr) count_faces(grid, faces);
    }
    mesh.cell_types.reserve(cells);
    mesh.source_cell.reserve(cells);
    mesh.corner.reserve(corners);
    mesh.face_offset.reserve(faces.count + 1);
    mesh.face_vertex.reserve(faces.corners);
}

void check_finite(const JoinedMesh& mesh) {
    JoinedMesh::for_vertices(mesh, [&](ciel::Index vertex) {
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(mesh.positions[3 * std::size_t{vertex} + axis]))
                throw ciel::Error("point " + std::to_string(vertex) + " has a coordinate that is not a finite number");
    });
}

} // namespace

RunningCounts count_running(const std::vector<InputGrid>& volumes) {
    if (volumes.empty()) return {};
    const JoinedMesh mesh = number_members(volumes);
    const auto last = static_cast<ciel::Index>(volumes.back().data->GetNumberOfCells());
    return {mesh.point_count, mesh.members.back().first_cell + last};
}

namespace {

// Returns the numbers of VTK's array without a copy, or nothing if the array has another type.
store::Values numbers_of(vtkDataArray* points) {
    const auto view = [points]<class Number>(vtkAOSDataArrayTemplate<Number>* array) {
        const std::span<const Number> numbers(array->GetPointer(0),
                                              static_cast<std::size_t>(array->GetNumberOfValues()));
        return store::Values(numbers, std::make_shared<const vtkSmartPointer<vtkDataArray>>(points));
    };
    if (auto* floats = vtkFloatArray::SafeDownCast(points)) return view(floats);
    if (auto* doubles = vtkDoubleArray::SafeDownCast(points)) return view(doubles);
    return {};
}

} // namespace

store::Values point_positions(const std::vector<JoinedMesh::Member>& members, ciel::Index point_count) {
    auto* only = members.size() == 1 ? vtkPointSet::SafeDownCast(members[0].data) : nullptr;
    if (only != nullptr && only->GetPoints() != nullptr) {
        store::Values numbers = numbers_of(only->GetPoints()->GetData());
        if (numbers.size() == 3 * std::size_t{point_count})
            return numbers.has_doubles() && ciel::are_floats(numbers) ? store::converted(numbers, false) : numbers;
    }
    std::vector<double> positions(3 * std::size_t{point_count});
    for (const JoinedMesh::Member& member : members)
        for (vtkIdType i = 0; i < member.data->GetNumberOfPoints(); ++i) {
            const std::size_t at = std::size_t{member.first_point} + static_cast<std::size_t>(i);
            member.data->GetPoint(i, &positions[3 * at]);
        }
    return ciel::are_floats(positions) ? store::converted(positions, false) : store::Values(std::move(positions));
}

JoinedMesh join_input_grids(const std::vector<InputGrid>& volumes, const std::filesystem::path& folder) {
    JoinedMesh mesh = number_members(volumes, folder);
    reserve_cells(mesh);
    for (std::size_t member = 0; member < mesh.members.size(); ++member) MemberJoiner(mesh, member).add_cells();
    mesh.positions = point_positions(mesh.members, mesh.point_count);
    check_finite(mesh);
    return mesh;
}

std::uint64_t count_edges(const JoinedMesh& mesh) {
    const auto for_each_edge = [&mesh](auto&& visit) {
        for (std::size_t cell = 0; cell < mesh.cell_types.size(); ++cell)
            mesh.for_loops(cell, [&](std::span<const ciel::Index> loop) {
                for (std::size_t i = 0; i < loop.size(); ++i) {
                    const ciel::Index a = loop[i], b = loop[(i + 1) % loop.size()];
                    if (a != b) visit(std::min(a, b), std::max(a, b));
                }
            });
    };
    // A bucket has the edges with the same lower vertex id. Buckets are short, so sorting them takes linear time.
    std::vector<std::uint64_t> bucket(std::size_t{mesh.point_count} + 1, 0); // by vertex: its first edge
    for_each_edge([&](ciel::Index low, ciel::Index) { ++bucket[low + 1]; });
    for (std::size_t i = 1; i < bucket.size(); ++i) bucket[i] += bucket[i - 1];
    // Lists the edges of some vertices at a time, because all edges of polyhedra would take more memory than the cells.
    const std::uint64_t most_at_once = std::max<std::uint64_t>(std::uint64_t{1} << 24, bucket.back() / 8);
    std::vector<ciel::Index> upper;
    std::vector<std::uint64_t> next;
    std::uint64_t count = 0;
    for (std::size_t first = 0, last; first < mesh.point_count; first = last) {
        const auto limit = std::ranges::upper_bound(bucket, bucket[first] + most_at_once);
        last = std::max(first + 1, static_cast<std::size_t>(limit - bucket.begin()) - 1);
        upper.resize(bucket[last] - bucket[first]);
        next.assign(bucket.begin() + static_cast<std::ptrdiff_t>(first),
                    bucket.begin() + static_cast<std::ptrdiff_t>(last));
        for_each_edge([&](ciel::Index low, ciel::Index high) {
            if (low >= first && low < last) upper[next[low - first]++ - bucket[first]] = high;
        });
        for (std::size_t i = first; i < last; ++i) {
            const auto begin = upper.begin() + static_cast<std::ptrdiff_t>(bucket[i] - bucket[first]);
            const auto end = upper.begin() + static_cast<std::ptrdiff_t>(bucket[i + 1] - bucket[first]);
            std::sort(begin, end);
            count += static_cast<std::uint64_t>(std::unique(begin, end) - begin);
        }
    }
    return count;
}

} // namespace server::importer
