#include "vs_vtk/duel.hpp"

#include <vtkGradientFilter.h>

namespace ciel::vs_vtk {
using namespace server;

void gradients(const bench::Case& data, vtkUnstructuredGrid* grid) {
    std::vector<Contender> vtk;
    for (const bool fast : {false, true}) {
        auto filter = vtkSmartPointer<vtkGradientFilter>::New();
        filter->SetInputData(grid);
        filter->SetInputScalars(vtkDataObject::FIELD_ASSOCIATION_POINTS, "values");
        filter->SetFasterApproximation(fast);
        vtk.push_back({fast ? "vtkGradientFilter, faster approximation" : "vtkGradientFilter", [filter] {
                           filter->Modified();
                           filter->Update();
                           return static_cast<std::uint64_t>(1);
                       }});
    }
    duel("gradients at all vertices",
         {"CIEL, least squares",
          [&] { return static_cast<std::uint64_t>(vertex_gradients(*data.topology, data.mesh, data.values).size()); }},
         vtk);
}

} // namespace ciel::vs_vtk
