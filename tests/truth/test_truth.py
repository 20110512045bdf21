"""Datasets of every format against VTK's own readers: points, cells and values of all steps. Faces are compared through the
points of their cells."""

import os
import pathlib
import shutil
import tarfile

import numpy as np
import pytest
import vtk
from import_support import imported
from openfoam_files import N, write_case, write_decomposed
from openfoam_rewriting import as_binary, compressed
from stored_blocks import cells_of, read_blocks
from test_import_cgns import CELL_CENTER, STRUCTURED, VERTEX, Writer, hexahedra
from test_import_exodus import on_side, write_exodus
from test_import_formats import CUBE, WRITTEN, multi_block, unstructured, write_ensight
from vtk.util.numpy_support import vtk_to_numpy
from vtk_files import linear, with_fields, write
from vtk_reading import Truth, reader_of

DATA = pathlib.Path(os.environ.get("CIEL_DATA") or "/nowhere")
MOST_CELLS = 20_000  # corners are compared in datasets of at most this many cells; values are always compared


def corner_points(dataset, mesh=0):
    """Maps each stored cell to the ids of its points in the input."""
    m = dataset.mesh(mesh)
    original = m["original_vertex"][:]
    corners = [set() for _ in range(m["cell_types"].shape[0])]
    for block in read_blocks(pathlib.Path(dataset.path) / f"meshes/{mesh}/blocks")[2]:
        if block.first_cell < MOST_CELLS:
            for cell, _, faces in cells_of(block):
                corners[cell].update(original[np.concatenate(faces)])
    return corners


def check_mesh(dataset, truth, quadratic=False):
    m = dataset.mesh()
    cell, vertex = m["original_cell"][:], m["original_vertex"][:]
    assert len(cell) == len(set(cell)) == dataset.counts()["cells"] and cell.max() < truth.cell_count()
    box = np.ptp(truth.points, axis=0).max()
    np.testing.assert_allclose(dataset.positions(), truth.points[vertex], atol=2e-7 * box + 1e-6 * np.abs(truth.points).max())
    for stored, corners in enumerate(corner_points(dataset)[:MOST_CELLS]):
        expected = truth.corners(int(cell[stored]))
        assert corners <= expected if quadratic else corners == expected, f"cell {cell[stored]}"


def check_values(dataset, truth, step, all_cells=True):
    m = dataset.mesh(dataset.steps[step].get("mesh", 0))
    points, cells = truth.fields("Point"), truth.fields("Cell")
    assert set(points) | {f"cell:{name}" for name in cells} <= set(dataset.steps[step]["arrays"])
    for prefix, fields, ids in (("", points, m["original_vertex"][:]), ("cell:", cells, m["original_cell"][:])):
        for name, values in fields.items():
            stored = dataset.values(prefix + name, step)
            # VTK's OpenFOAM reader has floats, whatever the file has.
            stored = stored.reshape(len(stored), -1).astype(values.dtype)
            np.testing.assert_array_equal(stored, values[ids], err_msg=f"{prefix}{name}")


def check(dataset, reader, times=(None,)):
    assert len(dataset.times) == len(times)
    for step, time in enumerate(times):
        truth = Truth(reader, time)
        if step == 0:
            check_mesh(dataset, truth)
            assert dataset.counts()["cells"] == truth.cell_count()
        check_values(dataset, truth, step)


READERS = {
    ".vtu": "vtkXMLUnstructuredGridReader", ".pvtu": "vtkXMLPUnstructuredGridReader", ".vts": "vtkXMLStructuredGridReader",
    ".pvts": "vtkXMLPStructuredGridReader", ".vtr": "vtkXMLRectilinearGridReader", ".vti": "vtkXMLImageDataReader",
    ".vtk": "vtkDataSetReader", ".vtm": "vtkXMLMultiBlockDataReader", ".ex2": "vtkExodusIIReader", ".case": "vtkEnSightGoldReader",
}


@pytest.mark.parametrize("file, data, writer, settings", [row[1:] for row in WRITTEN], ids=[row[0] for row in WRITTEN])
def test_vtk_files(tmp_path, file, data, writer, settings):
    settings = {**settings, **({"SetNumberOfPieces": 1} if file.endswith(".pvtu") else {})}
    path = write(writer(), tmp_path / file, with_fields(data()), **settings)
    kind = "vtkXMLUnstructuredGridReader" if "XMLUnstructured" in writer.__name__ else READERS[path.suffix]
    check(imported(tmp_path, path), reader_of(kind, path))


def test_multi_block(tmp_path):
    data = multi_block(*((name, with_fields(unstructured([(vtk.VTK_HEXAHEDRON, list(range(8)))], np.array(CUBE) + shift), shift))
                         for name, shift in (("a", 0), ("b", 3))))
    path = write(vtk.vtkXMLMultiBlockDataWriter(), tmp_path / "a.vtm", data)
    check(imported(tmp_path, path), reader_of(READERS[".vtm"], path))


@pytest.mark.parametrize("polyhedra", (False, True))
def test_ensight(tmp_path, polyhedra):
    path = write_ensight(tmp_path, polyhedra)
    reader = vtk.vtkEnSightGoldReader()
    reader.SetFilePath(str(tmp_path))
    reader.SetCaseFileName(path.name)
    check(imported(tmp_path, path), reader, (0.5, 1.5))


