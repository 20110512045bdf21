#include "options.hpp"

#include "ciel/parallel.hpp"

#include <memory>
#include <mutex>

namespace ciel::python {

namespace {

// A Contour and its mesh, whose surface_origin is added to the positions of its surfaces.
// The mutex lets threads that share the object take turns, because the GIL is released during calls.
struct PyContour {
    PyContour(const Mesh& of, const Field& field, const Options& options)
        : mesh(of), threads(options.threads), contour(field, options) {}

    Mesh mesh;
    unsigned threads;
    Contour contour;
    std::mutex mutex;
};

std::unique_ptr<PyContour> make_contour(const Options& options, const Mesh& mesh, const py::array& values,
                                        bool of_cells) {
    const ArrayView numbers = view_of(values, "values");
    std::unique_ptr<PyContour> made;
    const py::gil_scoped_release free;
    with_threads(options.threads,
                 [&] { made = std::make_unique<PyContour>(mesh, field_of(mesh, numbers, of_cells), options); });
    return made;
}

void set_values(PyContour& self, const py::array& values, const std::optional<Mesh>& mesh, bool of_cells) {
    const ArrayView numbers = view_of(values, "values");
    const py::gil_scoped_release free;
    const std::scoped_lock lock(self.mutex);
    const Mesh& of = mesh ? *mesh : self.mesh;
    with_threads(self.threads, [&] { self.contour.set(field_of(of, numbers, of_cells)); });
    if (mesh) self.mesh = *mesh;
}

PySurface surface_at(PyContour& self, double level) {
    const py::gil_scoped_release free;
    const std::scoped_lock lock(self.mutex);
    Surface surface;
    self.contour.at(level, surface);
    return surface_of(std::move(surface), self.mesh);
}

} // namespace

void add_contour(py::module_& module) {
    py::class_<PyContour> type(
        module, "Contour",
        "One surface kept from level to level: for sliders and animations. Threads that share one take turns.");
    const std::string text = with_options_text(
        "values: (V,), one per point of the mesh, or (C,) with of_cells; NaN and infinities are no values.");
    with_option_keywords([&](const auto&... options) {
        type.def(py::init(with_options(&make_contour)), py::arg("mesh"), py::arg("values"), py::kw_only(),
                 py::arg("of_cells") = false, options..., text.c_str());
    });
    type.def(
        "set", &set_values, py::arg("values"), py::arg("mesh") = py::none(), py::kw_only(), py::arg("of_cells") = false,
        "Another array or time step, (V,) or (C,) with of_cells, perhaps on the moved mesh. Nothing is indexed anew.");
    type.def("at", &surface_at, py::arg("level"), "The surface where the values are `level`.");
}

} // namespace ciel::python
