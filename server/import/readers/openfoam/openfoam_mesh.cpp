#include "import/readers/openfoam/openfoam_mesh.hpp"

#include "ciel/types.hpp"
#include "import/readers/openfoam/openfoam_piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

namespace server::importer {

namespace {

namespace fs = std::filesystem;

// Excludes "processorCyclic" patches, because the two sides of a cyclic patch do not coincide.
bool joins_processors(const FoamPatch& patch) { return patch.type == "processor"; }
bool is_between_processors(const FoamPatch& patch) { return patch.type.starts_with("processor"); }

class MeshBuilder {
public:
    MeshBuilder(const FoamCase& foam, const std::string& region, double time)
        : foam_(foam), region_(region), time_(time) {}

    FoamMesh run() {
        for (std::size_t root = 0; root < foam_.roots.size(); ++root) read(root);
        if (files_.empty())
            throw ciel::Error(first_reason_.empty()
                                  ? "region " + region_ +
                                        " has no file polyMesh/points in constant or in a time directory"
                                  : first_reason_);
        number_through();
        join_processors();
        make_points();
        make_cells();
        for (std::size_t piece = 0; piece < files_.size(); ++piece) {
            add_patches(piece);
            add_zones(piece);
            keep_piece(piece);
        }
        return std::move(mesh_);
    }

private:
    void read(std::size_t root) {
        const FoamRoot& from = foam_.roots[root];
        // In a case with several regions, a processor need not have cells of each region.
        if (foam_.regions.size() > 1 && from.mesh_file(region_, "points", time_).empty()) return;
        try {
            files_.push_back(read_foam_piece(from, region_, time_));
            root_.push_back(root);
            const std::vector<std::string>& lost = files_.back().lost;
            mesh_.lost.insert(mesh_.lost.end(), lost.begin(), lost.end());
        } catch (const ciel::Error& error) {
            if (first_reason_.empty()) first_reason_ = error.what();
            mesh_.lost.push_back("The part of " + (from.name.empty() ? "the case" : from.name) +
                                 " could not be read and was left out: " + error.what());
        }
    }

    void number_through() {
        std::size_t points = 0, cells = 0;
        for (const FoamPieceFiles& piece : files_) {
            first_point_.push_back(points);
            first_cell_.push_back(cells);
            points += piece.points.size() / 3;
            cells += piece.cell_count;
        }
        constexpr std::size_t most = ciel::none - std::size_t{1};
        if (points > most || cells > most)
            throw ciel::Error("the mesh has more than 4,294,967,294 points or cells, the most that a dataset can hold");
        point_count_ = points;
        cell_count_ = cells;
    }

    // Both sides of a processor patch list the faces of the patch in the same order. A face has the same first point on
    // both sides. The other points have opposite orders on the two sides (processorPolyPatch).
    void join_processors() {
        for (std::size_t a = 0; a < files_.size(); ++a)
            for (const FoamPatch& patch : files_[a].patches) {
                if (!joins_processors(patch) || patch.face_count == 0) continue;
                const auto b = std::find_if(root_.begin(), root_.end(), [&](std::size_t root) {
                    return foam_.roots[root].processor == patch.neighbour;
                });
                if (b == root_.end()) {
                    mesh_.single_faces += static_cast<std::uint64_t>(patch.face_count);
                    if (!is_there(patch.neighbour)) mesh_.lost.push_back(missing_processor(patch.neighbour));
                } else if (const auto other = static_cast<std::size_t>(b - root_.begin()); other > a) {
                    join_sides(a, patch, other);
                }
            }
    }

    [[nodiscard]] bool is_there(std::int64_t processor) const {
        return std::any_of(foam_.roots.begin(), foam_.roots.end(),
                           [&](const FoamRoot& root) { return root.processor == processor; });
    }

    void join_sides(std::size_t a, const FoamPatch& of_a, std::size_t b) {
        const auto& patches = files_[b].patches;
        const auto of_b = std::find_if(patches.begin(), patches.end(), [&](const FoamPatch& patch) {
            return joins_processors(patch) && patch.neighbour == foam_.roots[root_[a]].processor &&
                   patch.face_count == of_a.face_count;
        });
        if (of_b == patches.end()) {
            mesh_.single_faces += static_cast<std::uint64_t>(of_a.face_count);
            return;
        }
        for (std::int64_t i = 0; i < of_a.face_count; ++i)
            if (join_faces(a, static_cast<std::size_t>(of_a.first_face + i), b,
                           static_cast<std::size_t>(of_b->first_face + i)))
                ++mesh_.joined_faces;
            else
                ++mesh_.single_faces;
    }

    [[nodiscard]] std::span<const std::int64_t> corners(std::size_t piece, std::size_t face) const {
        const FoamFaces& faces = files_[piece].faces;
        return std::span(faces.points).subspan(faces.offset[face], faces.offset[face + 1] - faces.offset[face]);
    }

