// The parts of the module, and the types that they share. Not in the paper.
#pragma once

#include "arrays.hpp"
#include "ciel/contour.hpp"

namespace ciel::python {

// A surface for Python. Each access to an array property makes a new NumPy array.
struct PySurface {
    Surface surface;
    Vec3d origin{};

    [[nodiscard]] py::array_t<double> points() const;
    [[nodiscard]] py::array_t<std::uint32_t> edges() const;
    [[nodiscard]] py::array_t<double> weights() const;
    [[nodiscard]] py::array_t<std::uint32_t> chunks() const;
    [[nodiscard]] py::array_t<std::uint32_t> triangles() const;
};

[[nodiscard]] inline PySurface surface_of(Surface&& surface, const Mesh& mesh) {
    return {std::move(surface), mesh.stored().surface_origin};
}

// Makes the field of `values`: one per point of the mesh, or per cell.
[[nodiscard]] inline Field field_of(const Mesh& mesh, const ArrayView& values, bool of_cells) {
    return of_cells ? Field::from_cells(mesh, values) : Field(mesh, values);
}

void add_mesh(py::module_& module);
void add_surface(py::module_& module);
void add_contour(py::module_& module);
void add_cuts(py::module_& module);
void add_of_surfaces(py::module_& module);

} // namespace ciel::python
