"""Steps, blocks or files that disagree about an array, and missing values: which data is imported, and the notes on losses."""

import json

import numpy as np
import pytest
import vtk
from import_support import ciel_info, imported, run_import
from openfoam_block import Block
from openfoam_files import CENTERS, field, header, write_decomposed
from program import ciel
from test_import_arrays import arrays_of, cubes, ids_of
from vtk_files import add_array, multi_block, write

ORDERS = (["XX", "YY", "ZZ", "XY", "YZ", "XZ"], ["XX", "XY", "XZ", "YY", "YZ", "ZZ"])
TENSOR = {"XX": 1, "YY": 2, "ZZ": 3, "XY": 4, "YZ": 5, "XZ": 6}


def with_tensor(order, n=2, shift=0.0):
    grid = cubes(n)
    if shift:
        points = grid.GetPoints()
        for i in range(points.GetNumberOfPoints()):
            x, y, z = points.GetPoint(i)
            points.SetPoint(i, x + shift, y, z)
    add_array(grid.GetCellData(), "T", np.tile([TENSOR[name] for name in order], (n**3, 1)))
    for i, name in enumerate(order):
        grid.GetCellData().GetArray("T").SetComponentName(i, name)
    return grid


def pvd(folder, grids):
    rows = ""
    for time, grid in enumerate(grids):
        write(vtk.vtkXMLUnstructuredGridWriter(), folder / f"s{time}.vtu", grid)
        rows += f'<DataSet timestep="{time}" file="s{time}.vtu"/>'
    (folder / "a.pvd").write_text(f'<VTKFile type="Collection"><Collection>{rows}</Collection></VTKFile>')
    return folder / "a.pvd"


def component(dataset, name, step=0):
    names = dataset.array("cell:T").attrs["ciel"]["component_names"]
    return set(dataset.values("cell:T", step)[:, names.index(name)])


def test_tensors_in_other_orders_at_other_times_are_put_in_one(tmp_path):
    dataset = imported(tmp_path, pvd(tmp_path, [with_tensor(order) for order in ORDERS]))
    for name, value in TENSOR.items():
        assert component(dataset, name.lower(), 0) == component(dataset, name.lower(), 1) == {value}


def test_tensors_in_other_orders_in_other_blocks_are_put_in_one(tmp_path):
    data = multi_block(("a", with_tensor(ORDERS[0])), ("b", with_tensor(ORDERS[1], shift=2)))
    dataset = imported(tmp_path, write(vtk.vtkXMLMultiBlockDataWriter(), tmp_path / "a.vtm", data))
    for name, value in TENSOR.items():
        assert component(dataset, name.lower()) == {value}


def test_a_step_without_the_names_of_the_others_is_lost(tmp_path):
    bare = cubes(2)
    add_array(bare.GetCellData(), "T", np.ones((8, 6)))
    dataset = imported(tmp_path, pvd(tmp_path, [bare, with_tensor(ORDERS[0]), with_tensor(ORDERS[0])]), code=3)
    assert ["cell:T" in step["arrays"] for step in dataset.steps] == [False, True, True]
    assert "The array cell:T has 6 components at time 0 and 6 components (xx, xy, xz, yy, yz, zz) at other times" in dataset.notes


def test_a_name_that_is_of_points_at_one_step_and_of_cells_at_others(tmp_path):
    grids = [cubes(2) for _ in range(3)]
    add_array(grids[0].GetPointData(), "U", np.ones((27, 3)))
    for grid in grids[1:]:
        add_array(grid.GetCellData(), "U", np.arange(8.0))
    dataset = imported(tmp_path, pvd(tmp_path, grids), code=3)
    assert dataset.times == [0, 1, 2] and dataset.array("U").attrs["ciel"]["components"] == 1
    assert ["U" in step["arrays"] for step in dataset.steps] == [False, True, True]


def test_six_components_without_names_are_no_hindrance(tmp_path):
    grid = cubes(3)
    add_array(grid.GetCellData(), "R", np.random.default_rng(1).random((27, 6)))
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    assert ciel("render", dataset.path, "-o", tmp_path / "a.png").returncode == 0
    of_cells = arrays_of(dataset)["cell:R"]
    assert [of_cells["extremes"][end]["value"] for end in ("lowest", "highest")] == of_cells["range"]


def test_values_that_are_not_there_are_not_taken_for_bad_ones(tmp_path):
    with_p, without = cubes(2), with_tensor(ORDERS[0], shift=2)
    values = np.arange(8.0)
    values[3] = np.nan
    add_array(with_p.GetCellData(), "p", values)
    data = multi_block(("a", with_p), ("b", without))
    dataset = imported(tmp_path, write(vtk.vtkXMLMultiBlockDataWriter(), tmp_path / "a.vtm", data))
    of_cells = arrays_of(dataset)["cell:p"]
    assert (of_cells["invalid"], of_cells["missing"]) == (1, 8)
    assert "8 values missing, 1 values not finite" in ciel_info(dataset.path)


def polygons(dataset, folder, *what):
    done = ciel("extract", dataset.path, *what, "-o", folder / "a.vtp", check=True)
    return int(done.stdout.split()[2]), done.stderr