    [[nodiscard]] ciel::Vec3d position(std::size_t piece, std::int64_t point) const {
        const double* at = &files_[piece].points[3 * static_cast<std::size_t>(point)];
        return {at[0], at[1], at[2]};
    }

    bool join_faces(std::size_t a, std::size_t face_a, std::size_t b, std::size_t face_b) {
        const auto points_a = corners(a, face_a), points_b = corners(b, face_b);
        const std::size_t n = points_a.size();
        if (n != points_b.size() || n == 0) return false;
        const double tolerance = 1e-3 * diameter(a, points_a);
        for (std::size_t i = 0; i < n; ++i)
            if (!(distance(position(a, points_a[i]), position(b, points_b[(n - i) % n])) <= tolerance)) return false;
        for (std::size_t i = 0; i < n; ++i)
            mesh_.same_points.emplace_back(static_cast<ciel::Index>(first_point_[a] + points_a[i]),
                                           static_cast<ciel::Index>(first_point_[b] + points_b[(n - i) % n]));
        return true;
    }

    static double distance(const ciel::Vec3d& p, const ciel::Vec3d& q) {
        return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }

    [[nodiscard]] double diameter(std::size_t piece, std::span<const std::int64_t> points) const {
        double largest = 0;
        for (const std::int64_t point : points)
            largest = std::max(largest, distance(position(piece, points[0]), position(piece, point)));
        return largest;
    }

    void make_points() {
        vtkNew<vtkDoubleArray> coordinates;
        coordinates->SetNumberOfComponents(3);
        coordinates->SetNumberOfTuples(static_cast<vtkIdType>(point_count_));
        for (std::size_t piece = 0; piece < files_.size(); ++piece)
            std::copy(files_[piece].points.begin(), files_[piece].points.end(),
                      coordinates->GetPointer(3 * static_cast<vtkIdType>(first_point_[piece])));
        mesh_.points = vtkSmartPointer<vtkPoints>::New();
        mesh_.points->SetData(coordinates);
    }

    // VTK's face stream: the number of faces, then for each face the number of points and the points, wound outwards.
    void make_cells() {
        vtkNew<vtkIdTypeArray> streams, locations, offsets, corner_ids;
        vtkNew<vtkUnsignedCharArray> types;
        locations->SetNumberOfValues(static_cast<vtkIdType>(cell_count_));
        types->SetNumberOfValues(static_cast<vtkIdType>(cell_count_));
        types->FillValue(VTK_POLYHEDRON);
        offsets->SetNumberOfValues(static_cast<vtkIdType>(cell_count_) + 1);
        offsets->SetValue(0, 0);
        for (std::size_t piece = 0; piece < files_.size(); ++piece)
            add_cells(piece, streams, locations, offsets, corner_ids);
        vtkNew<vtkCellArray> cells;
        cells->SetData(offsets, corner_ids);
        mesh_.grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
        mesh_.grid->SetPoints(mesh_.points);
        mesh_.grid->SetCells(types, cells, locations, streams);
        name_cells();
    }

    // Global ids are the ids before decomposition (cellProcAddressing), or -1 if the processor has no such file.
    void name_cells() {
        const auto says = [](const FoamPieceFiles& files) { return !files.cell_addressing.empty(); };
        if (std::none_of(files_.begin(), files_.end(), says)) return;
        vtkNew<vtkIdTypeArray> ids;
        ids->SetName("cellProcAddressing");
        ids->SetNumberOfValues(static_cast<vtkIdType>(cell_count_));
        ids->FillValue(-1);
        for (std::size_t piece = 0; piece < files_.size(); ++piece)
            std::copy(files_[piece].cell_addressing.begin(), files_[piece].cell_addressing.end(),
                      ids->GetPointer(static_cast<vtkIdType>(first_cell_[piece])));
        mesh_.grid->GetCellData()->SetGlobalIds(ids);
    }

