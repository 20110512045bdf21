"""Imported arrays: the solver's ids, names of tensor components, derived and interpolated values, types, files."""

import json

import numpy as np
import pytest
import vtk
from import_support import ciel_info, imported, run_import
from openfoam_block import Block, listed
from openfoam_files import CENTERS, header, write_decomposed
from program import ciel
from test_import_plot3d import write_pair
from vtk_files import CUBE, add_array, hexahedra, unstructured, with_fields, write

HEXAHEDRON = [(vtk.VTK_HEXAHEDRON, list(range(8)))]


def ids_of(name, values, text=False):
    array = vtk.vtkStringArray() if text else vtk.vtkIdTypeArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    return array


def cubes(n):
    points, cells = hexahedra(n)
    return unstructured([(vtk.VTK_HEXAHEDRON, [int(node) for node in cell]) for cell in cells], points)


def arrays_of(dataset):
    return {array["name"]: array for array in json.loads(ciel_info(dataset.path, "--json"))["arrays"]}


# Ids of points and cells.


def test_global_ids_are_the_solvers_and_no_array(tmp_path):
    grid = with_fields(cubes(2))
    nodes, cells = np.arange(27) * 10 + 2**33, np.arange(8)[::-1]
    grid.GetPointData().SetGlobalIds(ids_of("node numbers", nodes))
    grid.GetCellData().AddArray(ids_of("GlobalElementId", cells))
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    mesh = dataset.mesh()
    np.testing.assert_array_equal(mesh["solver_vertex"][:], nodes[mesh["original_vertex"][:]])
    np.testing.assert_array_equal(mesh["solver_cell"][:], cells[mesh["original_cell"][:]])
    assert dataset.array_names() == ["c", "cell:c", "f", "v"] and "ids" not in dataset.notes
    assert json.loads(ciel_info(dataset.path, "--json"))["solver_ids"] == ["vertices", "cells"]


def test_pedigree_ids_serve_where_there_are_no_global_ones_and_text_is_a_note(tmp_path):
    grid = with_fields(unstructured(HEXAHEDRON, CUBE))
    grid.GetPointData().SetPedigreeIds(ids_of("nodes", range(100, 108)))
    grid.GetCellData().AddArray(ids_of("names", ["first"], text=True))
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    assert sorted(dataset.mesh()["solver_vertex"][:]) == list(range(100, 108))
    assert "solver_cell" not in dataset.mesh() and "Arrays of text were left out: names." in dataset.notes


def test_a_decomposed_case_has_the_numbers_of_the_whole_one(tmp_path):
    processor_of_cell = (CENTERS[:, 0] > 0.5).astype(int)
    write_decomposed(tmp_path / "case", processor_of_cell, {})
    for rank in (0, 1):
        own = np.flatnonzero(processor_of_cell == rank)
        file = tmp_path / f"case/processor{rank}/constant/polyMesh/cellProcAddressing"
        file.write_text(header("labelList", "cellProcAddressing") + f"{len(own)}\n(\n" + "\n".join(map(str, own)) + "\n)\n")
    dataset = imported(tmp_path, tmp_path / "case")
    mesh = dataset.mesh()
    running = np.concatenate([np.flatnonzero(processor_of_cell == rank) for rank in (0, 1)])
    np.testing.assert_array_equal(mesh["solver_cell"][:], running[mesh["original_cell"][:]])


def test_appending_keeps_the_order_of_the_file_whatever_the_ids(tmp_path):
    grid = with_fields(cubes(2))
    grid.GetPointData().SetGlobalIds(ids_of("ids", range(26, -1, -1)))
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    np.save(tmp_path / "f.npy", np.arange(27, dtype=np.float32))
    assert ciel("append", dataset.path, "--time", "1", "--array", f"f={tmp_path / 'f.npy'}").returncode == 0
    after = type(dataset)(dataset.path)
    np.testing.assert_array_equal(after.values("f", 1), after.mesh()["original_vertex"][:])


# Tensor components.

SYMMETRIC = ["XX", "XY", "XZ", "YY", "YZ", "ZZ"]


