"""Every volume format that VTK can write: the imported dataset has the right counts, fields and volume."""

import json

import numpy as np
import pytest
import vtk
from import_support import ciel_info, imported, run_import
from vtk_files import (
    CUBE,
    CUBE_FACES,
    add_array,
    image,
    linear,
    mixed,
    multi_block,
    rectilinear,
    ring,
    structured,
    unstructured,
    with_fields,
    write,
)

ASCII, BINARY, APPENDED = 0, 1, 2

# Name, file, data, writer, settings of the writer.
WRITTEN = [
    ("vtu ascii", "a.vtu", mixed, vtk.vtkXMLUnstructuredGridWriter, {"SetDataMode": ASCII}),
    ("vtu binary", "a.vtu", mixed, vtk.vtkXMLUnstructuredGridWriter, {"SetDataMode": BINARY}),
    ("vtu appended", "a.vtu", mixed, vtk.vtkXMLUnstructuredGridWriter, {"SetDataMode": APPENDED}),
    ("vtu raw big-endian", "a.vtu", mixed, vtk.vtkXMLUnstructuredGridWriter,
     {"SetDataMode": APPENDED, "SetEncodeAppendedData": 0, "SetByteOrder": 0}),
    ("pvtu", "a.pvtu", mixed, vtk.vtkXMLPUnstructuredGridWriter, {}),
    ("vts", "a.vts", structured, vtk.vtkXMLStructuredGridWriter, {}),
    ("pvts", "a.pvts", structured, vtk.vtkXMLPStructuredGridWriter, {}),
    ("vtr", "a.vtr", rectilinear, vtk.vtkXMLRectilinearGridWriter, {}),
    ("vti", "a.vti", image, vtk.vtkXMLImageDataWriter, {}),
    ("legacy unstructured", "a.vtk", mixed, vtk.vtkUnstructuredGridWriter, {"SetFileType": 1}),
    ("legacy unstructured binary", "a.vtk", mixed, vtk.vtkUnstructuredGridWriter, {"SetFileType": 2}),
    ("legacy 4.2", "a.vtk", mixed, vtk.vtkUnstructuredGridWriter, {"SetFileVersion": 42}),
    ("legacy structured", "a.vtk", structured, vtk.vtkStructuredGridWriter, {}),
    ("legacy rectilinear", "a.vtk", rectilinear, vtk.vtkRectilinearGridWriter, {}),
    ("legacy image", "a.vtk", image, vtk.vtkStructuredPointsWriter, {}),
    ("wrong extension", "a.vtk", mixed, vtk.vtkXMLUnstructuredGridWriter, {}),
]


def check_fields(dataset, tolerance=1e-5):
    position = dataset.positions()
    np.testing.assert_allclose(dataset.values("f"), linear(position), atol=tolerance)
    np.testing.assert_allclose(dataset.values("v"), position, atol=tolerance)


@pytest.mark.parametrize("file, data, writer, settings", [row[1:] for row in WRITTEN], ids=[row[0] for row in WRITTEN])
def test_written_by_vtk(tmp_path, file, data, writer, settings):
    source = with_fields(data())
    settings = dict(settings)
    if file.endswith(".pvtu"):
        settings["SetNumberOfPieces"] = 1
    dataset = imported(tmp_path, write(writer(), tmp_path / file, source, **settings))
    assert dataset.input["vertices"] == source.GetNumberOfPoints()
    assert dataset.input["cells"] == source.GetNumberOfCells()
    assert dataset.counts()["cells"] == source.GetNumberOfCells()
    assert dataset.array_names() == ["c", "cell:c", "f", "v"]
    check_fields(dataset)
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(source)
    sizes.Update()
    volume = sum(sizes.GetOutput().GetCellData().GetArray("Volume").GetTuple1(i) for i in range(source.GetNumberOfCells()))
    assert dataset.volume() == pytest.approx(volume, rel=1e-5)
    # Cell data is unchanged, in the order of the stored cells.
    original = dataset.mesh()["original_cell"][:]
    values = [source.GetCellData().GetArray("c").GetTuple1(int(i)) for i in original]
    np.testing.assert_allclose(dataset.values("cell:c"), values, rtol=1e-6)


