// Python bindings of the kernel: the module ciel_mesh._kernel. NumPy arrays are read without a copy, and the GIL is
// released while the kernel works. Docstrings give shapes; ciel_mesh/__init__.pyi has the type annotations.
#include "ciel/contour.hpp"
#include "ciel/contour_lines.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <utility>

namespace py = pybind11;

namespace {

using ciel::ArrayView;
using ciel::NumberType;

NumberType type_of(const py::array& array, const char* name) {
    const py::dtype type = array.dtype();
    const char kind = type.kind();
    const auto size = type.itemsize();
    const bool is_native = type.attr("isnative").cast<bool>();
    if (is_native && kind == 'f' && size == 4) return NumberType::float32;
    if (is_native && kind == 'f' && size == 8) return NumberType::float64;
    if (is_native && kind == 'i' && size == 4) return NumberType::int32;
    if (is_native && kind == 'i' && size == 8) return NumberType::int64;
    if (is_native && kind == 'u' && size == 4) return NumberType::uint32;
    if (is_native && kind == 'u' && size == 8) return NumberType::uint64;
    if (is_native && kind == 'u' && size == 1) return NumberType::uint8;
    throw py::type_error(std::string(name) + " has the type " +
                         py::str(static_cast<py::handle>(type)).cast<std::string>() +
                         "; use float32, float64, or integers of 32 or 64 bits in this machine's byte order");
}

// Returns a view that does not own the array. Throws ValueError unless the array has one or two dimensions, TypeError
// for a number type that the kernel does not read.
ArrayView view_of(const py::array& array, const char* name) {
    if (array.ndim() != 1 && array.ndim() != 2)
        throw py::value_error(std::string(name) + " must have one or two dimensions, not " +
                              std::to_string(array.ndim()));
    const bool is_table = array.ndim() == 2;
    return {array.data(),
            type_of(array, name),
            static_cast<std::size_t>(array.shape(0)),
            is_table ? static_cast<std::size_t>(array.shape(1)) : 1,
            array.strides(0),
            is_table ? array.strides(1) : 0};
}

ArrayView view_of(const std::optional<py::array>& array, const char* name) {
    return array ? view_of(*array, name) : ArrayView();
}

// Returns a NumPy array of rows x columns that takes over the vector's memory. A vector given as an rvalue is moved.
template <class Number, class Owner>
py::array_t<Number> array_of(Owner&& values, std::size_t columns) {
    using Vector = std::decay_t<Owner>;
    auto* kept = new Vector(std::forward<Owner>(values));
    const py::capsule owner(kept, [](void* vector) { delete static_cast<Vector*>(vector); });
    const auto rows = static_cast<py::ssize_t>(kept->size() * sizeof(kept->front()) / sizeof(Number) / columns);
    const auto* begin = reinterpret_cast<const Number*>(kept->data());
    if (columns == 1) return py::array_t<Number>({rows}, {sizeof(Number)}, begin, owner);
    return py::array_t<Number>({rows, static_cast<py::ssize_t>(columns)}, {columns * sizeof(Number), sizeof(Number)},
                               begin, owner);
}

ciel::Algorithm algorithm_of(const std::string& name) {
    if (name == "signatures") return ciel::Algorithm::signatures;
    if (name == "propagation") return ciel::Algorithm::propagation;
    if (name == "naive") return ciel::Algorithm::naive;
    throw py::value_error("algorithm is '" + name + "'; use 'signatures', 'propagation' or 'naive'");
}

ciel::Options options_of(const std::string& algorithm, const std::string& decider,
                         const std::optional<std::string>& normals) {
    ciel::Options options;
    options.algorithm = algorithm_of(algorithm);
    if (decider == "asymptotic")
        options.decider = ciel::Decider::asymptotic;
    else if (decider != "isolate-high")
        throw py::value_error("decider is '" + decider + "'; use 'isolate-high' or 'asymptotic'");
    if (!normals)
        options.normals = {};
    else if (*normals == "polygons")
        options.normals = ciel::Normals::polygons;
    else if (*normals != "gradient")
        throw py::value_error("normals is '" + *normals + "'; use 'gradient', 'polygons' or None");
    return options;
}

ciel::Vec3d vector_of(const std::array<double, 3>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

// A surface for Python. Each access to an array property makes a new NumPy array.
struct PySurface {
    ciel::Surface surface;
    ciel::Vec3d origin{};

    [[nodiscard]] py::array_t<double> points() const {
        py::array_t<double> out({static_cast<py::ssize_t>(surface.positions.size()), py::ssize_t{3}});
        auto to = out.mutable_unchecked<2>();
        for (std::size_t i = 0; i < surface.positions.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                to(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) =
                    origin[k] + static_cast<double>(surface.positions[i][k]);
        return out;
    }
    [[nodiscard]] py::array_t<std::uint32_t> edges() const {
        py::array_t<std::uint32_t> out({static_cast<py::ssize_t>(surface.points.size()), py::ssize_t{2}});
        auto to = out.mutable_unchecked<2>();
        for (std::size_t i = 0; i < surface.points.size(); ++i) {
            to(static_cast<py::ssize_t>(i), 0) = surface.points[i].a;
            to(static_cast<py::ssize_t>(i), 1) = surface.points[i].b;
        }
        return out;
    }
    [[nodiscard]] py::array_t<double> weights() const {
        py::array_t<double> out(static_cast<py::ssize_t>(surface.points.size()));
        auto to = out.mutable_unchecked<1>();
        for (std::size_t i = 0; i < surface.points.size(); ++i) to(static_cast<py::ssize_t>(i)) = surface.points[i].t;
        return out;
    }
    [[nodiscard]] py::array_t<std::uint32_t> triangles() const {
        std::vector<ciel::Index> corners;
        {
            const py::gil_scoped_release free;
            corners = ciel::triangulate(surface);
        }
        return array_of<std::uint32_t>(std::move(corners), 3);
    }
};

PySurface surface_of(ciel::Surface&& surface, const ciel::Mesh& mesh) {
    return {std::move(surface), mesh.stored().surface_origin};
}

py::dict report_of(const ciel::Mesh& mesh) {
    static constexpr const char* reasons[] = {
        "open", "inconsistent winding", "inside out", "index out of range", "too few faces", "repeated"};
    const ciel::MeshReport& report = mesh.report();
    py::dict bad;
    for (const ciel::BadCells& cells : report.assembled.bad_cells)
        bad[reasons[static_cast<int>(cells.reason)]] = py::make_tuple(cells.count, cells.first_ids);
    py::dict out;
    out["bad_cells"] = bad;
    out["reversed_cells"] = report.assembled.reversed_cells;
    out["inverted_cells"] = report.assembled.inverted_cells;
    out["unmatched_faces"] = report.assembled.internal_boundaries;
    out["skipped_cells"] = report.skipped_cells;
    out["reduced_cells"] = report.reduced_cells;
    out["bytes_copied"] = report.bytes_copied;
    return out;
}

void add_mesh(py::module_& module) {
    py::class_<ciel::Mesh>(module, "Mesh", "A mesh of any cells, ready to be cut. Immutable; any thread may use it.")
        .def_static(
            "from_cells",
            [](const py::array& points, const py::array& types, const py::array& offsets, const py::array& connectivity,
               const std::optional<py::array>& face_locations, const std::optional<py::array>& faces,
               const std::optional<py::array>& cell_face_offsets, const std::optional<py::array>& cell_faces,
               const std::optional<py::array>& face_offsets, const std::optional<py::array>& face_connectivity) {
                const ArrayView at = view_of(points, "points");
                const ciel::VtkCells cells{view_of(types, "types"),
                                           view_of(offsets, "offsets"),
                                           view_of(connectivity, "connectivity"),
                                           view_of(face_locations, "face_locations"),
                                           view_of(faces, "faces"),
                                           view_of(cell_face_offsets, "cell_face_offsets"),
                                           view_of(cell_faces, "cell_faces"),
                                           view_of(face_offsets, "face_offsets"),
                                           view_of(face_connectivity, "face_connectivity")};
                const py::gil_scoped_release free;
                return ciel::Mesh::from_cells(at, cells);
            },
            py::arg("points"), py::arg("types"), py::arg("offsets"), py::arg("connectivity"), py::kw_only(),
            py::arg("face_locations") = py::none(), py::arg("faces") = py::none(),
            py::arg("cell_face_offsets") = py::none(), py::arg("cell_faces") = py::none(),
            py::arg("face_offsets") = py::none(), py::arg("face_connectivity") = py::none(),
            "Cells as vtkUnstructuredGrid has them.\n\n"
            "points: (V, 3) float32 or float64. types: (C,), VTK's numbers. offsets: (C + 1,), connectivity: (N,),\n"
            "integers. Faces of polyhedra: face_locations (C,) and faces (M,) as VTK 9.3 and older have them, or\n"
            "cell_face_offsets, cell_faces, face_offsets and face_connectivity as VTK 9.4 and newer.\n"
            "Raises Error where sizes do not fit. Cells that cannot be used are in report.")
        .def_static(
            "from_polyhedra",
            [](const py::array& points, const py::array& cell_offset, const py::array& face_offset,
               const py::array& face_vertex) {
                const ArrayView at = view_of(points, "points"), cells = view_of(cell_offset, "cell_offset"),
                                faces = view_of(face_offset, "face_offset"), ids = view_of(face_vertex, "face_vertex");
                const py::gil_scoped_release free;
                return ciel::Mesh::from_polyhedra(at, cells, faces, ids);
            },
            py::arg("points"), py::arg("cell_offset"), py::arg("face_offset"), py::arg("face_vertex"),
            "Cells as lists of faces, faces as lists of points.\n\n"
            "points: (V, 3) float32 or float64. cell_offset: (C + 1,) into the faces. face_offset: (F + 1,) into\n"
            "face_vertex: (N,). A face between two cells is listed once for each, in any winding.")
        .def_static(
            "from_faces",
            [](const py::array& points, const py::array& face_offset, const py::array& face_vertex,
               const py::array& owner, const py::array& neighbour) {
                const ArrayView at = view_of(points, "points"), faces = view_of(face_offset, "face_offset"),
                                ids = view_of(face_vertex, "face_vertex"), own = view_of(owner, "owner"),
                                other = view_of(neighbour, "neighbour");
                const py::gil_scoped_release free;
                return ciel::Mesh::from_faces(at, faces, ids, own, other);
            },
            py::arg("points"), py::arg("face_offset"), py::arg("face_vertex"), py::arg("owner"), py::arg("neighbour"),
            "Each face once with the cells on its sides, as OpenFOAM has them.\n\n"
            "face_offset: (F + 1,), face_vertex: (N,), owner: (F,), neighbour: (at most F,), negative where there\n"
            "is none.")
        .def(
            "moved",
            [](const ciel::Mesh& mesh, const py::array& points) {
                const ArrayView at = view_of(points, "points");
                const py::gil_scoped_release free;
                return mesh.moved(at);
            },
            py::arg("points"), "The same cells with other points, (V, 3). The structure is shared.")
        .def_property_readonly("point_count", &ciel::Mesh::point_count)
        .def_property_readonly("cell_count", &ciel::Mesh::cell_count)
        .def_property_readonly("report", &report_of,
                               "What became of the input: bad_cells {reason: (count, first ids)}, reversed_cells,\n"
                               "inverted_cells, unmatched_faces, skipped_cells (no volume), reduced_cells (quadratic\n"
                               "ones, of which the corners are kept), bytes_copied.");
}

void add_surface(py::module_& module) {
    py::class_<PySurface>(module, "Surface", "Polygons with shared points. Each array is made when it is asked for.")
        .def_property_readonly(
            "points", &PySurface::points,
            "(N, 3) float64, rounded like float32 relative to the middle of the mesh. Where that is\n"
            "not enough: interpolate(surface, mesh, points) of the mesh's own points.")
        .def_property_readonly(
            "normals", [](const PySurface& self) { return array_of<float>(std::vector(self.surface.normals), 3); },
            "(N, 3) float32, unit, towards higher values; (0, 3) where none were asked for")
        .def_property_readonly(
            "polygon_offset",
            [](const PySurface& self) { return array_of<std::uint32_t>(std::vector(self.surface.polygon_offset), 1); },
            "(P + 1,) uint32, into polygon_vertex")
        .def_property_readonly(
            "polygon_vertex",
            [](const PySurface& self) { return array_of<std::uint32_t>(std::vector(self.surface.polygon_vertex), 1); },
            "uint32, into points")
        .def_property_readonly(
            "polygon_cell",
            [](const PySurface& self) { return array_of<std::uint32_t>(std::vector(self.surface.polygon_cell), 1); },
            "(P,) uint32: the cell of the mesh that each polygon cuts")
        .def_property_readonly("edges", &PySurface::edges,
                               "(N, 2) uint32: the points of the mesh between which each lies")
        .def_property_readonly("weights", &PySurface::weights, "(N,) float64: 0 at the first of edges, 1 at the second")
        .def_property_readonly("triangles", &PySurface::triangles, "(T, 3) uint32, into points")
        .def("__len__", [](const PySurface& self) { return self.surface.polygon_cell.size(); });
}

// A Contour and its mesh, whose surface_origin is added to the positions of its surfaces.
// The mutex lets threads that share the object take turns, because the GIL is released during calls.
struct PyContour {
    PyContour(const ciel::Mesh& of, const ArrayView& values, const ciel::Options& options)
        : mesh(of), contour(ciel::Field(of, values), options) {}

    ciel::Mesh mesh;
    ciel::Contour contour;
    std::mutex mutex;
};

void add_contour(py::module_& module) {
    py::class_<PyContour>(
        module, "Contour",
        "One surface kept from level to level: for sliders and animations. Threads that share one take turns.")
        .def(py::init([](const ciel::Mesh& mesh, const py::array& values, const std::string& algorithm,
                         const std::string& decider, const std::optional<std::string>& normals) {
                 const ciel::Options options = options_of(algorithm, decider, normals);
                 const ArrayView numbers = view_of(values, "values");
                 const py::gil_scoped_release free;
                 return std::make_unique<PyContour>(mesh, numbers, options);
             }),
             py::arg("mesh"), py::arg("values"), py::kw_only(), py::arg("algorithm") = "signatures",
             py::arg("decider") = "isolate-high", py::arg("normals") = "gradient",
             "values: (V,), one per point of the mesh; NaN and infinities are no values.")
        .def(
            "set",
            [](PyContour& self, const py::array& values, const std::optional<ciel::Mesh>& mesh) {
                const ArrayView numbers = view_of(values, "values");
                const py::gil_scoped_release free;
                const std::scoped_lock lock(self.mutex);
                const ciel::Mesh& of = mesh ? *mesh : self.mesh;
                self.contour.set(ciel::Field(of, numbers));
                if (mesh) self.mesh = *mesh;
            },
            py::arg("values"), py::arg("mesh") = py::none(),
            "Another array or time step, perhaps on the moved mesh. Nothing is indexed anew.")
        .def(
            "at",
            [](PyContour& self, double level) {
                const py::gil_scoped_release free;
                const std::scoped_lock lock(self.mutex);
                ciel::Surface surface;
                self.contour.at(level, surface);
                return surface_of(std::move(surface), self.mesh);
            },
            py::arg("level"), "The surface where the values are `level`.");
}

void add_functions(py::module_& module) {
    module.def(
        "contour",
        [](const ciel::Mesh& mesh, const py::array& values, double level, const std::string& algorithm,
           const std::string& decider, const std::optional<std::string>& normals) {
            const ciel::Options options = options_of(algorithm, decider, normals);
            const ArrayView numbers = view_of(values, "values");
            ciel::Surface surface;
            {
                const py::gil_scoped_release free;
                surface = ciel::contour(mesh, numbers, level, options);
            }
            return surface_of(std::move(surface), mesh);
        },
        py::arg("mesh"), py::arg("values"), py::arg("level"), py::kw_only(), py::arg("algorithm") = "signatures",
        py::arg("decider") = "isolate-high", py::arg("normals") = "gradient",
        "The iso-surface of values, (V,), at one level. normals: 'gradient', 'polygons' or None.");
    module.def(
        "slice",
        [](const ciel::Mesh& mesh, const std::array<double, 3>& origin, const std::array<double, 3>& normal) {
            ciel::Surface surface;
            {
                const py::gil_scoped_release free;
                surface = ciel::slice(mesh, vector_of(origin), vector_of(normal));
            }
            return surface_of(std::move(surface), mesh);
        },
        py::arg("mesh"), py::arg("origin"), py::arg("normal"), "The cut by a plane.");
    module.def(
        "threshold",
        [](const ciel::Mesh& mesh, const py::array& values, const std::array<double, 2>& range, bool of_cells) {
            const ArrayView numbers = view_of(values, "values");
            ciel::Surface surface;
            {
                const py::gil_scoped_release free;
                surface = ciel::threshold(mesh, numbers, range, of_cells);
            }
            return surface_of(std::move(surface), mesh);
        },
        py::arg("mesh"), py::arg("values"), py::arg("range"), py::arg("of_cells") = false,
        "The boundary of the cells whose values lie in range. values: (V,), or (C,) with of_cells.");
    module.def(
        "interpolate",
        [](const PySurface& surface, const ciel::Mesh& mesh, const py::array& values) {
            const ArrayView numbers = view_of(values, "values");
            std::vector<double> out;
            {
                const py::gil_scoped_release free;
                out = ciel::interpolate(surface.surface, mesh, numbers);
            }
            if (numbers.type() != ciel::NumberType::float32)
                return py::array(array_of<double>(std::move(out), numbers.columns()));
            return py::array(array_of<float>(std::vector<float>(out.begin(), out.end()), numbers.columns()));
        },
        py::arg("surface"), py::arg("mesh"), py::arg("values"),
        "values: (V,) or (V, K), per point of the mesh. Returns (N,) or (N, K), per point of the surface: float32 for\n"
        "float32, else float64.");
    module.def(
        "gradients",
        [](const ciel::Mesh& mesh, const py::array& values) {
            const ArrayView numbers = view_of(values, "values");
            std::vector<ciel::Vec3f> out;
            {
                const py::gil_scoped_release free;
                out = ciel::gradients(mesh, numbers);
            }
            return array_of<float>(std::move(out), 3);
        },
        py::arg("mesh"), py::arg("values"), "(V, 3) float32: the least-squares gradient at each point of the mesh.");
    module.def(
        "contour_lines",
        [](const PySurface& surface, const py::array_t<double, py::array::c_style | py::array::forcecast>& values,
           const std::vector<double>& levels) {
            const std::span<const double> numbers(values.data(), static_cast<std::size_t>(values.size()));
            std::vector<ciel::Vec3f> out;
            {
                const py::gil_scoped_release free;
                out = ciel::contour_lines(surface.surface, numbers, levels);
            }
            py::array_t<double> lines({static_cast<py::ssize_t>(out.size() / 2), py::ssize_t{2}, py::ssize_t{3}});
            double* to = lines.mutable_data();
            for (const ciel::Vec3f& at : out)
                for (std::size_t k = 0; k < 3; ++k) *to++ = surface.origin[k] + static_cast<double>(at[k]);
            return lines;
        },
        py::arg("surface"), py::arg("values"), py::arg("levels"),
        "Where values, (N,) per point of the surface, take the levels: segments, (L, 2, 3) float64.");
}

} // namespace

PYBIND11_MODULE(_kernel, module) {
    module.doc() = "Iso-surfaces and slices of polyhedral meshes (circular incident edge lists).";
    py::register_exception<ciel::Error>(module, "Error", PyExc_ValueError);
    add_mesh(module);
    add_surface(module);
    add_contour(module);
    add_functions(module);
}
