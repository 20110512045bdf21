// Turns VTK's errors into exceptions. VTK only reports errors to a global window and continues with incomplete data.
#pragma once

#include <string>
#include <vector>

namespace server::importer {

// Installs a window that stores VTK's errors instead of printing them. Call once, before any reader is made.
void capture_vtk_errors();

// Throws Error, with `file` in the text, for the first VTK error since the last call. Throws std::bad_alloc if the
// error is a failed allocation. Does nothing if there was no error.
void throw_vtk_errors(const std::string& file);

// Discards the stored error, for a probe that is expected to fail.
void forget_vtk_errors();

} // namespace server::importer