def test_kinds_of_cells_are_recognised(tmp_path):
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", mixed()))
    # One of the hexahedra is stored as a polyhedron in the file.
    assert dataset.cells() == {"hexahedron": 2, "pyramid": 1, "tetrahedron": 1, "wedge": 1}
    assert dataset.counts()["components"] == 1


def test_point_data_made_from_cells_is_linear_inside_and_bounded_everywhere(tmp_path):
    source = with_fields(structured(9))
    dataset = imported(tmp_path, write(vtk.vtkXMLStructuredGridWriter(), tmp_path / "a.vts", source))
    position, made, cells = dataset.positions(), dataset.values("c"), dataset.values("cell:c")
    exact = linear(position)
    inside = np.all((position > 0.15) & (position < 0.85), axis=1)
    assert inside.sum() > 50
    # Cell centroids differ slightly from the means of corners.
    np.testing.assert_allclose(made[inside], exact[inside], atol=5e-3)
    assert made.min() >= cells.min() and made.max() <= cells.max()


def test_fields_of_image_cells_are_exact_inside(tmp_path):
    dataset = imported(tmp_path, write(vtk.vtkXMLImageDataWriter(), tmp_path / "a.vti", with_fields(image(7))))
    position = dataset.positions()
    inside = np.all((position > 0.01) & (position < 0.99), axis=1)
    np.testing.assert_allclose(dataset.values("c")[inside], linear(position)[inside], atol=1e-5)


def test_far_from_the_origin_nothing_is_lost(tmp_path):
    far = (5.0e6, 4.0e6, 300.0)
    points = [(x + far[0], y + far[1], z + far[2]) for x, y, z in CUBE]
    grid = unstructured([(vtk.VTK_HEXAHEDRON, list(range(8)))], points)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    order = dataset.mesh()["original_vertex"][:]
    np.testing.assert_allclose(dataset.positions(), np.array(points)[order], atol=1e-6)


def test_quadratic_cells_keep_their_corners_and_say_so(tmp_path):
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    middles = [tuple((np.array(corners[a]) + corners[b]) / 2) for a, b in [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]]
    grid = unstructured([(vtk.VTK_QUADRATIC_TETRA, list(range(10)))], corners + middles)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    assert dataset.cells() == {"tetrahedron": 1}
    assert dataset.input["vertices"] == 10 and dataset.counts()["vertices"] == 4
    assert "1 quadratic tetrahedra keep their corners" in dataset.notes


QUADRATIC = [
    (vtk.vtkQuadraticHexahedron, "hexahedron", 8, "quadratic hexahedra"),
    (vtk.vtkTriQuadraticHexahedron, "hexahedron", 8, "triquadratic hexahedra"),
    (vtk.vtkBiQuadraticQuadraticHexahedron, "hexahedron", 8, "quadratic hexahedra"),
    (vtk.vtkQuadraticTetra, "tetrahedron", 4, "quadratic tetrahedra"),
    (vtk.vtkQuadraticWedge, "wedge", 6, "quadratic wedges"),
    (vtk.vtkQuadraticLinearWedge, "wedge", 6, "quadratic wedges"),
    (vtk.vtkBiQuadraticQuadraticWedge, "wedge", 6, "quadratic wedges"),
    (vtk.vtkQuadraticPyramid, "pyramid", 5, "quadratic pyramids"),
]
LINEAR_VOLUME = {"hexahedron": 1, "tetrahedron": 1 / 6, "wedge": 1 / 2, "pyramid": 1 / 3}


@pytest.mark.parametrize("cell, kind, corners, words", QUADRATIC, ids=lambda value: getattr(value, "__name__", ""))
def test_every_quadratic_kind_keeps_its_corners_and_the_values_there(tmp_path, cell, kind, corners, words):
    cell = cell()
    points = np.reshape(cell.GetParametricCoords(), (-1, 3))
    grid = with_fields(unstructured([(cell.GetCellType(), list(range(len(points))))], points))
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    assert dataset.cells() == {kind: 1} and f"1 {words} keep their corners" in dataset.notes
    assert dataset.input["vertices"] == len(points)
    assert sorted(dataset.mesh()["original_vertex"][:]) == list(range(corners))
    assert dataset.volume() == pytest.approx(LINEAR_VOLUME[kind], rel=1e-5)
    check_fields(dataset)


