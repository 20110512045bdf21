"""Meshes in pieces (PVTU, or parts of one time in a PVD): joined where pieces meet, separate at cracks."""

import numpy as np
import pytest
import vtk
from import_support import Dataset, imported, run_import
from program import ciel
from vtk.util.numpy_support import numpy_to_vtk
from vtk_files import add_array, hexahedra, unstructured, write

N = 6
POINTS, CELLS = hexahedra(N)
CENTERS = POINTS[CELLS].mean(axis=1)
PIECE = (CENTERS[:, 0] > 0.5).astype(int) + 2 * (CENTERS[:, 1] > 0.4)  # four pieces that meet along an edge


def field(points):
    return np.linalg.norm(points - 0.5, axis=1)


def add_ids(grid, ids):
    array = numpy_to_vtk(np.asarray(ids, dtype=np.int64), deep=1)
    array.SetName("GlobalNodeId")
    grid.GetPointData().AddArray(array)


def piece(cells, ghosts=None, ids=False, shift=0.0):
    """A piece with its own points. `ghosts`: one flag for each cell."""
    used, local = np.unique(CELLS[cells], return_inverse=True)
    grid = unstructured([(vtk.VTK_HEXAHEDRON, row.tolist()) for row in local.reshape(-1, 8)], POINTS[used])
    add_array(grid.GetPointData(), "r", field(POINTS[used]) + shift)
    add_array(grid.GetCellData(), "c", field(CENTERS[cells]))
    if ghosts is not None:
        flags = numpy_to_vtk(ghosts.astype(np.uint8), deep=1)
        flags.SetName("vtkGhostType")
        grid.GetCellData().AddArray(flags)
    if ids:
        add_ids(grid, used)
    return grid


def pieces_of(of_cell=PIECE, **options):
    return [piece(np.flatnonzero(of_cell == i), **options) for i in range(of_cell.max() + 1)]


def pieces_with_ghosts():
    """Four pieces, each with a layer of ghost cells of its neighbors."""
    pieces = []
    for i in range(4):
        own = PIECE == i
        touched = np.isin(CELLS, np.unique(CELLS[own])).any(axis=1)
        cells = np.flatnonzero(touched)
        pieces.append(piece(cells, ghosts=~own[cells]))
    return pieces


def write_pieces(folder, grids):
    folder.mkdir(exist_ok=True)
    names = []
    for i, grid in enumerate(grids):
        write(vtk.vtkXMLUnstructuredGridWriter(), folder / f"p{i}.vtu", grid)
        names.append(f"p{i}.vtu")
    return names


def pvtu(folder, grids, names=None):
    names = write_pieces(folder, grids) if names is None else names
    arrays = '<PPointData><PDataArray type="Float64" Name="r"/></PPointData><PCellData><PDataArray type="Float64" Name="c"/></PCellData>'
    points = '<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
    pieces = "".join(f'<Piece Source="{name}"/>' for name in names)
    (folder / "a.pvtu").write_text(f'<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="0">'
                                   f"{arrays}{points}{pieces}</PUnstructuredGrid></VTKFile>")
    return folder / "a.pvtu"


def pvd(folder, grids):
    rows = "".join(f'<DataSet timestep="1" part="{i}" file="{name}"/>' for i, name in enumerate(write_pieces(folder, grids)))
    (folder / "a.pvd").write_text(f'<VTKFile type="Collection"><Collection>{rows}</Collection></VTKFile>')
    return folder / "a.pvd"


def area(dataset, value=0.3):
    surface = dataset.path.parent / "s.vtp"
    assert ciel("extract", dataset.path, "--iso", f"r={value}", "--triangles", "-o", surface).returncode == 0
    reader, mass = vtk.vtkXMLPolyDataReader(), vtk.vtkMassProperties()
    reader.SetFileName(str(surface))
    mass.SetInputConnection(reader.GetOutputPort())
    reader.Update()
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(reader.GetOutput())
    edges.FeatureEdgesOff()
    edges.Update()
    return mass.GetSurfaceArea(), edges.GetOutput().GetNumberOfCells()


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    return imported(folder, write(vtk.vtkXMLUnstructuredGridWriter(), folder / "a.vtu", piece(np.arange(len(CELLS)))))


@pytest.mark.parametrize("form", [pvtu, pvd])
@pytest.mark.parametrize("make", [pieces_of, pieces_with_ghosts, lambda: pieces_of(ids=True)], ids=["own", "ghosts", "ids"])
def test_pieces_are_one_mesh(whole, tmp_path, form, make):
    dataset = imported(tmp_path, form(tmp_path / "in", make()))
    for count in ("cells", "vertices", "faces", "boundary_faces", "edges"):
        assert dataset.counts()[count] == whole.counts()[count], count
    assert dataset.counts()["components"] == 1
    cut = sum(len(set(PIECE[list(pair)])) > 1 for pair in neighbours())
    assert f"The pieces of the mesh were joined along {cut} faces." in dataset.notes
    assert "not welded" not in dataset.notes, "points that were joined"
    expected, _ = area(whole)
    found, open_edges = area(dataset)
    assert open_edges == 0 and found == pytest.approx(expected, rel=1e-6)
    zones = {} if form is pvtu else {str(i): int((PIECE == i).sum()) for i in range(4)}
    assert {name: len(ids) for name, ids in dataset.groups().items()} == zones


