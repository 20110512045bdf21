// The Python functions interpolate, clip, contour_lines, triangulate and gradients.
#include "module.hpp"

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

// The normal of the result has unit length, so that `slack` is a length.
HalfSpace half_space_of(const std::array<double, 3>& origin, const std::array<double, 3>& normal) {
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    if (!(length > 0) || !std::isfinite(length))
        fail("a clip plane needs a normal whose length is finite and not zero; give another normal");
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
    if (values && numbers.empty())
        throw Error("the array of values is empty; give one value for each point of the mesh, or leave the values out");
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
        "Interpolates values at the points of the surface. values: (V,) or (V, K), for the points of the mesh. With\n"
        "of_cells: (C,) or (C, K), for the cells; a point of the mesh gets a weighted mean of the cells around it.\n"
        "Returns (N,) or (N, K), for the points of the surface: float32 if values are float32, else float64.");
    module.def(
        "clip", &clip_at, py::arg("surface"), py::arg("mesh"), py::arg("planes"), py::arg("values") = py::none(),
        py::kw_only(), py::arg("slack") = 0.0,
        "Clips the surface: for each plane, keeps the side to which the normal points. planes: pairs of an origin,\n"
        "(3,), and a normal, (3,). values: (V,), for the points of the mesh, or None. slack: a length; points at most\n"
        "this far outside a plane are kept. Returns (surface, values at the points of the surface, (N,) float64, or\n"
        "None without values). New points lie on no edge of the mesh. Therefore interpolate, and clip with values,\n"
        "raise Error for a clipped surface.");
    module.def("gradients", &gradients_of, py::arg("mesh"), py::arg("values"),
               "Returns the least-squares gradient at each point of the mesh: (V, 3) float32. values: (V,).");
    module.def("contour_lines", &contour_lines_of, py::arg("surface"), py::arg("values"), py::arg("levels"),
               "Returns the line segments on the surface where values equal the levels, (L,): (S, 2, 3) float64.\n"
               "values: (N,), for the points of the surface.");
    module.def("triangulate", &PySurface::triangles, py::arg("surface"),
               "Returns the triangles of the polygons: (T, 3) int32, indices in surface.points. The property\n"
               "surface.triangles has the same array.");
}

} // namespace ciel::python
