// Python bindings of the kernel: the module ciel_mesh._kernel. The kernel reads NumPy arrays without a copy.
// Exception: contour_lines converts values to float64. The bindings release the GIL while the kernel works. Docstrings
// give the shapes of arrays; ciel_mesh/__init__.pyi has the type annotations.
#include "parts.hpp"

PYBIND11_MODULE(_kernel, module) {
    module.doc() = "Iso-surfaces and slices of polyhedral meshes (circular incident edge lists).";
    pybind11::register_exception<ciel::Error>(module, "Error", PyExc_ValueError);
    ciel::python::add_mesh(module);
    ciel::python::add_surface(module);
    ciel::python::add_contour(module);
    ciel::python::add_cuts(module);
    ciel::python::add_of_surfaces(module);
}
