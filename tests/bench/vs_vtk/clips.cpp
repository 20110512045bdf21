#include "vs_vtk/duel.hpp"

#include "ciel/clip_surface.hpp"
#include "ciel/vector_operators.hpp"

#include <vtkCellArray.h>
#include <vtkClipPolyData.h>
#include <vtkCutter.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTableBasedClipDataSet.h>

namespace ciel::vs_vtk {
using namespace server;

namespace {

const Vec3d normal{0.6, 0, 0.8};

// Distances of two planes from the origin of the positions.
std::array<double, 2> places_of(const bench::Case& data) {
    const Field distance = bench::field_of(data, store::Values(plane_distance(data.mesh, data.mesh.origin, normal)));
    const std::vector<double> places = bench::values_between(distance.range()[0], distance.range()[1], 2);
    return {places[0], places[1]};
}

// Makes what CIEL shows of a clipped mesh: the slice in the plane, and the boundary on one side of it.
class Own {
public:
    explicit Own(const bench::Case& data) : data_(data), query_(*data.topology, data.mesh) {
        const std::size_t step = data.dataset->step_at(data.time);
        boxes_ = data.loaded->boxes(step);
        boundary_ = data.loaded->boundary_surface(step, {}, data.mesh.origin);
        const store::Values values = store::converted(data.values, false);
        of_boundary_.resize(boundary_.points.size());
        interpolate(boundary_.points, values.floats(), 1, of_boundary_);
    }
    [[nodiscard]] const Surface& boundary() const { return boundary_; }
    [[nodiscard]] std::span<const float> of_boundary() const { return of_boundary_; }
    std::uint64_t clip(double place) {
        query_.set_field(
            Field::plane(*data_.topology, data_.mesh, data_.mesh.origin + place * normal, normal, *boxes_));
        (void)query_.extract(0, true, cap_);
        const ClippedSurface side = clip_surface(boundary_, of_boundary_, std::array{HalfSpace{normal, -place}}, 0);
        return bench::triangles_of(cap_) + bench::triangles_of(side.surface);
    }

private:
    const bench::Case& data_;
    Query query_;
    std::shared_ptr<const BlockBoxes> boxes_;
    Surface boundary_, cap_;
    std::vector<float> of_boundary_; // values at its points
};

vtkSmartPointer<vtkPolyData> as_poly_data(const Surface& surface, std::span<const float> values) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> scalars;
    for (std::size_t p = 0; p < surface.positions.size(); ++p) {
        points->InsertNextPoint(surface.positions[p].data());
        scalars->InsertNextValue(values[p]);
    }
    vtkNew<vtkCellArray> polygons;
    for (std::size_t i = 0; i + 1 < surface.polygon_offset.size(); ++i) {
        polygons->InsertNextCell(static_cast<int>(surface.polygon_offset[i + 1] - surface.polygon_offset[i]));
        for (Index at = surface.polygon_offset[i]; at < surface.polygon_offset[i + 1]; ++at)
            polygons->InsertCellPoint(surface.polygon_vertex[at]);
    }
    auto made = vtkSmartPointer<vtkPolyData>::New();
    made->SetPoints(points);
    made->SetPolys(polygons);
    made->GetPointData()->SetScalars(scalars);
    return made;
}

// The slice, and the clip of a boundary that was made before, as CIEL has it.
Contender slice_and_boundary(const Own& own, vtkUnstructuredGrid* grid, vtkPlane* plane, std::function<void()> move) {
    auto cutter = vtkSmartPointer<vtkCutter>::New();
    cutter->SetInputData(grid);
    cutter->SetCutFunction(plane);
    auto clipper = vtkSmartPointer<vtkClipPolyData>::New();
    clipper->SetInputData(as_poly_data(own.boundary(), own.of_boundary()));
    clipper->SetClipFunction(plane);
    return {"vtkCutter and vtkClipPolyData", [cutter, clipper, move = std::move(move)] {
                move();
                cutter->Update();
                clipper->Update();
                return static_cast<std::uint64_t>(cutter->GetOutput()->GetNumberOfCells() +
                                                  clipper->GetOutput()->GetNumberOfCells());
            }};
}

} // namespace

void clips(const bench::Case& data, vtkUnstructuredGrid* grid) {
    const std::array<double, 2> places = places_of(data);
    Own own(data);
    vtkNew<vtkPlane> plane;
    plane->SetNormal(normal.data());
    auto filter = vtkSmartPointer<vtkTableBasedClipDataSet>::New();
    filter->SetInputData(grid);
    filter->SetClipFunction(plane);
    bool ours = false, theirs = false;
    const auto move = [&, plane = plane.Get()] {
        theirs = !theirs;
        const Vec3d at = places[theirs ? 0 : 1] * normal;
        plane->SetOrigin(at[0], at[1], at[2]);
    };
    duel("the plane of a clip moved (triangles, polygons, cells)",
         {"CIEL, slice and boundary",
          [&] {
              ours = !ours;
              return own.clip(places[ours ? 0 : 1]);
          }},
         {slice_and_boundary(own, grid, plane, move), {"vtkTableBasedClipDataSet, without the surface", [&] {
                                                           move();
                                                           filter->Update();
                                                           return static_cast<std::uint64_t>(
                                                               filter->GetOutput()->GetNumberOfCells());
                                                       }}});
}

} // namespace ciel::vs_vtk
