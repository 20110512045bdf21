#include "module.hpp"

#include <memory>

namespace ciel::python {

py::array_t<double> PySurface::points() const {
    py::array_t<double> out({static_cast<py::ssize_t>(surface.positions.size()), py::ssize_t{3}});
    auto to = out.mutable_unchecked<2>();
    for (std::size_t i = 0; i < surface.positions.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            to(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) =
                origin[k] + static_cast<double>(surface.positions[i][k]);
    return out;
}

py::array_t<std::uint32_t> PySurface::edges() const {
    py::array_t<std::uint32_t> out({static_cast<py::ssize_t>(surface.points.size()), py::ssize_t{2}});
    auto to = out.mutable_unchecked<2>();
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        to(static_cast<py::ssize_t>(i), 0) = surface.points[i].a;
        to(static_cast<py::ssize_t>(i), 1) = surface.points[i].b;
    }
    return out;
}

py::array_t<double> PySurface::weights() const {
    py::array_t<double> out(static_cast<py::ssize_t>(surface.points.size()));
    auto to = out.mutable_unchecked<1>();
    for (std::size_t i = 0; i < surface.points.size(); ++i) to(static_cast<py::ssize_t>(i)) = surface.points[i].t;
    return out;
}

py::array_t<std::uint32_t> PySurface::chunks() const {
    py::array_t<std::uint32_t> out({static_cast<py::ssize_t>(surface.chunks.size()), py::ssize_t{3}});
    std::uint32_t* to = out.mutable_data();
    for (const Surface::Chunk& chunk : surface.chunks)
        for (const Index number : {chunk.block, chunk.polygon_begin, chunk.polygon_end}) *to++ = number;
    return out;
}

py::array_t<std::int32_t> PySurface::triangles() const {
    auto corners = std::make_unique<std::vector<Index>>();
    {
        const py::gil_scoped_release free;
        *corners = triangulate(surface);
    }
    const auto* begin = corners.get();
    const py::capsule owner(corners.release(), [](void* kept) { delete static_cast<std::vector<Index>*>(kept); });
    return indices_in(owner, *begin, surface.positions.size(), 3);
}

namespace {

const Surface& surface_in(const py::object& self) { return self.cast<const PySurface&>().surface; }

} // namespace

void add_surface(py::module_& module) {
    py::class_<PySurface>(module, "Surface",
                          "Polygons with shared points. A surface does not change. normals, polygon_offset,\n"
                          "polygon_vertex and polygon_cell are read-only views; the others are made at each access.")
        .def_property_readonly(
            "points", &PySurface::points,
            "(N, 3) float64. The kernel rounds positions to float32, as offsets from the middle of the mesh. For more\n"
            "digits, call interpolate(surface, mesh, points) with the points of the mesh.")
        .def_property_readonly(
            "normals", [](const py::object& self) { return view_in<float>(self, surface_in(self).normals, 3); },
            "(N, 3) float32: unit vectors towards higher values; (0, 3) if no normals were requested")
        .def_property_readonly(
            "polygon_offset",
            [](const py::object& self) {
                const Surface& surface = surface_in(self);
                return indices_in(self, surface.polygon_offset, surface.polygon_vertex.size());
            },
            "(P + 1,) int32: index in polygon_vertex of the first point of each polygon. With polygon_vertex, these "
            "are\n"
            "the arrays of vtkCellArray.SetData().")
        .def_property_readonly(
            "polygon_vertex",
            [](const py::object& self) {
                const Surface& surface = surface_in(self);
                return indices_in(self, surface.polygon_vertex, surface.positions.size());
            },
            "int32: indices in points, polygon by polygon")
        .def_property_readonly(
            "polygon_cell",
            [](const py::object& self) { return view_in<std::uint32_t>(self, surface_in(self).polygon_cell, 1); },
            "(P,) uint32: the mesh cell that contains each polygon")
        .def_property_readonly("edges", &PySurface::edges,
                               "(N, 2) uint32: the two mesh points between which each surface point lies. In a\n"
                               "clipped surface, only the first points have an entry.")
        .def_property_readonly("weights", &PySurface::weights,
                               "(N,) float64: 0 at the first mesh point, 1 at the second")
        .def_property_readonly("chunks", &PySurface::chunks,
                               "(K, 3) uint32, for each run of polygons in one block: block, first polygon, last + 1")
        .def_property_readonly("triangles", &PySurface::triangles, "(T, 3) int32: indices in points")
        .def("__len__", [](const PySurface& self) { return self.surface.polygon_cell.size(); });
}

} // namespace ciel::python
