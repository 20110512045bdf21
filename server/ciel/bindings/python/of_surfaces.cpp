// Functions of a surface and the values on its mesh: interpolate, clip, contour_lines and triangulate; and gradients.
#include "parts.hpp"

#include "ciel/contour_lines.hpp"

#include <cmath>

namespace ciel::python {

namespace {

py::array interpolate_at(const PySurface& surface, const Mesh& mesh, const py::array& values, bool of_cells) {
    const ArrayView numbers = view_of(values, "values");
    std::vector<double> out;
    {
        const py::gil_scoped_release free;
        out = interpolate(surface.surface, mesh, numbers, of_cells);
    }
    if (numbers.type() != NumberType::float32) return array_of<double>(std::move(out), numbers.columns());
    return array_of<float>(std::vector<float>(out.begin(), out.end()), numbers.columns());
}

// Returns the half-space on the side of `normal`. Its normal has unit length, so that `slack` is a length.
HalfSpace half_space_of(const std::array<double, 3>& origin, const std::array<double, 3>& normal) {
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    if (!(length > 0) || !std::isfinite(length)) fail("a plane to clip at needs a normal of finite length, not zero");
    HalfSpace out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out.normal[axis] = normal[axis] / length;
        out.offset -= out.normal[axis] * origin[axis];
    }
    return out;
}

using Plane = std::pair<std::array<double, 3>, std::array<double, 3>>; // origin and normal

std::pair<PySurface, std::optional<py::array_t<double>>> clip_at(const PySurface& surface, const Mesh& mesh,
                                                                 const std::vector<Plane>& planes,
                                                                 const std::optional<py::array>& values, double slack) {
    const ArrayView numbers = view_of(values, "values");
    if (values && numbers.empty()) throw Error("values to clip with must be one per point of the mesh, not none");
    std::vector<HalfSpace> half_spaces;
    for (const auto& [origin, normal] : planes) half_spaces.push_back(half_space_of(origin, normal));
    ClippedSurface out;
    {
        const py::gil_scoped_release free;
        out = clip(surface.surface, mesh, numbers, half_spaces, slack);
    }
    std::optional<py::array_t<double>> of_points;
    if (values) of_points = array_of<double>(std::move(out.values), 1);
    return {PySurface{std::move(out.surface), surface.origin}, std::move(of_points)};
}

py::array_t<float> gradients_of(const Mesh& mesh, const py::array& values) {
    const ArrayView numbers = view_of(values, "values");
    std::vector<Vec3f> out;
    {
        const py::gil_scoped_release free;
        out = gradients(mesh, numbers);
    }
    return array_of<float>(std::move(out), 3);
}

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

py::array_t<double> contour_lines_of(const PySurface& surface, const Doubles& values,
                                     const std::vector<double>& levels) {
    const std::span<const double> numbers(values.data(), static_cast<std::size_t>(values.size()));
    std::vector<Vec3f> out;
    {
        const py::gil_scoped_release free;
        out = contour_lines(surface.surface, numbers, levels);
    }
    py::array_t<double> lines({static_cast<py::ssize_t>(out.size() / 2), py::ssize_t{2}, py::ssize_t{3}});
    double* to = lines.mutable_data();
    for (const Vec3f& at : out)
        for (std::size_t k = 0; k < 3; ++k) *to++ = surface.origin[k] + static_cast<double>(at[k]);
    return lines;
}

} // namespace

void add_of_surfaces(py::module_& module) {
    module.def(
        "interpolate", &interpolate_at, py::arg("surface"), py::arg("mesh"), py::arg("values"), py::kw_only(),
        py::arg("of_cells") = false,
        "values: (V,) or (V, K), per point of the mesh; with of_cells (C,) or (C, K), of which points get weighted\n"
        "means. Returns (N,) or (N, K), per point of the surface: float32 for float32, else float64.");
    module.def(
        "clip", &clip_at, py::arg("surface"), py::arg("mesh"), py::arg("planes"), py::arg("values") = py::none(),
        py::kw_only(), py::arg("slack") = 0.0,
        "The part of the surface on the side of the normal of each plane. planes: pairs of an origin, (3,), and a\n"
        "normal, (3,). values: (V,), per point of the mesh. Returns the surface, and the values at its points, (N,)\n"
        "float64, or None without values. Points at most slack outside a plane are kept. New points lie on no edge\n"
        "of the mesh, so a clipped surface cannot be clipped or interpolated again.");
    module.def("gradients", &gradients_of, py::arg("mesh"), py::arg("values"),
               "values: (V,). Returns (V, 3) float32: the least-squares gradient at each point of the mesh.");
    module.def("contour_lines", &contour_lines_of, py::arg("surface"), py::arg("values"), py::arg("levels"),
               "Where values, (N,) per point of the surface, take the levels, (L,): segments, (S, 2, 3) float64.");
    module.def("triangulate", &PySurface::triangles, py::arg("surface"),
               "The triangles of the polygons, (T, 3) uint32, into surface.points. The same as surface.triangles.");
}

} // namespace ciel::python
