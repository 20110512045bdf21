// Alternating pictures by CIEL and by VTK. CIEL draws on its own thread, because GLX and EGL cannot both be current on
// one.
#pragma once

#include "engine/schedule/frame_workers.hpp"
#include "vs_vtk/duel.hpp"

namespace ciel::vs_vtk {
using namespace server;

// Limits on CIEL's time as a share of VTK's best: required and desired.
struct Asked {
    double must, hoped;
};
// Prints CIEL's share of VTK's best time beside the limits.
void compare(const Outcome& outcome, const Asked& asked);
// Prints the covered shares of both pictures. Throws Error when they differ much, or when all or nothing is covered.
void compare_covered(double ciel, double vtk);

// Both throw Error when CIEL and VTK draw something different.
void volumes(const bench::Case& data, vtkUnstructuredGrid* grid, engine::FrameWorkers& drawing);
void frames(const bench::Case& data, vtkUnstructuredGrid* grid, engine::FrameWorkers& drawing);

} // namespace ciel::vs_vtk
