// Python bindings of the kernel: ciel_mesh._kernel. The bindings pass NumPy arrays to the kernel without a copy.
// Exception: contour_lines copies values that are not a contiguous float64 array. The bindings release the GIL while
// the kernel works.
#include "module.hpp"

PYBIND11_MODULE(_kernel, module) {
    module.doc() = "Iso-surfaces and slices of polyhedral meshes (circular incident edge lists).";
    pybind11::register_exception<ciel::Error>(module, "Error", PyExc_ValueError);
    ciel::python::add_mesh(module);
    ciel::python::add_surface(module);
    ciel::python::add_contour(module);
    ciel::python::add_cuts(module);
    ciel::python::add_of_surfaces(module);
}
