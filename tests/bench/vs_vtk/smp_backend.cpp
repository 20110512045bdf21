// A separate file, compiled as C++17, because vtkSMPTools.h of VTK 9.1 does not compile as C++20.
#include "vs_vtk/smp_backend.hpp"

#include <vtkSMPTools.h>

namespace ciel::vs_vtk {

const char* smp_backend() { return vtkSMPTools::GetBackend(); }

} // namespace ciel::vs_vtk
