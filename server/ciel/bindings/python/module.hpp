// Declarations that the sources of the Python module share. Not in the paper.
#pragma once

#include "arrays.hpp"
#include "ciel/contour.hpp"

namespace ciel::python {

// A surface for Python. The surface must not change, because NumPy arrays refer to its vectors. `origin` is added to
// positions.
struct PySurface {
    Surface surface;
    Vec3d origin{};

    [[nodiscard]] py::array_t<double> points() const;
    [[nodiscard]] py::array_t<std::uint32_t> edges() const;
    [[nodiscard]] py::array_t<double> weights() const;
    [[nodiscard]] py::array_t<std::uint32_t> chunks() const;
    [[nodiscard]] py::array_t<std::int32_t> triangles() const;
};

[[nodiscard]] inline PySurface surface_of(Surface&& surface, const Mesh& mesh) {
    return {std::move(surface), mesh.stored().surface_origin};
}

// `values`: one for each point of the mesh; with `of_cells`, one for each cell.
[[nodiscard]] inline Field field_of(const Mesh& mesh, const ArrayView& values, bool of_cells) {
    return of_cells ? Field::from_cells(mesh, values) : Field(mesh, values);
}

void add_mesh(py::module_& module);
void add_surface(py::module_& module);
void add_contour(py::module_& module);
void add_cuts(py::module_& module);
void add_of_surfaces(py::module_& module);

} // namespace ciel::python
