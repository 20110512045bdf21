#include "vs_vtk/duel.hpp"

#include "ciel/clip_surface.hpp"
#include "ciel/vector_operators.hpp"

#include <vtkNew.h>
#include <vtkPlane.h>
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
    }
    std::uint64_t clip(double place) {
        query_.set_field(
            Field::plane(*data_.topology, data_.mesh, data_.mesh.origin + place * normal, normal, *boxes_));
        (void)query_.extract(0, true, cap_);
        const ClippedSurface side = clip_surface(boundary_, {}, std::array{HalfSpace{normal, -place}}, 0);
        return bench::triangles_of(cap_) + bench::triangles_of(side.surface);
    }

private:
    const bench::Case& data_;
    Query query_;
    std::shared_ptr<const BlockBoxes> boxes_;
    Surface boundary_, cap_;
};

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
    duel("the plane of a clip moved",
         {"CIEL, slice and boundary",
          [&] {
              ours = !ours;
              return own.clip(places[ours ? 0 : 1]);
          }},
         {{"vtkTableBasedClipDataSet, without the surface", [&] {
               theirs = !theirs;
               const Vec3d at = places[theirs ? 0 : 1] * normal;
               plane->SetOrigin(at[0], at[1], at[2]);
               filter->Update();
               return static_cast<std::uint64_t>(filter->GetOutput()->GetNumberOfCells());
           }}});
}

} // namespace ciel::vs_vtk
