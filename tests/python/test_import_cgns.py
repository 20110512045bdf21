"""CGNS files of the CGNS library (through ctypes): structured zones, mixed elements, polyhedra, boundary conditions."""

import ctypes
import ctypes.util

import numpy as np
import pytest
from import_support import imported
from vtk_files import CUBE_FACES, hexahedra, linear, mixed

N = 3
SIZE = ctypes.c_int32  # size of cgsize_t in Debian's build of the library

# Constants of cgnslib.h.
MODE_WRITE, FILE_HDF5 = 1, 2
STRUCTURED, UNSTRUCTURED = 2, 3
REAL_DOUBLE, CHARACTER, VERTEX, CELL_CENTER, FACE_CENTER = 4, 5, 2, 3, 4
BC_INFLOW, FAMILY_SPECIFIED, POINT_LIST, POINT_RANGE, TIME_ACCURATE = 9, 25, 2, 4, 1
QUAD_4, TETRA_4, PYRA_5, PENTA_6, HEXA_8, MIXED, NGON_N, NFACE_N = 7, 10, 12, 14, 17, 20, 22, 23


class Library:
    """Calls cg_NAME(...) as NAME(...), and raises on errors."""

    def __init__(self):
        name = next((n for n in ("libcgns.so.3.4", ctypes.util.find_library("cgns")) if n), None)
        try:
            self.cgns = ctypes.CDLL(name)
        except OSError:
            pytest.skip("libcgns3.4 is not installed")

    def __getattr__(self, name):
        def call(*arguments):
            words = [a.encode() if isinstance(a, str) else a for a in arguments]
            if getattr(self.cgns, "cg_" + name)(*words) != 0:
                self.cgns.cg_get_error.restype = ctypes.c_char_p
                raise RuntimeError(f"cg_{name}: {self.cgns.cg_get_error().decode()}")

        return call


def sizes(*values):
    return (SIZE * len(values))(*values)


class Writer:
    def __init__(self, path):
        self.cg, self.number = Library(), ctypes.c_int()
        self.cg.set_file_type(FILE_HDF5)
        self.cg.open(str(path), MODE_WRITE, ctypes.byref(self.number))
        self.file, self.base = self.number.value, 1
        self.cg.base_write(self.file, "Base", 3, 3, ctypes.byref(self.number))
        self.zones, self.path = 0, path

    def zone(self, name, kind, size, points):
        self.cg.zone_write(self.file, self.base, name, sizes(*size), kind, ctypes.byref(self.number))
        self.zones = self.number.value
        for axis, values in zip("XYZ", np.asarray(points).T):
            values = np.ascontiguousarray(values)
            self.cg.coord_write(self.file, self.base, self.zones, REAL_DOUBLE, f"Coordinate{axis}",
                                values.ctypes.data_as(ctypes.c_void_p), ctypes.byref(self.number))
        self.cells = 0

    def section(self, name, kind, rows):
        """Writes elements, numbered from 1 through all sections. Returns the number of the first one."""
        flat = np.ascontiguousarray(np.concatenate([np.ravel(row) for row in rows]), dtype="i4")
        first, self.cells = self.cells + 1, self.cells + len(rows)
        head = (self.file, self.base, self.zones, name, kind, SIZE(first), SIZE(self.cells), 0, flat.ctypes.data_as(ctypes.c_void_p))
        if kind in (MIXED, NGON_N, NFACE_N):
            starts = np.cumsum([0] + [len(row) for row in rows]).astype("i4")
            self.cg.poly_section_write(*head, starts.ctypes.data_as(ctypes.c_void_p), ctypes.byref(self.number))
        else:
            self.cg.section_write(*head, ctypes.byref(self.number))
        return first

    def boundary(self, name, kind, numbers, location, condition=FAMILY_SPECIFIED):
        count = 2 if kind == POINT_RANGE else len(numbers)
        self.cg.family_write(self.file, self.base, name, ctypes.byref(self.number))
        self.cg.boco_write(self.file, self.base, self.zones, name, condition, kind, SIZE(count), sizes(*numbers),
                           ctypes.byref(self.number))
        boundary = self.number.value
        self.cg.boco_gridlocation_write(self.file, self.base, self.zones, boundary, location)
        self.cg.goto(self.file, self.base, "Zone_t", self.zones, "ZoneBC_t", 1, "BC_t", boundary, "end")
        self.cg.famname_write(name)

    def times(self, values, solutions):
        self.cg.biter_write(self.file, self.base, "Iterations", len(values))
        self.cg.goto(self.file, self.base, "BaseIterativeData_t", 1, "end")
        self.cg.array_write("TimeValues", REAL_DOUBLE, 1, sizes(len(values)), (ctypes.c_double * len(values))(*values))
        self.cg.simulation_type_write(self.file, self.base, TIME_ACCURATE + 1)
        self.cg.ziter_write(self.file, self.base, self.zones, "ZoneIterations")
        self.cg.goto(self.file, self.base, "Zone_t", self.zones, "ZoneIterativeData_t", 1, "end")
        names = "".join(name.ljust(32) for name in solutions)
        self.cg.array_write("FlowSolutionPointers", CHARACTER, 2, sizes(32, len(solutions)), names)

    def solution(self, name, location, **fields):
        self.cg.sol_write(self.file, self.base, self.zones, name, location, ctypes.byref(self.number))
        solution = self.number.value
        for field, values in fields.items():
            values = np.ascontiguousarray(values, dtype="f8")
            self.cg.field_write(self.file, self.base, self.zones, solution, REAL_DOUBLE, field,
                                values.ctypes.data_as(ctypes.c_void_p), ctypes.byref(self.number))

    def close(self):
        self.cg.close(self.file)
        return self.path