def test_voxels_and_prisms(tmp_path):
    voxel = unstructured([(vtk.VTK_VOXEL, list(range(8)))], [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)])
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", voxel))
    assert dataset.cells() == {"hexahedron": 1} and dataset.volume() == pytest.approx(1)

    (tmp_path / "b").mkdir()
    circle = [(np.cos(a), np.sin(a)) for a in np.arange(6) * np.pi / 3]
    prism = unstructured([(vtk.VTK_HEXAGONAL_PRISM, list(range(12)))], [(*p, z) for z in (0, 1) for p in circle])
    dataset = imported(tmp_path / "b", write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "b.vtu", prism))
    assert dataset.cells() == {"polyhedron": 1} and dataset.volume() == pytest.approx(3 * np.sqrt(3) / 2, rel=1e-5)


def test_surface_cells_become_a_group_of_boundary_faces(tmp_path):
    grid = unstructured([(vtk.VTK_HEXAHEDRON, list(range(8))), (vtk.VTK_QUAD, [0, 1, 2, 3]), (vtk.VTK_LINE, [0, 1])], CUBE)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    ((name, faces),) = dataset.groups().items()
    assert len(faces) == 1
    np.testing.assert_allclose(dataset.positions()[dataset.points_of(faces)][:, 2], 0)
    assert dataset.input["cells"] == 1 and "ignored" in dataset.notes


def test_multi_block_is_joined_and_not_welded(tmp_path):
    blocks = multi_block(("left", with_fields(image(3))), ("right", with_fields(image(3, origin=(1, 0, 0)))))
    file = write(vtk.vtkXMLMultiBlockDataWriter(), tmp_path / "a.vtm", blocks)
    dataset = imported(tmp_path, file)
    assert dataset.input["vertices"] == 54 and dataset.input["cells"] == 16
    assert dataset.counts()["components"] == 2 and "9 points coincide" in dataset.notes
    assert {name: len(ids) for name, ids in dataset.groups().items()} == {"left": 8, "right": 8}
    check_fields(dataset)

    dataset = imported(tmp_path, file, "--weld", "--force")
    assert dataset.input["vertices"] == 54 and dataset.counts()["vertices"] == 45
    assert dataset.counts()["components"] == 1 and "9 points that coincide with others were welded" in dataset.notes


def test_an_array_that_a_block_lacks_is_no_value_there(tmp_path):
    left, right = image(3), with_fields(image(3, origin=(1, 0, 0)))
    dataset = imported(tmp_path, write(vtk.vtkXMLMultiBlockDataWriter(), tmp_path / "a.vtm", multi_block(("a", left), ("b", right))))
    assert np.isnan(dataset.values("f")).sum() == 27


