// Name of VTK's SMP back end: "Sequential", "STDThread", "TBB" or "OpenMP".
#pragma once

namespace ciel::vs_vtk {

[[nodiscard]] const char* smp_backend();

} // namespace ciel::vs_vtk