def test_named_components_and_tensor_attributes_are_tensors_and_others_are_not(tmp_path):
    grid = unstructured(HEXAHEDRON, CUBE)
    point = grid.GetPointData()
    add_array(point, "named", np.arange(48.0).reshape(8, 6))
    for i, name in enumerate(SYMMETRIC):
        point.GetArray("named").SetComponentName(i, name)
    add_array(point, "plain", np.arange(48.0).reshape(8, 6))
    add_array(point, "attribute", np.arange(72.0).reshape(8, 9))
    point.SetActiveTensors("attribute")
    arrays = arrays_of(imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid)))
    assert arrays["named"]["component_names"] == [name.lower() for name in SYMMETRIC]
    assert arrays["plain"]["component_names"] == []
    assert arrays["attribute"]["component_names"] == ["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"]
    last = np.arange(42.0, 48.0)
    frobenius = np.sqrt((last**2 * [1, 2, 2, 1, 2, 1]).sum())
    assert arrays["named"]["range"][1] == pytest.approx(frobenius, rel=1e-6)
    assert arrays["plain"]["range"] == [0, 47], "no magnitude: of all components"


def test_openfoams_tensors_have_the_order_of_their_class(tmp_path):
    block = Block((2, 1, 1))
    case = block.write(tmp_path / "case", {"p": (np.zeros(2), {side: "type zeroGradient;" for side in block.types})})
    rows = "\n".join(f"({' '.join(str(10 * cell + c) for c in range(6))})" for cell in (0, 1))
    (case / "1/R").write_text(
        header("volSymmTensorField", "R")
        + f"dimensions [0 2 -2 0 0 0 0];\ninternalField nonuniform List<symmTensor>\n2\n(\n{rows}\n);\n"
        + "boundaryField { \".*\" { type zeroGradient; } }\n"
    )
    dataset = imported(tmp_path, case)
    assert dataset.array("cell:R").attrs["ciel"]["component_names"] == [name.lower() for name in SYMMETRIC]
    slice_by = lambda color: ciel("extract", dataset.path, "--slice", "x=0.4", "--color", color, "-o", tmp_path / "a.vtp")
    assert slice_by("cell:R:yy").returncode == 0
    refused = slice_by("R:3")
    assert refused.returncode != 0 and "R:magnitude, R:xx, R:xy, R:xz, R:yy, R:yz, R:zz" in refused.stderr


def test_ensights_tensors_keep_the_order_of_the_file(tmp_path):
    (tmp_path / "a.case").write_text(
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\nVARIABLE\ntensor symm per node: s a.s\n"
    )
    coordinates = "\n".join(f"{point[axis]:12.5e}" for axis in range(3) for point in CUBE)
    (tmp_path / "a.geo").write_text(
        "d\nd\nnode id off\nelement id off\npart\n         1\nblock\ncoordinates\n         8\n"
        f"{coordinates}\nhexa8\n         1\n" + "".join(f"{i + 1:10d}" for i in range(8)) + "\n"
    )
    rows = "\n".join(f"{10.0 * component + node:12.5e}" for component in range(6) for node in range(8))
    (tmp_path / "a.s").write_text(f"d\npart\n         1\ncoordinates\n{rows}\n")
    dataset = imported(tmp_path, tmp_path / "a.case")
    names = dataset.array("s").attrs["ciel"].get("component_names", [])
    own = dataset.values("s")[np.argsort(dataset.mesh()["original_vertex"][:])][0]
    by_name = dict(zip(names, own))
    # Order in EnSight Gold: 11, 22, 33, 12, 13, 23.
    assert {name: by_name[name] for name in ("xx", "yy", "zz", "xy", "xz", "yz")} == {
        "xx": 0, "yy": 10, "zz": 20, "xy": 30, "xz": 40, "yz": 50
    }


# Files and readers that arrays come from.


def test_what_plot3ds_reader_computes_is_derived(tmp_path):
    arrays = arrays_of(imported(tmp_path, *write_pair(tmp_path)))
    assert {name: array["origin"] for name, array in arrays.items()} == {
        "Density": "original", "Momentum": "original", "StagnationEnergy": "original", "Pressure": "derived", "Velocity": "derived",
    }
    assert arrays["Density"]["file"] == "grid.q" and arrays["Density"]["type"] == "float32"


def test_info_says_where_each_array_comes_from(tmp_path):
    grid = with_fields(cubes(2))
    counts = ids_of("n", range(8))
    grid.GetCellData().AddArray(counts)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    arrays = arrays_of(dataset)
    assert arrays["f"]["origin"] == arrays["cell:c"]["origin"] == "original" and arrays["c"]["origin"] == "interpolated"
    assert arrays["f"]["type"] == "float64" and arrays["cell:n"]["type"] == "int64" and arrays["f"]["file"] == "a.vtu"
    assert "interpolated float64 from a.vtu" in ciel_info(dataset.path)