    void add_cells(std::size_t piece, vtkIdTypeArray* streams, vtkIdTypeArray* locations, vtkIdTypeArray* offsets,
                   vtkIdTypeArray* corner_ids) const {
        const FoamPieceFiles& files = files_[piece];
        std::vector<std::size_t> begin(files.cell_count + 1, 0);
        const auto for_each_side = [&files](auto&& visit) {
            for (std::size_t face = 0; face < files.face_count(); ++face) {
                visit(static_cast<std::size_t>(files.owner[face]), face, false);
                if (face < files.neighbour.size()) visit(static_cast<std::size_t>(files.neighbour[face]), face, true);
            }
        };
        for_each_side([&](std::size_t cell, std::size_t, bool) { ++begin[cell + 1]; });
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        std::vector<std::size_t> side(begin.back()); // 2 * face, plus 1 if the winding of the face is reversed
        std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
        for_each_side([&](std::size_t cell, std::size_t face, bool is_turned) {
            side[next[cell]++] = 2 * face + (is_turned ? 1 : 0);
        });
        std::vector<vtkIdType> stream, ids;
        for (std::size_t cell = 0; cell < files.cell_count; ++cell) {
            stream.assign(1, static_cast<vtkIdType>(begin[cell + 1] - begin[cell]));
            ids.clear();
            for (std::size_t i = begin[cell]; i < begin[cell + 1]; ++i)
                add_face(piece, side[i] / 2, side[i] % 2 == 1, stream, ids);
            std::sort(ids.begin(), ids.end());
            ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
            const auto running = static_cast<vtkIdType>(first_cell_[piece]) + static_cast<vtkIdType>(cell);
            locations->SetValue(running, streams->GetNumberOfValues());
            for (const vtkIdType value : stream) streams->InsertNextValue(value);
            for (const vtkIdType value : ids) corner_ids->InsertNextValue(value);
            offsets->SetValue(running + 1, corner_ids->GetNumberOfValues());
        }
    }

    void add_face(std::size_t piece, std::size_t face, bool is_turned, std::vector<vtkIdType>& stream,
                  std::vector<vtkIdType>& ids) const {
        const auto points = corners(piece, face);
        const auto base = static_cast<vtkIdType>(first_point_[piece]);
        stream.push_back(static_cast<vtkIdType>(points.size()));
        for (std::size_t i = 0; i < points.size(); ++i) {
            stream.push_back(base + points[is_turned ? points.size() - 1 - i : i]);
            ids.push_back(stream.back());
        }
    }

    FoamSurface& surface(std::vector<FoamSurface>& surfaces, const std::string& name) {
        const auto known = std::find_if(surfaces.begin(), surfaces.end(),
                                        [&](const FoamSurface& surface) { return surface.name == name; });
        if (known != surfaces.end()) return *known;
        surfaces.push_back({name, "", {}, vtkSmartPointer<vtkCellArray>::New()});
        return surfaces.back();
    }

    void add_polygon(std::size_t piece, std::size_t face, vtkCellArray* polygons) const {
        const auto points = corners(piece, face);
        polygons->InsertNextCell(static_cast<int>(points.size()));
        for (const std::int64_t point : points)
            polygons->InsertCellPoint(static_cast<vtkIdType>(first_point_[piece]) + point);
    }

    void add_patches(std::size_t piece) {
        for (const FoamPatch& patch : files_[piece].patches) {
            if (is_between_processors(patch)) continue;
            FoamSurface& whole = surface(mesh_.patches, patch.name);
            whole.type = patch.type;
            whole.groups = patch.groups;
            for (std::int64_t i = 0; i < patch.face_count; ++i)
                add_polygon(piece, static_cast<std::size_t>(patch.first_face + i), whole.faces);
        }
    }

    void add_zones(std::size_t piece) {
        for (const FoamZone& zone : files_[piece].cell_zones)
            for (const std::int64_t cell : zone.labels)
                mesh_.cell_zones[zone.name].push_back(static_cast<ciel::Index>(first_cell_[piece] + cell));
        for (const FoamZone& zone : files_[piece].face_zones) {
            FoamSurface& whole = surface(mesh_.face_zones, zone.name);
            for (const std::int64_t face : zone.labels) add_polygon(piece, static_cast<std::size_t>(face), whole.faces);
        }
    }

    void keep_piece(std::size_t piece) {
        FoamPieceFiles& files = files_[piece];
        FoamPiece kept;
        kept.root = root_[piece];
        kept.first_cell = first_cell_[piece];
        kept.cell_count = files.cell_count;
        kept.first_boundary_face = files.neighbour.size();
        kept.boundary_owner.assign(files.owner.begin() + static_cast<std::ptrdiff_t>(files.neighbour.size()),
                                   files.owner.end());
        kept.patches = std::move(files.patches);
        mesh_.pieces.push_back(std::move(kept));
    }

    const FoamCase& foam_;
    const std::string& region_;
    double time_;
    std::vector<FoamPieceFiles> files_;
    std::vector<std::size_t> root_; // piece -> index into foam_.roots
    std::vector<std::size_t> first_point_, first_cell_;
    std::size_t point_count_ = 0, cell_count_ = 0;
    std::string first_reason_;
    FoamMesh mesh_;
};

} // namespace

FoamMesh read_foam_mesh(const FoamCase& foam, const std::string& region, double time) {
    return MeshBuilder(foam, region, time).run();
}

std::vector<fs::path> foam_mesh_files(const FoamCase& foam, const std::string& region, double time) {
    std::vector<fs::path> files;
    for (const FoamRoot& root : foam.roots)
        for (const char* name : {"points", "faces", "owner", "neighbour", "boundary", "cellZones", "faceZones"})
            files.push_back(root.mesh_file(region, name, time));
    return files;
}

} // namespace server::importer