def test_a_cell_with_one_bad_component_is_left_out_for_all(tmp_path):
    grid = cubes(3)
    velocity = np.ones((27, 3))
    velocity[13, 0] = np.nan
    add_array(grid.GetCellData(), "U", velocity)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    for scalar in ("U:x", "U:y", "U", "cell:U:z"):
        assert polygons(dataset, tmp_path, "--slice", "x=0.5", "--color", scalar)[0] == 8


def test_cells_at_a_bad_point_are_told_where_they_are_left_out(tmp_path):
    grid = cubes(4)
    values = np.array([grid.GetPoint(i)[0] for i in range(125)])
    values[62] = np.nan
    add_array(grid.GetPointData(), "p", values)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    assert polygons(dataset, tmp_path, "--iso", "p=0.4") == (
        12, "ciel: 8 cells have a corner without a number for p at this time and are left out\n"
    )


def test_datasets_without_origins_know_which_points_were_made_from_cells(tmp_path):
    grid = cubes(3)
    values = np.array([grid.GetCell(i).GetBounds()[0] for i in range(27)])
    values[13] = np.nan
    add_array(grid.GetCellData(), "p", values)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    for document in dataset.path.glob("meshes/0/arrays/*/.zattrs"):
        attributes = json.loads(document.read_text())
        del attributes["ciel"]["origin"]
        document.write_text(json.dumps(attributes))
    assert polygons(dataset, tmp_path, "--iso", "p=0.3")[0] == 8
    assert arrays_of(dataset)["p"]["origin"] == "unknown"


@pytest.mark.parametrize("structured", [False, True])
def test_a_coordinate_that_is_no_number_is_refused(tmp_path, structured):
    if structured:
        grid = vtk.vtkRectilinearGrid()
        grid.SetDimensions(3, 3, 3)
        for axis in "XYZ":
            values = vtk.vtkDoubleArray()
            for value in (0.25, 1.25, 2.25):
                values.InsertNextValue(value)
            getattr(grid, f"Set{axis}Coordinates")(values)
        file = write(vtk.vtkRectilinearGridWriter(), tmp_path / "a.vtk", grid)
    else:
        grid = cubes(2)
        grid.GetPoints().SetPoint(0, 0.25, 0, 0)
        file = write(vtk.vtkUnstructuredGridWriter(), tmp_path / "a.vtk", grid)
    file.write_text(file.read_text().replace("0.25", "nan"))
    refused = run_import(file, "-o", tmp_path / "out.ciel")
    assert refused.returncode == 1 and "finite" in refused.stderr and "e38" not in refused.stderr


def test_a_word_for_no_number_among_whole_numbers_is_refused_in_words(tmp_path):
    grid = cubes(2)
    grid.GetCellData().AddArray(ids_of("n", range(100, 108)))
    file = write(vtk.vtkUnstructuredGridWriter(), tmp_path / "a.vtk", grid)
    file.write_text(file.read_text().replace("103", "nan"))
    refused = run_import(file, "-o", tmp_path / "out.ciel")
    assert refused.returncode == 1 and "a.vtk: holds nan or inf where whole numbers are declared" in refused.stderr


def test_ids_that_are_no_whole_numbers_are_no_ids(tmp_path):
    grid = cubes(2)
    add_array(grid.GetPointData(), "GlobalNodeId", np.full(27, 1.5))
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    assert "solver_vertex" not in dataset.mesh() and "Flags and ids were left out: GlobalNodeId." in dataset.notes


def test_a_bad_addressing_costs_the_ids_alone(tmp_path):
    write_decomposed(tmp_path / "case", (CENTERS[:, 0] > 0.5).astype(int), {})
    file = tmp_path / "case/processor1/constant/polyMesh/cellProcAddressing"
    file.write_text(header("labelList", "cellProcAddressing") + "3\n(\n0\n1\n2\n)\n")
    dataset = imported(tmp_path, tmp_path / "case", code=3)
    assert dataset.counts()["cells"] == 64 and "The solver's ids of the cells of processor1 could not be read" in dataset.notes


def test_units_are_those_of_the_files_that_are_taken(tmp_path):
    block = Block((2, 1, 1))
    entries = {side: "type zeroGradient;" for side in block.types}
    # p is written with vectors at the first time, by mistake.
    case = block.write(tmp_path / "case", {"p": (np.zeros((2, 3)), entries)})
    for time in ("2", "3"):
        (case / time).mkdir()
        (case / time / "p").write_text(field("volScalarField", "p", "[1 -1 -2 0 0 0 0]", np.zeros(2), entries))
    dataset = imported(tmp_path, case, code=3)
    assert dataset.units("cell:p") == "Pa"


def test_what_a_threshold_leaves_out_is_told(tmp_path):
    grid = cubes(2)
    values = np.arange(8.0)
    values[3] = np.inf
    add_array(grid.GetCellData(), "p", values)
    output = tmp_path / "b.ciel"
    assert run_import(write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "b.vtu", grid), "-o", output).returncode == 0
    told = ciel("render", output, "--surface", "--threshold", "p=0,100", "-o", tmp_path / "a.png").stderr
    assert "1 cell has no number for p at this time and is left out" in told
    silent = ciel("render", output, "--points", "all", "--color", "p", "-o", tmp_path / "a.png").stderr
    assert "left out" not in silent, "nothing is"