def test_a_field_of_a_decomposed_case_names_the_files_of_all_processors(tmp_path):
    write_decomposed(tmp_path / "case", (CENTERS[:, 0] > 0.5).astype(int), {})
    arrays = arrays_of(imported(tmp_path, tmp_path / "case"))
    assert arrays["cell:p"]["file"].startswith("processor*/") and arrays["cell:p"]["file"].endswith("/p")


# Values on patches.


def test_the_values_of_patches_are_stored_face_by_face(tmp_path):
    block = Block((3, 2, 2), {"left": "patch"})
    on_left = np.array([1.0, 2.0, 3.0, 4.0])
    entries = {side: "type zeroGradient;" for side in block.types} | {"left": f"type fixedValue; {listed(on_left)}"}
    dataset = imported(tmp_path, block.write(tmp_path / "case", {"T": (block.centers()[:, 0], entries)}))
    mesh = dataset.mesh()
    assert np.all(mesh["faces/neighbour"][:] == 2**32 - 1)
    values = dict(enumerate(dataset.values("patch:T")))
    left = dataset.groups()["left"]
    assert sorted(values[face] for face in left) == list(on_left)
    offset, vertex, at = mesh["faces/face_offset"][:], mesh["faces/face_vertex"][:], dataset.positions()
    center = {face: at[vertex[offset[face] : offset[face + 1]]].mean(axis=0) for face in left}
    for value, expected in zip(on_left, block.face_centers("left")):
        assert any(values[face] == value and np.allclose(center[face], expected) for face in left)
    right = dataset.groups()["right"]
    assert np.allclose([values[face] for face in right], 5 / 6), "what the cells behind have"


def test_patches_that_are_empty_have_no_values(tmp_path):
    block = Block((2, 2, 1), {"bottom": "empty", "top": "empty"})
    entries = {side: "type empty;" if side in ("bottom", "top") else "type zeroGradient;" for side in block.types}
    dataset = imported(tmp_path, block.write(tmp_path / "case", {"T": (np.ones(4), entries)}))
    values = dataset.values("patch:T").view(np.uint64)
    assert np.count_nonzero(values == 0x7FF819C3C0000000) == 8, "the no-value of store/no_value.hpp"


# Invalid values, and arrays that differ between steps.


def series(folder, steps):
    """`steps`: {time: {array: values at the points of a cube of 2 x 2 x 2 cells}}."""
    rows = ""
    for time, arrays in steps.items():
        grid = cubes(2)
        for name, values in arrays.items():
            add_array(grid.GetPointData(), name, values)
        write(vtk.vtkXMLUnstructuredGridWriter(), folder / f"s{time}.vtu", grid)
        rows += f'<DataSet timestep="{time}" file="s{time}.vtu"/>'
    (folder / "a.pvd").write_text(f'<VTKFile type="Collection"><Collection>{rows}</Collection></VTKFile>')
    return folder / "a.pvd"


SCALARS, VECTORS = np.arange(27.0), np.ones((27, 3))


@pytest.mark.parametrize("bad", [0, 2])
def test_components_that_differ_at_one_step_cost_that_array_there(tmp_path, bad):
    steps = {time: {"p": VECTORS if time == bad else SCALARS, "q": SCALARS} for time in range(3)}
    dataset = imported(tmp_path, series(tmp_path, steps), code=3)
    assert dataset.times == [0, 1, 2] and dataset.array("p").attrs["ciel"]["components"] == 1
    assert [step["arrays"].keys() >= {"q"} for step in dataset.steps] == [True] * 3
    assert [("p" in step["arrays"]) for step in dataset.steps] == [time != bad for time in range(3)]
    assert f"The array p has 3 components at time {bad} and 1 component at other times: it was left out at that time." in dataset.notes