def linear_over(points, cells, shift=0.0):
    return linear(points[cells].mean(axis=1)) + shift


def test_structured_zones_and_their_boundaries(tmp_path):
    points, cells = hexahedra(N)
    writer = Writer(tmp_path / "a.cgns")
    for name, shift in (("left", 0), ("right", 1)):
        here = points + [shift, 0, 0]
        writer.zone(name, STRUCTURED, 3 * [N + 1] + 3 * [N] + 3 * [0], here)
        writer.solution("Nodes", VERTEX, f=linear(here))
        writer.solution("Cells", CELL_CENTER, c=linear_over(here, cells))
        writer.boundary(f"{name} end", POINT_RANGE, [1, 1, 1, 1, N + 1, N + 1] if shift == 0 else [N + 1, 1, 1] + 3 * [N + 1], VERTEX)
    dataset = imported(tmp_path, writer.close(), "--weld")
    assert dataset.cells() == {"hexahedron": 2 * N**3} and dataset.volume() == pytest.approx(2)
    assert dataset.input["vertices"] == 2 * (N + 1) ** 3 and dataset.counts()["components"] == 1
    np.testing.assert_allclose(dataset.values("f"), linear(dataset.positions()), atol=1e-5)
    groups = dataset.groups()
    assert {name: len(ids) for name, ids in groups.items()} == {
        "left": N**3, "right": N**3, "left end": N * N, "right end": N * N}
    np.testing.assert_allclose(dataset.positions()[dataset.points_of(groups["right end"])][:, 0], 2)