def test_the_seam_of_an_o_grid_is_welded_only_when_the_fields_agree(tmp_path):
    grid = ring()
    agreeing = with_fields(ring())
    dataset = imported(tmp_path, write(vtk.vtkXMLStructuredGridWriter(), tmp_path / "a.vts", agreeing))
    assert dataset.input["vertices"] == 13 * 4 * 3 and dataset.counts()["vertices"] == 12 * 4 * 3
    assert dataset.counts()["boundary_faces"] == 12 * 2 * 2 + 12 * 3 * 2 and "welded: 12 pairs" in dataset.notes

    dataset = imported(tmp_path, tmp_path / "a.vts", "--no-weld", "--force")
    assert dataset.counts()["vertices"] == 13 * 4 * 3

    add_array(grid.GetPointData(), "angle", [(i // 4) % 13 for i in range(13 * 4 * 3)])
    dataset = imported(tmp_path, write(vtk.vtkXMLStructuredGridWriter(), tmp_path / "b.vts", grid), "--force")
    assert dataset.counts()["vertices"] == 13 * 4 * 3 and "angle differs across the seam" in dataset.notes


def write_ring_series(folder, angles, moved=lambda step, data: data):
    """Writes the steps of an O-grid with a field. angles(step) returns its n + 1 values around the axis."""
    names = []
    for step in range(4):
        grid = moved(step, with_fields(ring()))
        add_array(grid.GetPointData(), "angle", [angles(step)[(i // 4) % 13] for i in range(grid.GetNumberOfPoints())])
        names.append(write(vtk.vtkXMLStructuredGridWriter(), folder / f"ring {step}.vts", grid).name)
    return write_pvd(folder / "a.pvd", [(step / 2, 0, name) for step, name in enumerate(names)])


def test_a_seam_whose_sides_differ_later_is_open_from_then_on(tmp_path):
    agreeing = np.append(np.arange(12), 0)
    torn = np.arange(13)
    dataset = imported(tmp_path, write_ring_series(tmp_path, lambda step: torn if step in (1, 2) else agreeing))
    assert [step.get("mesh", 0) for step in dataset.steps] == [0, 1, 1, 1]
    assert dataset.counts(0)["vertices"] == 12 * 4 * 3 and dataset.counts(1)["vertices"] == 13 * 4 * 3
    assert "From time 0.5 on angle differs across a seam" in dataset.notes
    for step in range(4):
        original = dataset.mesh(dataset.steps[step].get("mesh", 0))["original_vertex"][:]
        want = (torn if step in (1, 2) else agreeing)[(original // 4) % 13]
        np.testing.assert_array_equal(dataset.values("angle", step), want)


def test_a_seam_that_moves_apart_is_open_from_then_on(tmp_path):
    def opened(step, grid):
        for i in range(grid.GetNumberOfPoints()):
            x, y, z = grid.GetPoint(i)
            if step == 3 and (i // 4) % 13 == 12:
                grid.GetPoints().SetPoint(i, x, y - 0.1, z)
            else:
                grid.GetPoints().SetPoint(i, x + step, y, z)
        return grid

    dataset = imported(tmp_path, write_ring_series(tmp_path, lambda step: np.zeros(13), opened))
    assert [step.get("mesh", 0) for step in dataset.steps] == [0, 0, 0, 1]
    assert [step.get("coordinates", 0) for step in dataset.steps] == [0, 1, 2, 0]
    assert "From time 1.5 on position differs across a seam" in dataset.notes


def test_the_wake_cut_of_a_c_grid_is_welded(tmp_path):
    # i runs along the cut (y = 0, x from 4 to 1), around a nose, and back along the cut.
    n, grid, points = 13, vtk.vtkStructuredGrid(), vtk.vtkPoints()
    angles = np.linspace(0, 2 * np.pi, 7)
    path = [(4 - i, 0.0) for i in range(3)] + [(np.cos(a), np.sin(a)) for a in angles] + [(2 + i, 0.0) for i in range(3)]
    path[9] = path[3]
    away = [(0.0, 1.0)] * 3 + [(np.cos(a), np.sin(a)) for a in angles] + [(0.0, -1.0)] * 3
    away[3], away[9] = (0.3, 1.0), (0.3, -1.0)
    grid.SetDimensions(n, 3, 3)
    for k in range(3):
        for j in range(3):
            for (x, y), (u, v) in zip(path, away):
                points.InsertNextPoint(x + 0.5 * j * u, y + 0.5 * j * v, k)
    grid.SetPoints(points)
    dataset = imported(tmp_path, write(vtk.vtkXMLStructuredGridWriter(), tmp_path / "a.vts", grid))
    assert dataset.counts()["vertices"] == n * 9 - 4 * 3
    assert "welded: 12 pairs" in dataset.notes


def test_a_face_that_looks_inwards_is_named_in_the_notes(tmp_path):
    points = [*CUBE, *((x + 5, y, z) for x, y, z in CUBE)]
    points[14] = (5.05, 0.05, 0.45)  # a corner moved to the opposite side of its cell
    grid = unstructured([(vtk.VTK_HEXAHEDRON, list(range(8))), (vtk.VTK_HEXAHEDRON, list(range(8, 16)))], points)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    (note,) = dataset.facts["notes"]
    assert "inwards from the center of 1 cell (inverted face pyramids)" in note and "(first ids: 1)" in note
    assert dataset.counts()["cells"] == 2
    assert json.loads(ciel_info(dataset.path, "--json"))["notes"] == [note]
    assert note in ciel_info(dataset.path)


def test_a_face_of_three_cells_stays_boundary_and_is_told(tmp_path):
    above = [(x, y, z + 1) for x, y, z in CUBE[4:]]
    askew = [(x + 0.1, y, z + 1) for x, y, z in CUBE[4:]]
    cells = [list(range(8)), [4, 5, 6, 7, 8, 9, 10, 11], [4, 5, 6, 7, 12, 13, 14, 15]]
    grid = unstructured([(vtk.VTK_HEXAHEDRON, cell) for cell in cells], CUBE + above + askew)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    assert "1 face belongs to three or more cells and stays internal boundary" in dataset.notes
    assert dataset.counts()["cells"] == 3 and dataset.counts()["boundary_faces"] == 18


def test_a_folded_cell_is_kept_and_named(tmp_path):
    """A row of cells whose second one is inverted by the position of its neighbor."""
    grid, points = vtk.vtkStructuredGrid(), vtk.vtkPoints()
    grid.SetDimensions(5, 2, 2)
    for k in range(2):
        for j in range(2):
            for x in (0, 2, 1.9, 3, 4):
                points.InsertNextPoint(x, j, k)
    grid.SetPoints(points)
    dataset = imported(tmp_path, write(vtk.vtkXMLStructuredGridWriter(), tmp_path / "a.vts", grid))
    assert dataset.counts()["cells"] == 4 and dataset.counts()["components"] == 1
    assert "1 cell has negative volume and was kept (first ids: 1)" in dataset.notes


def test_blanked_cells_are_left_out(tmp_path):
    grid = image(3)
    ghosts = vtk.vtkUnsignedCharArray()
    ghosts.SetName("vtkGhostType")
    for i in range(8):
        ghosts.InsertNextValue(32 if i == 0 else 0)  # 32 is VTK's HIDDENCELL
    grid.GetCellData().AddArray(ghosts)
    dataset = imported(tmp_path, write(vtk.vtkXMLImageDataWriter(), tmp_path / "a.vti", grid))
    assert dataset.counts()["cells"] == 7 and "1 cell is blanked" in dataset.notes


def series_of(tmp_path, grids):
    for i, grid in enumerate(grids):
        write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / f"step {i}.vtu", grid)
    return [f"step {i}.vtu" for i in range(len(grids))]


def write_pvd(path, entries):
    rows = "".join(f'<DataSet timestep="{t}" part="{p}" file="{f}"/>' for t, p, f in entries)
    path.write_text(f'<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1"><Collection>{rows}</Collection></VTKFile>')
    return path


def test_pvd_series_with_a_missing_array_and_remeshing(tmp_path):
    lacking = mixed()
    add_array(lacking.GetCellData(), "c", np.arange(5))
    other = with_fields(unstructured([(vtk.VTK_HEXAHEDRON, list(range(8)))], CUBE))
    names = series_of(tmp_path, [with_fields(mixed()), lacking, other])
    dataset = imported(tmp_path, write_pvd(tmp_path / "a.pvd", [(0.5, 0, names[0]), (1, 0, names[1]), (2, 0, names[2])]))
    assert dataset.times == [0.5, 1, 2]
    assert [step.get("mesh", 0) for step in dataset.steps] == [0, 0, 1]
    assert "f" not in dataset.steps[1]["arrays"] and "cell:c" in dataset.steps[1]["arrays"]
    assert dataset.counts(1)["cells"] == 1


def test_a_moving_mesh_shares_its_topology(tmp_path):
    moved = mixed()
    for i in range(moved.GetNumberOfPoints()):
        x, y, z = moved.GetPoint(i)
        moved.GetPoints().SetPoint(i, x + 0.25, y, 2 * z)
    names = series_of(tmp_path, [with_fields(mixed()), with_fields(moved), with_fields(mixed())])
    text = {"file-series-version": "1.0", "files": [{"name": n, "time": t} for t, n in enumerate(names)]}
    (tmp_path / "a.vtu.series").write_text(json.dumps(text))
    dataset = imported(tmp_path, tmp_path / "a.vtu.series")
    assert [step.get("mesh", 0) for step in dataset.steps] == [0, 0, 0]
    assert [step.get("coordinates", 0) for step in dataset.steps][:2] == [0, 1]
    first, second = dataset.positions(), dataset.positions(coordinates=1)
    np.testing.assert_allclose(second, first * [1, 1, 2] + [0.25, 0, 0], atol=1e-6)
    np.testing.assert_allclose(dataset.values("f", 1), linear(second), atol=1e-5)


def test_pvd_parts_of_one_time_are_joined(tmp_path):
    beside = unstructured([(vtk.VTK_HEXAHEDRON, list(range(8)))], [(x - 1, y, z) for x, y, z in CUBE])
    names = series_of(tmp_path, [with_fields(beside), with_fields(mixed())])
    dataset = imported(tmp_path, write_pvd(tmp_path / "a.pvd", [(3, 0, names[0]), (3, 1, names[1])]))
    assert dataset.times == [3] and dataset.counts()["cells"] == 6 and dataset.counts()["components"] == 1


def test_a_cell_that_two_parts_have_is_there_once(tmp_path):
    """The second part contains a copy of a cell without a ghost marker."""
    names = series_of(tmp_path, [with_fields(unstructured([(vtk.VTK_HEXAHEDRON, list(range(8)))], CUBE)), with_fields(mixed())])
    dataset = imported(tmp_path, write_pvd(tmp_path / "a.pvd", [(3, 0, names[0]), (3, 1, names[1])]))
    assert dataset.counts()["cells"] == 5 and "the same faces as an earlier cell" in dataset.notes


def test_several_inputs_are_parts_of_one_mesh(tmp_path):
    names = series_of(tmp_path, [with_fields(mixed()), with_fields(mixed())])
    dataset = imported(tmp_path, *(tmp_path / n for n in names))
    assert dataset.counts()["cells"] == 10 and dataset.times == [0]


def test_array_selects_and_refuses(tmp_path):
    file = write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", with_fields(mixed()))
    assert imported(tmp_path, file, "--array", "f").array_names() == ["f"]
    assert imported(tmp_path, file, "--force", "--array", "c").array_names() == ["c", "cell:c"]
    assert imported(tmp_path, file, "--force", "--array", "cell:c").array_names() == ["cell:c"]
    done = run_import(file, "-o", tmp_path / "b.ciel", "--array", "nope")
    assert done.returncode == 1 and "no array \"nope\"; there are: c, cell:c, f, v" in done.stderr
    assert not (tmp_path / "b.ciel").exists()


def test_list_prints_and_writes_nothing(tmp_path):
    file = write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", with_fields(mixed()))
    before = sorted(tmp_path.iterdir())
    done = run_import("--list", file)
    assert done.returncode == 0, done.stderr
    assert "16 points, 5 cells" in done.stdout and "array   v: points, 3 components" in done.stdout
    assert sorted(tmp_path.iterdir()) == before


def test_exodus(tmp_path):
    source = multi_block(("hexes", with_fields(unstructured([(vtk.VTK_HEXAHEDRON, list(range(8)))], CUBE))))
    writer = vtk.vtkExodusIIWriter()
    writer.WriteAllTimeStepsOn()
    file = write(writer, tmp_path / "a.ex2", source)
    dataset = imported(tmp_path, file)
    assert dataset.counts()["cells"] == 1 and dataset.input["vertices"] == 8
    check_fields(dataset)


def write_ensight(folder, polyhedra):
    """Writes two steps of a cube, as a hexahedron or a polyhedron of six faces, in EnSight Gold's text form."""
    (folder / "a.case").write_text(
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\nVARIABLE\nscalar per node: 1 f a.f*\n"
        "TIME\ntime set: 1\nnumber of steps: 2\nfilename start number: 0\nfilename increment: 1\ntime values: 0.5 1.5\n"
    )
    column = lambda values: "".join(f"{v:12.5e}\n" for v in values)
    coordinates = column(np.array(CUBE).T.ravel())
    if polyhedra:
        rows = "".join("".join(f"{n + 1:10d}" for n in face) + "\n" for face in CUBE_FACES)
        cells = "nfaced\n         1\n         6\n" + "         4\n" * 6 + rows
    else:
        cells = "hexa8\n         1\n" + "".join(f"{n:10d}" for n in range(1, 9)) + "\n"
    (folder / "a.geo").write_text(
        "a\ncube\nnode id assign\nelement id assign\npart\n         1\ncube\ncoordinates\n         8\n" + coordinates + cells
    )
    for step in range(2):
        (folder / f"a.f{step}").write_text("f\npart\n         1\ncoordinates\n" + column(linear(CUBE) + step))
    return folder / "a.case"


@pytest.mark.parametrize("polyhedra", (False, True))
def test_ensight_gold(tmp_path, polyhedra):
    dataset = imported(tmp_path, write_ensight(tmp_path, polyhedra))
    assert dataset.cells() == {"hexahedron": 1}
    assert dataset.times == [0.5, 1.5] and dataset.volume() == pytest.approx(1)
    np.testing.assert_allclose(dataset.values("f", 1), linear(dataset.positions()) + 1, atol=1e-4)


def test_vtkhdf(tmp_path):
    h5py = pytest.importorskip("h5py", reason="python3-h5py is not installed")
    with h5py.File(tmp_path / "a.hdf", "w") as file:
        group = file.create_group("VTKHDF", track_order=True)
        group.attrs["Version"] = [1, 0]
        group.attrs.create("Type", b"UnstructuredGrid", dtype=h5py.string_dtype("ascii", 16))
        for name, values in {
            "NumberOfPoints": [8], "NumberOfCells": [1], "NumberOfConnectivityIds": [8],
            "Connectivity": list(range(8)), "Offsets": [0, 8],
        }.items():
            group.create_dataset(name, data=np.array(values, dtype="i8"))
        group.create_dataset("Points", data=np.array(CUBE, dtype="f4"))
        group.create_dataset("Types", data=np.array([12], dtype="u1"))
        group.create_group("PointData").create_dataset("f", data=linear(CUBE).astype("f4"))
    dataset = imported(tmp_path, tmp_path / "a.hdf")
    assert dataset.cells() == {"hexahedron": 1}
    np.testing.assert_allclose(dataset.values("f"), linear(dataset.positions()), atol=1e-5)


def test_tecplot(tmp_path):
    rows = "\n".join(f"{x} {y} {z} {f}" for (x, y, z), f in zip(CUBE, linear(CUBE)))
    (tmp_path / "a.tec").write_text(
        'TITLE = "a"\nVARIABLES = "X", "Y", "Z", "f"\n'
        'ZONE T="cube", N=8, E=1, F=FEPOINT, ET=BRICK\n' + rows + "\n1 2 3 4 5 6 7 8\n"
    )
    dataset = imported(tmp_path, tmp_path / "a.tec")
    assert dataset.cells() == {"hexahedron": 1}
    np.testing.assert_allclose(dataset.values("f"), linear(dataset.positions()), atol=1e-5)


def test_fluent(tmp_path):
    """A cube of one hexahedron with walls around it, in Fluent's text form."""
    nodes = "\n".join(" ".join(str(float(c)) for c in p) for p in CUBE)
    loops = [[1, 2, 3, 4], [5, 8, 7, 6], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 8, 4], [4, 8, 5, 1]]
    faces = "\n".join("4 " + " ".join(format(n, "x") for n in loop) + " 1 0" for loop in loops)
    (tmp_path / "a.cas").write_text(
        '(0 "cube")\n(2 3)\n(10 (0 1 8 0 3))\n(10 (1 1 8 1 3)(\n' + nodes + "\n))\n(12 (0 1 1 0))\n"
        "(12 (2 1 1 1 4))\n(13 (0 1 6 0))\n(13 (3 1 6 3 0)(\n" + faces + "\n))\n(45 (2 fluid fluid)())\n(45 (3 wall wall)())\n"
    )
    done = run_import(tmp_path / "a.cas", "-o", tmp_path / "out.ciel")
    assert done.returncode == 1 and "Could not open data file" in done.stderr
    (tmp_path / "a.dat").write_text('(0 "no data")\n')
    dataset = imported(tmp_path, tmp_path / "a.cas")
    assert dataset.counts()["cells"] == 1 and abs(dataset.volume()) == pytest.approx(1)
