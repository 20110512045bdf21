#include "module.hpp"

namespace ciel::python {

namespace {

py::dict report_of(const Mesh& mesh) {
    static constexpr const char* reasons[] = {
        "open", "inconsistent winding", "inside out", "index out of range", "too few faces", "repeated"};
    const MeshReport& report = mesh.report();
    py::dict bad;
    for (const BadCells& cells : report.assembled.bad_cells)
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

Mesh from_cells(const py::array& points, const py::array& types, const py::array& offsets,
                const py::array& connectivity, const std::optional<py::array>& face_locations,
                const std::optional<py::array>& faces, const std::optional<py::array>& cell_face_offsets,
                const std::optional<py::array>& cell_faces, const std::optional<py::array>& face_offsets,
                const std::optional<py::array>& face_connectivity) {
    const ArrayView at = view_of(points, "points");
    const VtkCells cells{view_of(types, "types"),
                         view_of(offsets, "offsets"),
                         view_of(connectivity, "connectivity"),
                         view_of(face_locations, "face_locations"),
                         view_of(faces, "faces"),
                         view_of(cell_face_offsets, "cell_face_offsets"),
                         view_of(cell_faces, "cell_faces"),
                         view_of(face_offsets, "face_offsets"),
                         view_of(face_connectivity, "face_connectivity")};
    const py::gil_scoped_release free;
    return Mesh::from_cells(at, cells);
}

Mesh from_polyhedra(const py::array& points, const py::array& cell_offset, const py::array& face_offset,
                    const py::array& face_vertex) {
    const ArrayView at = view_of(points, "points"), cells = view_of(cell_offset, "cell_offset"),
                    faces = view_of(face_offset, "face_offset"), ids = view_of(face_vertex, "face_vertex");
    const py::gil_scoped_release free;
    return Mesh::from_polyhedra(at, cells, faces, ids);
}

Mesh from_faces(const py::array& points, const py::array& face_offset, const py::array& face_vertex,
                const py::array& owner, const py::array& neighbour) {
    const ArrayView at = view_of(points, "points"), faces = view_of(face_offset, "face_offset"),
                    ids = view_of(face_vertex, "face_vertex"), own = view_of(owner, "owner"),
                    other = view_of(neighbour, "neighbour");
    const py::gil_scoped_release free;
    return Mesh::from_faces(at, faces, ids, own, other);
}

} // namespace

void add_mesh(py::module_& module) {
    py::class_<Mesh>(module, "Mesh", "A mesh of any cells, ready to be cut. Immutable; any thread may use it.")
        .def_static(
            "from_cells", &from_cells, py::arg("points"), py::arg("types"), py::arg("offsets"), py::arg("connectivity"),
            py::kw_only(), py::arg("face_locations") = py::none(), py::arg("faces") = py::none(),
            py::arg("cell_face_offsets") = py::none(), py::arg("cell_faces") = py::none(),
            py::arg("face_offsets") = py::none(), py::arg("face_connectivity") = py::none(),
            "Makes a mesh from the arrays of a vtkUnstructuredGrid.\n\n"
            "points: (V, 3) float32 or float64. types: (C,), VTK's numbers of cell types. offsets: (C + 1,) and\n"
            "connectivity: (N,), integers. Faces of polyhedra: up to VTK 9.3, face_locations (C,) and faces (M,);\n"
            "from VTK 9.4 on, cell_face_offsets, cell_faces, face_offsets and face_connectivity.\n"
            "Raises Error when an array has a wrong size. Unusable cells are left out; report lists them.")
        .def_static(
            "from_polyhedra", &from_polyhedra, py::arg("points"), py::arg("cell_offset"), py::arg("face_offset"),
            py::arg("face_vertex"),
            "Makes a mesh of cells that are lists of faces. Faces are lists of points.\n\n"
            "points: (V, 3) float32 or float64. cell_offset: (C + 1,), first face of each cell. face_offset:\n"
            "(F + 1,), index in face_vertex of the first point of each face. face_vertex: (N,), points. A face\n"
            "between two cells is listed once for each cell, in any winding. Raises Error when an array has a wrong\n"
            "size or number type.")
        .def_static(
            "from_faces", &from_faces, py::arg("points"), py::arg("face_offset"), py::arg("face_vertex"),
            py::arg("owner"), py::arg("neighbour"),
            "Makes a mesh of faces that are listed once, with the cells on both sides, as in OpenFOAM.\n\n"
            "points: (V, 3). face_offset: (F + 1,), face_vertex: (N,), owner: (F,), neighbour: (F,) or shorter. A\n"
            "missing or negative entry of neighbour means a boundary face. Raises Error as from_polyhedra does.")
        .def(
            "moved",
            [](const Mesh& mesh, const py::array& points) {
                const ArrayView at = view_of(points, "points");
                const py::gil_scoped_release free;
                return mesh.moved(at);
            },
            py::arg("points"),
            "Returns a mesh with the same cells and other points, (V, 3). Shares the topology. Raises Error when\n"
            "points has another shape.")
        .def_property_readonly("point_count", &Mesh::point_count)
        .def_property_readonly("cell_count", &Mesh::cell_count)
        .def_property_readonly(
            "block_count", [](const Mesh& mesh) { return mesh.topology().block_count(); },
            "Number of blocks of the mesh, for the option `blocks`.")
        .def_property_readonly(
            "report", &report_of,
            "How the input was changed: bad_cells {reason: (count, first ids)}, reversed_cells,\n"
            "inverted_cells, unmatched_faces, skipped_cells (cells without volume), reduced_cells\n"
            "(quadratic cells, reduced to their corners), bytes_copied (lists made to build the mesh).");
}

} // namespace ciel::python
