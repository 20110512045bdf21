#include "options.hpp"

#include "ciel/parallel.hpp"

#include <memory>
#include <mutex>

namespace ciel::python {

namespace {

// The mutex is held during a call. The GIL does not protect the object, because calls release the GIL.
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
        "Makes iso-surfaces incrementally from level to level, for sliders and animations. If several threads use\n"
        "one object, their calls run one after another.");
    const std::string text = with_options_text(
        "values: (V,), one for each point of the mesh; with of_cells (C,), one for each cell. NaN and infinities mean\n"
        "'no value'.");
    with_option_keywords([&](const auto&... options) {
        type.def(py::init(with_options(&make_contour)), py::arg("mesh"), py::arg("values"), py::kw_only(),
                 py::arg("of_cells") = false, options..., text.c_str());
    });
    type.def(
        "set", &set_values, py::arg("values"), py::arg("mesh") = py::none(), py::kw_only(), py::arg("of_cells") = false,
        "Replaces the values, for example by another array or time step: (V,), or with of_cells (C,). mesh: the same\n"
        "mesh with moved points, or None. The topology is reused.");
    type.def("at", &surface_at, py::arg("level"), "Returns the iso-surface at level.");
}

} // namespace ciel::python
