"""Data that a dataset does not keep is reported: faces, arrays, digits."""

import numpy as np
import pytest
import vtk
from import_support import imported
from vtk.util.numpy_support import numpy_to_vtk
from vtk_files import CUBE, add_array, multi_block, unstructured, with_fields, write

HEXAHEDRON = [(vtk.VTK_HEXAHEDRON, list(range(8)))]


def test_arrays_that_are_left_out_are_named(tmp_path):
    grid = with_fields(unstructured(HEXAHEDRON, CUBE))
    text, field = vtk.vtkStringArray(), vtk.vtkFloatArray()
    text.SetName("material")
    text.InsertNextValue("steel")
    grid.GetCellData().AddArray(text)
    field.SetName("gravity")
    field.InsertNextValue(9.81)
    grid.GetFieldData().AddArray(field)
    ids = vtk.vtkIdTypeArray()
    ids.SetName("vtkOriginalPointIds")
    for i in range(8):
        ids.InsertNextValue(i)
    grid.GetPointData().AddArray(ids)
    notes = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid)).notes
    assert "Arrays of text were left out: material." in notes
    assert "Field data was left out: gravity." in notes
    assert "Flags and ids were left out: vtkOriginalPointIds." in notes


def test_arrays_that_differ_between_blocks_are_named(tmp_path):
    blocks = []
    for i, values in enumerate((np.zeros(8), np.zeros((8, 3)))):
        grid = unstructured(HEXAHEDRON, [(x + 2 * i, y, z) for x, y, z in CUBE])
        add_array(grid.GetPointData(), "stress", values)
        add_array(grid.GetPointData(), "f", np.arange(8.0))
        blocks.append((f"b{i}", grid))
    dataset = imported(tmp_path, write(vtk.vtkXMLMultiBlockDataWriter(), tmp_path / "a.vtm", multi_block(*blocks)), code=3)
    assert dataset.array_names() == ["f"]
    assert "Arrays whose components differ between blocks were left out: stress." in dataset.notes


def test_the_second_array_of_one_name_is_named(tmp_path):
    grid = unstructured(HEXAHEDRON, CUBE)
    for name in ("a_b", "a:b"):
        add_array(grid.GetPointData(), name, np.arange(8.0))
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    assert dataset.array_names() == ["a_b"]
    assert "Two arrays have the name a_b; the first was kept." in dataset.notes


def test_convex_point_sets_are_cells_that_are_lost(tmp_path):
    grid = unstructured([*HEXAHEDRON, (vtk.VTK_CONVEX_POINT_SET, list(range(8, 16)))], CUBE + [(x + 2, y, z) for x, y, z in CUBE])
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid), code=3)
    assert "1 convex point set was left out, because convex point sets have no faces" in dataset.notes and dataset.input["cells"] == 2


def test_a_face_of_one_or_two_corners_goes_and_its_cell_stays_where_the_others_close_it(tmp_path):
    faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    beside = [[n + 8 for n in face] for face in faces]
    points = CUBE + [(x + 2, y, z) for x, y, z in CUBE]
    grid = with_fields(unstructured([(vtk.VTK_POLYHEDRON, [*faces, [0, 1], [3]]),
                                     (vtk.VTK_POLYHEDRON, [*beside[:5], [8, 11]])], points))
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid), code=3)
    assert dataset.cells() == {"polyhedron": 1} and dataset.volume() == pytest.approx(1)
    assert "2 faces of fewer than three corners were left out (first cells: 0)." in dataset.notes
    assert "1 cell was left out: not closed (first ids: 1)." in dataset.notes


def test_values_that_floats_lose_are_kept(tmp_path):
    """Two hexahedra 10,000 km apart, one of which is 0.1 mm thick, and values that are equal in float32."""
    thin = [(x, y, z * 1e-4) for x, y, z in CUBE]
    far = [(x + 1e7, y, z) for x, y, z in CUBE]
    grid = unstructured([(vtk.VTK_HEXAHEDRON, list(range(8))), (vtk.VTK_HEXAHEDRON, list(range(8, 16)))], thin + far)
    add_array(grid.GetPointData(), "p", 101325 + 1e-5 * np.arange(16.0))
    add_array(grid.GetPointData(), "q", np.arange(16.0))
    ids = vtk.vtkIdTypeArray()
    ids.SetName("id")
    for value in (2**24 + 1, 2**24 + 2):
        ids.InsertNextValue(value)
    grid.GetCellData().AddArray(ids)
    path = write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid)
    dataset = imported(tmp_path, path)
    assert len(np.unique(dataset.values("p"))) == 16
    assert sorted(dataset.values("cell:id")) == [2**24 + 1, 2**24 + 2]
    assert not any(f"\"{name}\"" in dataset.notes for name in ("p", "q", "cell:id"))
    assert "The volume of" not in dataset.notes


def test_what_the_type_of_the_first_step_loses_is_said(tmp_path):
    """A series whose second file has more precise arrays than the first."""
    for step, (real, whole) in enumerate([("f4", "i2"), ("f8", "i4")]):
        grid = unstructured([(vtk.VTK_HEXAHEDRON, list(range(8)))], CUBE)
        for attributes, name, values in ((grid.GetPointData(), "p", (101325 + 1e-5 * np.arange(8)).astype(real)),
                                         (grid.GetCellData(), "id", np.array([7 + step * 2**24], dtype=whole))):
            array = numpy_to_vtk(values, deep=1)
            array.SetName(name)
            attributes.AddArray(array)
        write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / f"a_{step}.vtu", grid)
    files = "".join(f'<DataSet timestep="{step}" file="a_{step}.vtu"/>' for step in range(2))
    (tmp_path / "a.pvd").write_text(f'<VTKFile type="Collection"><Collection>{files}</Collection></VTKFile>')
    dataset = imported(tmp_path, tmp_path / "a.pvd")
    assert dataset.values("p", 1).dtype == np.float32
    assert ("7 of 8 values of \"p\" differ from the value before in the input and are equal to it in the dataset, which "
            "stores the array as 32-bit floats, the type of its first step.") in dataset.notes
    assert "1 of 1 values of \"cell:id\" are integers beyond 16,777,216 that a 32-bit float" in dataset.notes


@pytest.mark.parametrize("corners, sentence", [
    ([0, 0, 0, 0, 4, 5, 6, 7], "1 cell has coincident corners and was kept (first ids: 1)."),
    ([0, 1, 2, 3, 0, 1, 2, 3], "1 cell has coincident corners and was kept (first ids: 1)."),
    ([3] * 8, "1 cell has fewer than four different corners and no volume, and was kept (first ids: 1)."),
])
def test_cells_with_repeated_corners_are_told(tmp_path, corners, sentence):
    grid = unstructured([*HEXAHEDRON, (vtk.VTK_HEXAHEDRON, corners)], CUBE)
    dataset = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", grid))
    assert sentence in dataset.notes and dataset.counts()["cells"] == 2


def test_cells_without_repeated_corners_are_not(tmp_path):
    notes = imported(tmp_path, write(vtk.vtkXMLUnstructuredGridWriter(), tmp_path / "a.vtu", unstructured(HEXAHEDRON, CUBE))).notes
    assert "corners" not in notes
