#include "vs_vtk/duel.hpp"

#include "ciel/sweep_sinks.hpp"

#include <cmath>
#include <vtk3DLinearGridPlaneCutter.h>
#include <vtkCutter.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCutter.h>
#include <vtkPolyData.h>

namespace ciel::vs_vtk {
using namespace server;

namespace {

struct Planes {
    Vec3d normal;
    std::vector<double> at; // distances from the origin of the positions
};

template <class Cutter>
Contender cutter(const char* name, vtkUnstructuredGrid* grid, const Planes& planes) {
    auto filter = vtkSmartPointer<Cutter>::New();
    vtkNew<vtkPlane> plane;
    plane->SetNormal(planes.normal.data());
    filter->SetInputData(grid);
    if constexpr (std::is_same_v<Cutter, vtkCutter>) {
        filter->SetCutFunction(plane);
        return {name, [filter, planes] { // vtkCutter is fastest with all values in one call
                    filter->SetNumberOfContours(static_cast<int>(planes.at.size()));
                    for (int i = 0; i < static_cast<int>(planes.at.size()); ++i)
                        filter->SetValue(i, planes.at[static_cast<std::size_t>(i)]);
                    filter->Modified();
                    filter->Update();
                    return static_cast<std::uint64_t>(filter->GetOutput()->GetNumberOfCells());
                }};
    } else {
        filter->SetPlane(plane);
        return {name, [filter, planes, cut = vtkSmartPointer<vtkPlane>(plane)] {
                    std::uint64_t cells = 0;
                    for (const double at : planes.at) {
                        cut->SetOrigin(at * planes.normal[0], at * planes.normal[1], at * planes.normal[2]);
                        filter->Update();
                        cells += static_cast<std::uint64_t>(
                            filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL));
                    }
                    return cells;
                }};
    }
}

} // namespace

void slices(const bench::Case& data, vtkUnstructuredGrid* grid, std::size_t many) {
    const double part = 1 / std::sqrt(3.0);
    const store::Values property = store::converted(data.values, false);
    for (const auto& [normal, name] :
         {std::pair{Vec3d{1, 0, 0}, "box-aligned"}, {Vec3d{part, part, part}, "screen-aligned"}}) {
        const auto distance = [&, along = normal] {
            return bench::field_of(data, store::Values(plane_distance(data.mesh, data.mesh.origin, along)));
        };
        const auto [low, high] = distance().range();
        const Planes planes{normal, bench::values_between(low, high, many)};
        std::vector<SliceSink::Out> made;
        SweepBuffers<SliceSink> parts;
        std::vector<Contender> vtk{cutter<vtkPlaneCutter>("vtkPlaneCutter", grid, planes),
                                   cutter<vtkCutter>("vtkCutter", grid, planes)};
        if (vtk3DLinearGridPlaneCutter::CanFullyProcessDataObject(grid))
            vtk.push_back(cutter<vtk3DLinearGridPlaneCutter>("vtk3DLinearGridPlaneCutter", grid, planes));
        duel(std::to_string(planes.at.size()) + " slices, " + name + ", from nothing",
             {"CIEL, property interpolated",
              [&] {
                  sweep(*data.topology, data.mesh, distance(), planes.at, SliceSink{property.floats()}, parts, made);
                  std::uint64_t triangles = 0;
                  for (const SliceSink::Out& slice : made) triangles += slice.triangles.size() / 3;
                  return triangles;
              }},
             vtk);
    }
}

} // namespace ciel::vs_vtk
