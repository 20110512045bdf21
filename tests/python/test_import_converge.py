"""CONVERGE post files written by h5py: polyhedra given by polygons, boundaries, vectors in three arrays, one file per time."""

import numpy as np
import pytest
from import_support import imported
from vtk_files import CUBE_FACES, hexahedra, linear

h5py = pytest.importorskip("h5py", reason="python3-h5py is not installed")

N = 3
WALL, INLET = 30, 7  # ids of boundaries are arbitrary


def polygons(cells, centers_of):
    """Each polygon once: its nodes and its two cells. An outside cell is -(boundary id + 1) and comes first."""
    seen = {}
    for cell, nodes in enumerate(cells):
        for face in CUBE_FACES:
            loop = [int(nodes[i]) for i in face]
            seen.setdefault(tuple(sorted(loop)), (loop, []))[1].append(cell)
    rows = []
    for loop, owners in seen.values():
        if len(owners) == 1:
            boundary = INLET if np.allclose(centers_of(loop)[0], 0) else WALL
            owners = [-(boundary + 1), owners[0]]
        rows.append((loop, owners))
    return rows


def strings(group, name, values):
    group.create_dataset(name, data=np.array(values, dtype="S32"))


def write_converge(path, time):
    points, cells = hexahedra(N)
    rows = polygons(cells, lambda loop: points[loop].mean(axis=0))
    centers = points[cells].mean(axis=1)
    with h5py.File(path, "w") as file:
        file.attrs["OUTPUT_TIME"] = np.float64(time)
        boundaries = file.create_group("BOUNDARIES")
        strings(boundaries, "BOUNDARY_NAMES", ["wall", "inlet"])
        outside = [owners[0] for _, owners in rows]
        boundaries["NUM_ELEMENTS"] = np.array([outside.count(-(WALL + 1)), outside.count(-(INLET + 1))], dtype="i4")
        boundaries["BOUNDARY_IDS"] = np.array([WALL, INLET], dtype="i4")
        stream = file.create_group("STREAM_00")
        strings(stream, "VARIABLE_NAMES/CELL_VARIABLES", ["PRESSURE", "VELOCITY_X", "VELOCITY_Y", "VELOCITY_Z"])
        for axis, name in enumerate("XYZ"):
            stream[f"VERTEX_COORDINATES/{name}"] = points[:, axis].astype("f4")
            stream[f"CELL_CENTER_DATA/VELOCITY_{name}"] = (centers[:, axis] * time).astype("f4")
        stream["CELL_CENTER_DATA/PRESSURE"] = (linear(centers) + time).astype("f4")
        stream["CONNECTIVITY/POLYGON_OFFSET"] = np.cumsum([0] + [len(loop) for loop, _ in rows]).astype("i4")
        stream["CONNECTIVITY/POLYGON_TO_VERTEX"] = np.concatenate([loop for loop, _ in rows]).astype("i4")
        stream["CONNECTIVITY/CONNECTED_CELLS"] = np.concatenate([owners for _, owners in rows]).astype("i4")
    return path


def test_polyhedra_boundaries_fields_and_times(tmp_path):
    first = write_converge(tmp_path / "post000001_+1.0e+00.h5", 1)
    write_converge(tmp_path / "post000002_+2.5e+00.h5", 2.5)
    dataset = imported(tmp_path, first)
    assert dataset.cells() == {"hexahedron": N**3} and dataset.volume() == pytest.approx(1)
    assert dataset.counts()["components"] == 1 and dataset.counts()["faces"] == 3 * N * N * (N + 1)
    assert dataset.times == [1, 2.5]
    assert {name: len(ids) for name, ids in dataset.groups().items()} == {"wall": 5 * N * N, "inlet": N * N}
    np.testing.assert_allclose(dataset.positions()[dataset.points_of(dataset.groups()["inlet"])][:, 0], 0)
    points, cells = hexahedra(N)
    centers = points[cells].mean(axis=1)[dataset.mesh()["original_cell"][:]]
    for step, time in enumerate(dataset.times):
        np.testing.assert_allclose(dataset.values("cell:PRESSURE", step), linear(centers) + time, atol=1e-5)
        np.testing.assert_allclose(dataset.values("cell:VELOCITY", step), centers * time, atol=1e-5)
        position = dataset.positions()
        inside = np.all((position > 0.1) & (position < 0.9), axis=1)
        np.testing.assert_allclose(dataset.values("PRESSURE", step)[inside], linear(position)[inside] + time, atol=1e-5)
