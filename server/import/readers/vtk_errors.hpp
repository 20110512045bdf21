// VTK reports errors to a global window and goes on with less data than the file has. Here they become exceptions.
#pragma once

#include <string>
#include <vector>

namespace ciel::importer {

// Installs the window that keeps what VTK reports instead of printing it. Call once, before any reader is made.
void capture_vtk_errors();

// Throws Error naming `file` with the first error reported since the last call, if there was one; bad_alloc when
// it was about memory.
void throw_vtk_errors(const std::string& file);

// Drops what was reported so far (a probe that is expected to fail).
void forget_vtk_errors();

} // namespace ciel::importer
