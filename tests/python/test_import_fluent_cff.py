"""Fluent's HDF5 case and data files, written by h5py: what VTK can read is imported, the rest is refused with a message."""

import numpy as np
import pytest
import vtk
from import_support import imported, run_import
from test_import_converge import polygons
from vtk_files import hexahedra, linear

h5py = pytest.importorskip("h5py", reason="python3-h5py is not installed")

N = 3
HEXAHEDRON, POLYHEDRON = 4, 7  # Fluent's cell types
INTERIOR, WALL = 2, 3


def attributes(group, **values):
    for name, value in values.items():
        group.attrs[name] = np.uint64(value)
    return group


def zones(group, rows, **more):
    """One row per zone: id, first and last number."""
    ids, first, last = zip(*rows)
    attributes(group, nZones=len(rows))
    group["id"] = np.array(ids, "i4")
    group["minId"], group["maxId"] = np.array(first, "u8"), np.array(last, "u8")
    group["dimension"] = np.full(len(rows), 3, "u8")
    for name, values in more.items():
        group[name] = np.array(values, "i4")


def section(group, name, first, last, data):
    attributes(group, nSections=1)
    attributes(group.create_dataset(name, data=data), minId=first, maxId=last)


def write_case(path, cell_type):
    points, cells = hexahedra(N)
    rows = polygons(cells, lambda loop: points[loop].mean(axis=0))
    # Inner faces first. A face's loop is counter-clockwise around the direction from its first to its second cell.
    rows = sorted(([loop[::-1], [owner for owner in owners if owner >= 0]] for loop, owners in rows), key=lambda row: -len(row[1]))
    inner = sum(len(owners) == 2 for _, owners in rows)
    with h5py.File(path, "w") as file:
        file.create_group("settings")
        mesh = attributes(file.create_group("meshes/1"), nodeOffset=1, nodeCount=len(points), cellOffset=1, cellCount=len(cells),
                          faceOffset=1, faceCount=len(rows))
        mesh.attrs["dimension"] = np.int32(3)
        zones(mesh.create_group("nodes/zoneTopology"), [(1, 1, len(points))])
        attributes(mesh.create_dataset("nodes/coords/1", data=points.astype("f8")), minId=1, maxId=len(points))
        zones(mesh.create_group("cells/zoneTopology"), [(2, 1, len(cells))], cellType=[cell_type], childZoneId=[0])
        zones(mesh.create_group("faces/zoneTopology"), [(3, 1, inner), (4, inner + 1, len(rows))], zoneType=[INTERIOR, WALL],
              faceType=[4, 4], childZoneId=[0, 0], shadowZoneId=[0, 0], flags=[0, 0])
        attributes(mesh.create_group("faces/nodes"), nSections=1)
        nodes = attributes(mesh.create_group("faces/nodes/1"), minId=1, maxId=len(rows))
        nodes["nnodes"] = np.full(len(rows), 4, "i2")
        nodes["nodes"] = (np.concatenate([loop for loop, _ in rows]) + 1).astype("u4")
        section(mesh.create_group("faces/c0"), "1", 1, len(rows), np.array([owners[0] + 1 for _, owners in rows], "u4"))
        section(mesh.create_group("faces/c1"), "1", 1, inner, np.array([owners[1] + 1 for _, owners in rows[:inner]], "u4"))
    with h5py.File(path.with_name(path.name.replace(".cas.h5", ".dat.h5")), "w") as file:
        fields = file.create_group("results/1/phase-1/cells")
        fields.create_dataset("fields", data=np.array("SV_P;", "S16"))
        section(fields.create_group("SV_P"), "1", 1, len(cells), linear(points[cells].mean(axis=1)).astype("f8"))
    return path


@pytest.mark.parametrize("cell_type", [HEXAHEDRON, POLYHEDRON])
def test_a_case_and_its_data(tmp_path, cell_type):
    """The cells have six quadrilaterals each, so they are hexahedra, whatever type the file gives them."""
    case = write_case(tmp_path / "duct.cas.h5", cell_type)
    if not hasattr(vtk, "vtkFLUENTCFFReader"):
        done = run_import(case, "-o", tmp_path / "duct.ciel")
        assert done.returncode == 1 and "container image" in done.stderr and "legacy .cas" in done.stderr
        assert not (tmp_path / "duct.ciel").exists()
        return
    dataset = imported(tmp_path, case)
    assert dataset.cells() == {"hexahedron": N**3}
    assert abs(dataset.volume()) == pytest.approx(1)
    points, cells = hexahedra(N)
    original = dataset.mesh()["original_cell"][:]
    np.testing.assert_allclose(dataset.values("cell:SV_P"), linear(points[cells].mean(axis=1))[original], atol=1e-5)