def blown_up(folder, value, writer, name):
    """Imports 27 cubes whose middle one has `value`. Returns the dataset and a function that counts extracted polygons."""
    grid = cubes(3)
    cells = np.array([grid.GetCell(i).GetBounds()[0] for i in range(27)])
    cells[13] = value
    add_array(grid.GetCellData(), "p", cells)
    dataset = imported(folder, write(writer, folder / name, grid))
    count = lambda *what: int(ciel("extract", dataset.path, *what, "-o", folder / "a.vtp", check=True).stdout.split()[2])
    return dataset, count


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_a_cell_that_blew_up_is_the_only_one_that_is_missing(tmp_path, value):
    (tmp_path / "sound").mkdir()
    (tmp_path / "bad").mkdir()
    writer = vtk.vtkXMLUnstructuredGridWriter
    _, whole = blown_up(tmp_path / "sound", 1 / 3, writer(), "a.vtu")
    dataset, count = blown_up(tmp_path / "bad", value, writer(), "a.vtu")
    for what in (["--iso", "p=0.3"], ["--slice", "x=0.5", "--color", "p"], ["--slice", "x=0.5", "--color", "cell:p"]):
        assert count(*what) == whole(*what) - 1
    told = ciel("extract", dataset.path, "--iso", "p=0.3", "-o", tmp_path / "a.vtp").stderr
    assert told == "ciel: 1 cell has no number for p at this time and is left out\n"
    assert np.all(np.isfinite(dataset.values("p"))), "its neighbours are drawn from finite values"
    assert arrays_of(dataset)["cell:p"]["invalid"] == 1


@pytest.mark.parametrize("text", ["nan", "-nan", "inf", "-Inf", "Infinity"])
def test_words_for_no_number_are_values_in_legacy_files(tmp_path, text):
    grid = cubes(2)
    add_array(grid.GetCellData(), "p", np.arange(8.0) + 0.5)
    file = write(vtk.vtkUnstructuredGridWriter(), tmp_path / "a.vtk", grid)
    assert "3.5" in file.read_text()
    file.write_text(file.read_text().replace("3.5", text))
    dataset = imported(tmp_path, file)
    cells = dataset.values("cell:p")[np.argsort(dataset.mesh()["original_cell"][:])]
    np.testing.assert_array_equal(cells, [0.5, 1.5, 2.5, float(text), 4.5, 5.5, 6.5, 7.5])


def test_words_for_no_number_are_values_in_xml_files(tmp_path):
    grid = cubes(2)
    add_array(grid.GetCellData(), "p", np.arange(8.0) + 0.5)
    file = write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid, SetDataMode=vtk.vtkXMLWriter.Ascii)
    file.write_text(file.read_text().replace("3.5", "nan").replace("4.5", "inf"))
    dataset = imported(tmp_path, file)
    cells = dataset.values("cell:p")[np.argsort(dataset.mesh()["original_cell"][:])]
    np.testing.assert_array_equal(cells, [0.5, 1.5, 2.5, np.nan, np.inf, 5.5, 6.5, 7.5])


# Extremes of cell values.


def test_the_extremes_of_cells_are_told(tmp_path):
    grid = cubes(3)
    values = np.linspace(0, 1, 27)
    values[13], values[4] = 63.6, -7
    add_array(grid.GetCellData(), "k", values)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    extremes = arrays_of(dataset)["cell:k"]["extremes"]
    assert extremes["highest"]["cell"] == 13 and extremes["highest"]["value"] == pytest.approx(63.6)
    np.testing.assert_allclose(extremes["highest"]["place"], [0.5, 0.5, 0.5], atol=1e-6)
    assert extremes["lowest"]["cell"] == 4 and extremes["lowest"]["value"] == -7
    assert arrays_of(dataset)["k"]["extremes"] == extremes, "of what it was made from"
    assert "highest 63.6 in cell 13 at (0.5, 0.5, 0.5), time 0" in ciel_info(dataset.path)
    flat = ciel("extract", dataset.path, "--slice", "z=0.4", "--color", "cell:k", "-o", tmp_path / "a.vtp", check=True)
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "a.vtp"))
    reader.Update()
    assert flat.returncode == 0 and reader.GetOutput().GetPointData().GetArray("cell:k").GetRange()[1] == pytest.approx(63.6)


def test_nothing_is_written_where_every_step_is_bad(tmp_path):
    (tmp_path / "a.pvd").write_text('<VTKFile type="Collection"><Collection><DataSet timestep="0" file="b.vtu"/></Collection></VTKFile>')
    (tmp_path / "b.vtu").write_text("<VTKFile")
    assert run_import(tmp_path / "a.pvd", "-o", tmp_path / "out.ciel").returncode == 1
    assert not (tmp_path / "out.ciel").exists()
