// The dimension of the cells of a VTK cell type.
#pragma once

namespace server::importer {

enum class Dimension { none, surface, volume };
// Returns `none` for points, lines, convex point sets and unknown types.
[[nodiscard]] Dimension cell_dimension(int vtk_type);

} // namespace server::importer
