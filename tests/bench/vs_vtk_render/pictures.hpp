// Pictures by CIEL and by VTK, in turns. CIEL draws on a thread of its own: GLX and EGL cannot both be current on one.
#pragma once

#include "engine/schedule/frame_workers.hpp"
#include "vs_vtk/duel.hpp"

namespace ciel::vs_vtk {

// How CIEL's time should compare with VTK's best.
struct Asked {
    double must, hoped;
};
// Prints CIEL's share of VTK's best time beside what was asked for.
void compare(const Outcome& outcome, const Asked& asked);
// Prints both; throws Error unless about as much of the picture is covered on both sides, and neither all nor nothing.
void compare_covered(double ciel, double vtk);

// Each throws Error where a side draws something else than the other.
void volumes(const bench::Case& data, vtkUnstructuredGrid* grid, engine::FrameWorkers& drawing);
void frames(const bench::Case& data, vtkUnstructuredGrid* grid, engine::FrameWorkers& drawing);

} // namespace ciel::vs_vtk
