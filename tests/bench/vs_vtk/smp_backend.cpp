// By itself, for vtkSMPTools.h of VTK 9.1 is no C++20.
#include "vs_vtk/smp_backend.hpp"

#include <vtkSMPTools.h>

namespace ciel::vs_vtk {

const char* smp_backend() { return vtkSMPTools::GetBackend(); }

} // namespace ciel::vs_vtk