@pytest.mark.parametrize("one_section", [False, True], ids=["a section a kind", "mixed"])
def test_standard_elements_and_a_boundary_of_quadrilaterals(tmp_path, one_section):
    grid = mixed()
    rows = [[grid.GetCell(i).GetPointId(j) + 1 for j in range(grid.GetCell(i).GetNumberOfPoints())] for i in range(4)]
    points = np.array([grid.GetPoint(i) for i in range(12)])
    writer = Writer(tmp_path / "a.cgns")
    writer.zone("zone", UNSTRUCTURED, (len(points), 4, 0), points)
    kinds = (HEXA_8, PENTA_6, PYRA_5, TETRA_4)
    if one_section:
        writer.section("all", MIXED, [[kind, *row] for kind, row in zip(kinds, rows)])
    else:
        for kind, row in zip(kinds, rows):
            writer.section(f"kind {kind}", kind, [row])
    face = writer.section("wall", QUAD_4, [[1, 4, 3, 2]])
    writer.boundary("floor", POINT_RANGE, [face, face], FACE_CENTER)
    writer.solution("Nodes", VERTEX, f=linear(points))
    corners = points[np.array(rows[3]) - 1]
    tetrahedron = np.linalg.det(corners[1:] - corners[0]) / 6
    dataset = imported(tmp_path, writer.close())
    assert dataset.cells() == {"hexahedron": 1, "wedge": 1, "pyramid": 1, "tetrahedron": 1}
    assert dataset.volume() == pytest.approx(1 + 0.5 + 1 / 3 + abs(tetrahedron))
    np.testing.assert_allclose(dataset.values("f"), linear(dataset.positions()), atol=1e-5)
    (floor,) = dataset.groups()["floor"]
    np.testing.assert_allclose(dataset.positions()[dataset.points_of([floor])][:, 2], 0)


def faces_of(points, cells):
    """Returns NGON loops, NFACE rows and the faces at x = 0, numbered from 1. Negative numbers in a row mark reversed loops."""
    number, loops, rows = {}, [], []
    for nodes in cells:
        rows.append([])
        for face in CUBE_FACES:
            loop = [int(nodes[i]) for i in face]
            key = tuple(sorted(loop))
            rows[-1].append(-number[key] if key in number else len(loops) + 1)
            if key not in number:
                loops.append(np.array(loop) + 1)
                number[key] = len(loops)
    inlet = [i + 1 for i, loop in enumerate(loops) if np.all(points[loop - 1][:, 0] == 0)]
    return loops, rows, inlet


def test_polyhedra_their_boundary_and_times(tmp_path):
    points, cells = hexahedra(N)
    loops, rows, inlet = faces_of(points, cells)
    writer = Writer(tmp_path / "a.cgns")
    writer.zone("zone", UNSTRUCTURED, (len(points), len(cells), 0), points)
    writer.section("faces", NGON_N, loops)
    writer.section("cells", NFACE_N, rows)
    writer.boundary("inlet", POINT_LIST, inlet, FACE_CENTER)
    for step in (0, 1):
        writer.solution(f"Cells{step}", CELL_CENTER, c=linear_over(points, cells, step))
    writer.times([0.5, 1.5], ["Cells0", "Cells1"])
    dataset = imported(tmp_path, writer.close())
    assert dataset.cells() == {"hexahedron": N**3} and dataset.volume() == pytest.approx(1)
    assert dataset.counts()["faces"] == 3 * N * N * (N + 1) and dataset.counts()["components"] == 1
    assert dataset.times == [0.5, 1.5]
    original = dataset.mesh()["original_cell"][:]
    for step in (0, 1):
        np.testing.assert_allclose(dataset.values("cell:c", step), linear_over(points, cells, step)[original], atol=1e-5)
    assert {name: len(ids) for name, ids in dataset.groups().items()} == {"inlet": N * N}
    np.testing.assert_allclose(dataset.positions()[dataset.points_of(dataset.groups()["inlet"])][:, 0], 0)


def test_boundary_conditions_without_a_family_are_told(tmp_path):
    points, _ = hexahedra(N)
    writer = Writer(tmp_path / "a.cgns")
    writer.zone("zone", STRUCTURED, 3 * [N + 1] + 3 * [N] + 3 * [0], points)
    writer.boundary("inlet", POINT_RANGE, [1, 1, 1, 1, N + 1, N + 1], VERTEX, BC_INFLOW)
    dataset = imported(tmp_path, writer.close())
    assert dataset.counts()["cells"] == N**3 and dataset.groups() == {}
    assert "Boundary conditions of type BCInflow were not read" in dataset.notes