def neighbours():
    ids = np.arange(N**3).reshape(N, N, N)
    for axis in range(3):
        a, b = np.moveaxis(ids, axis, 0)[:-1].ravel(), np.moveaxis(ids, axis, 0)[1:].ravel()
        yield from zip(a.tolist(), b.tolist())


def test_point_values_are_those_of_the_whole(whole, tmp_path):
    dataset = imported(tmp_path, pvtu(tmp_path / "in", pieces_with_ghosts()))

    def by_place(of):
        order = np.lexsort(np.round(of.positions(), 6).T)
        return of.values("r")[order], of.values("c")[order]

    for ours, theirs in zip(by_place(dataset), by_place(whole)):
        np.testing.assert_allclose(ours, theirs, atol=1e-6)


def test_a_crack_inside_one_piece_stays_open(tmp_path):
    """Two halves of one piece have their own points at the same positions."""
    halves = [piece(np.flatnonzero(CENTERS[:, 2] < 0.5)), piece(np.flatnonzero(CENTERS[:, 2] > 0.5))]
    append = vtk.vtkAppendFilter()
    for half in halves:
        append.AddInputData(half)
    append.Update()
    beside = piece(np.arange(1))
    places = np.array([beside.GetPoint(i) for i in range(beside.GetNumberOfPoints())]) + [1, 0, 0]
    for i, place in enumerate(places):
        beside.GetPoints().SetPoint(i, *place)  # `beside` shares a face with the other piece
    add_array(beside.GetPointData(), "r", field(places))
    dataset = imported(tmp_path, pvtu(tmp_path / "in", [append.GetOutput(), beside]))
    assert dataset.counts()["components"] == 2
    assert dataset.counts()["boundary_faces"] == 6 * N * N + 2 * N * N + 4


def test_a_crack_along_a_cut_stays_open(tmp_path):
    """The values differ on both sides of the cut, as at a geological fault."""
    left, right = CENTERS[:, 0] < 0.5, CENTERS[:, 0] > 0.5
    dataset = imported(tmp_path, pvtu(tmp_path / "in", [piece(np.flatnonzero(left)), piece(np.flatnonzero(right), shift=0.125)]))
    assert dataset.counts()["components"] == 2 and dataset.counts()["boundary_faces"] == 8 * N * N
    assert f"{2 * N * N} faces of pieces coincide with faces of another piece but differ in ids or values" in dataset.notes


def test_node_ids_tell_a_crack_where_values_are_equal(tmp_path):
    left, right = piece(np.flatnonzero(CENTERS[:, 0] < 0.5)), piece(np.flatnonzero(CENTERS[:, 0] > 0.5))
    add_ids(left, range(left.GetNumberOfPoints()))
    add_ids(right, range(10_000, 10_000 + right.GetNumberOfPoints()))
    assert imported(tmp_path, pvtu(tmp_path / "in", [left, right])).counts()["components"] == 2


def test_the_listing_has_one_line_for_all_pieces(tmp_path):
    listed = run_import(pvtu(tmp_path / "in", pieces_of()), "--list").stdout
    assert listed.count("block ") == 1 and f"{N**3} cells in 4 pieces" in listed


def test_no_weld_leaves_pieces_apart_and_says_so(tmp_path):
    dataset = imported(tmp_path, pvtu(tmp_path / "in", pieces_of()), "--no-weld")
    assert dataset.counts()["components"] == 4 and "not welded (--no-weld)" in dataset.notes


@pytest.mark.parametrize("damage", [lambda file: file.unlink(), lambda file: file.write_bytes(file.read_bytes()[:700])],
                         ids=["gone", "cut"])
@pytest.mark.parametrize("form", [pvtu, pvd])
def test_a_bad_piece_costs_that_piece(tmp_path, form, damage):
    file = form(tmp_path / "in", pieces_of())
    damage(tmp_path / "in/p2.vtu")
    done = run_import(file, "-o", tmp_path / "out.ciel")
    assert done.returncode == 3, done.stdout + done.stderr
    assert "A piece could not be read and was left out: " in done.stderr and "p2.vtu" in done.stderr
    dataset = Dataset(tmp_path / "out.ciel")
    assert dataset.counts()["cells"] == int((PIECE != 2).sum()) and "p2.vtu" in dataset.notes


def test_pieces_that_part_at_a_later_time_are_another_mesh_from_there(tmp_path):
    left, right = np.flatnonzero(CENTERS[:, 0] < 0.5), np.flatnonzero(CENTERS[:, 0] > 0.5)
    files = [pvtu(tmp_path / f"t{i}", [piece(left), piece(right, shift=shift)]) for i, shift in enumerate((0, 0.125))]
    rows = "".join(f'<DataSet timestep="{i}" file="{file.relative_to(tmp_path)}"/>' for i, file in enumerate(files))
    (tmp_path / "a.pvd").write_text(f'<VTKFile type="Collection"><Collection>{rows}</Collection></VTKFile>')
    dataset = imported(tmp_path, tmp_path / "a.pvd")
    assert [dataset.counts(i)["components"] for i in (0, 1)] == [1, 2]
    assert "points of two pieces differ that were welded at earlier times" in dataset.notes