def test_exodus(tmp_path):
    points, cells = hexahedra(3)
    centers = points[cells].mean(axis=1)
    path = write_exodus(tmp_path / "a.exo", {"left": cells[:12], "right": cells[12:]}, points, "HEX8",
                        {"inlet": on_side(centers, 0, 0)}, {"core": (np.arange(1, 4), None)},
                        nodal=lambda step: linear(points) + step, element=lambda step: linear(centers) + 10 * step, times=(0.25, 0.75))
    reader = reader_of("vtkExodusIIReader", path)
    reader.UpdateInformation()
    reader.SetAllArrayStatus(vtk.vtkExodusIIReader.NODAL, 1)
    reader.SetAllArrayStatus(vtk.vtkExodusIIReader.ELEM_BLOCK, 1)
    reader.GenerateObjectIdCellArrayOff()
    reader.GenerateGlobalElementIdArrayOff()
    reader.GenerateGlobalNodeIdArrayOff()
    check(imported(tmp_path, path), reader, (0.25, 0.75))


def test_cgns(tmp_path):
    points, cells = hexahedra(3)
    writer = Writer(tmp_path / "a.cgns")
    writer.zone("box", STRUCTURED, 3 * [4] + 3 * [3] + 3 * [0], points)
    writer.solution("Nodes", VERTEX, f=linear(points))
    writer.solution("Cells", CELL_CENTER, c=linear(points[cells].mean(axis=1)))
    path = writer.close()
    reader = reader_of("vtkCGNSReader", path)
    reader.UpdateInformation()
    reader.EnableAllBases()
    reader.EnableAllPointArrays()
    reader.EnableAllCellArrays()
    check(imported(tmp_path, path), reader)


def foam_reader(case, is_decomposed=False):
    reader = vtk.vtkPOpenFOAMReader()
    reader.SetFileName(str(case / "case.foam"))
    reader.SetCaseType(int(not is_decomposed))
    reader.SetController(vtk.vtkDummyController())
    reader.SetDecomposePolyhedra(0)
    reader.SetCreateCellToPoint(0)
    reader.UpdateInformation()
    reader.EnableAllCellArrays()
    reader.EnableAllPatchArrays()
    return reader


def patches_of(tree):
    """Yields (name, {array: rows}) for each patch of VTK's reader."""
    for i in range(tree.GetNumberOfBlocks()):
        block, name = tree.GetBlock(i), tree.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME())
        if name == "boundary":
            for k in range(block.GetNumberOfBlocks()):
                data = block.GetBlock(k).GetCellData()
                arrays = {data.GetArrayName(a): vtk_to_numpy(data.GetArray(a)) for a in range(data.GetNumberOfArrays())}
                yield block.GetMetaData(k).Get(vtk.vtkCompositeDataSet.NAME()), arrays
        elif block is not None and block.IsA("vtkMultiBlockDataSet"):
            yield from patches_of(block)


def check_patches(dataset, reader, step):
    """Compares the values of each patch's faces, in any order. VTK also has values for empty patches."""
    groups, compared = dataset.groups(), 0
    for name, arrays in patches_of(reader.GetOutputDataObject(0)):
        for array in set(arrays) & {key.removeprefix("patch:") for key in dataset.steps[step]["arrays"]}:
            stored = dataset.values(f"patch:{array}", step)[groups[name]]
            if np.all(np.isnan(stored)) or len(arrays[array]) == 0:
                continue
            rows = [np.reshape(values.astype(np.float32), (len(values), -1)) for values in (stored, arrays[array])]
            ours, theirs = (values[np.lexsort(values.T)] for values in rows)
            np.testing.assert_array_equal(ours, theirs, err_msg=f"{array} on {name}")
            compared += 1
    assert compared > 0


@pytest.mark.parametrize("form", ("text", "binary", "binary of 32 bits", "compressed"))
def test_openfoam(tmp_path, form):
    case = write_case(tmp_path / "case")
    if form.startswith("binary"):
        as_binary(case, 32, 32 if form.endswith("bits") else 64)
    if form == "compressed":
        compressed(case)
    dataset = imported(tmp_path, case)
    reader = foam_reader(case)
    check(dataset, reader, (1, 2))
    check_patches(dataset, reader, 1)
    assert {name: len(faces) for name, faces in dataset.groups().items()} == {"inlet": 16, "outlet": 16, "walls": 64}


def test_openfoam_decomposed(tmp_path):
    case = tmp_path / "case"
    write_decomposed(case, [(c % N >= N // 2) + 2 * (c // (N * N) >= N // 2) for c in range(N**3)], {})
    check(imported(tmp_path, case, "--no-weld"), foam_reader(case, is_decomposed=True), (1, 2))


@pytest.mark.parametrize("name, times", [("motorBike", (100, 160, 200)), ("sphere_polyhedra", (1.6, 3.2, 4.8, 6.4, 8))])
def test_openfoam_cases(tmp_path, name, times):
    archive = DATA / f"{name}.tar.xz"
    if not archive.is_file():
        pytest.skip("CIEL_DATA does not name the folder with the real datasets")
    with tarfile.open(archive) as files:
        files.extractall(tmp_path)
    dataset, reader = imported(tmp_path, tmp_path / name), foam_reader(tmp_path / name)
    check(dataset, reader, times)
    check_patches(dataset, reader, len(times) - 1)


@pytest.mark.parametrize("name, solution", [("bluntfin", True), ("post", True)])
def test_plot3d(tmp_path, name, solution):
    if not (DATA / "nasa").is_dir():
        pytest.skip("CIEL_DATA does not name the folder with the real datasets")
    files = [shutil.copy(DATA / f"nasa/{name}{part}.bin", tmp_path) for part in ("xyz", "q")]
    reader = vtk.vtkMultiBlockPLOT3DReader()
    reader.SetAutoDetectFormat(1)
    reader.SetXYZFileName(files[0])
    reader.SetQFileName(files[1])
    dataset = imported(tmp_path, *files, "--no-weld")
    truth = Truth(reader)
    check_mesh(dataset, truth)
    check_values(dataset, truth, 0)
