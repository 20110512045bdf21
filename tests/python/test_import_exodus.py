"""Exodus II files of the netCDF library: element blocks, side sets, element sets, values over time."""

import numpy as np
import pytest
from import_support import imported, run_import
from vtk_files import hexahedra, linear

netCDF4 = pytest.importorskip("netCDF4", reason="python3-netcdf4 is not installed")

N = 3
SIDES = {"y0": 1, "x1": 2, "y1": 3, "x0": 4, "z0": 5, "z1": 6}  # side numbers of an axis-aligned HEX8
QUADRATIC_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7), (7, 4)]


def text(file, name, rows, dimension):
    file.createVariable(name, "S1", (dimension, "len_name"))[:] = netCDF4.stringtochar(np.array(rows, dtype="S33"))


def write_sets(file, kind, sets):
    """`kind`: side or elem. `sets`: name -> (elements, sides or None), counted from 1."""
    if not sets:
        return
    short = {"side": "ss", "elem": "els"}[kind]
    plural = {"side": "num_side_sets", "elem": "num_elem_sets"}[kind]
    file.createDimension(plural, len(sets))
    file.createVariable(f"{short}_prop1", "i4", (plural,))[:] = np.arange(len(sets)) + 10
    file[f"{short}_prop1"].setncattr("name", "ID")
    file.createVariable(f"{short}_status", "i4", (plural,))[:] = 1
    text(file, f"{short}_names", list(sets), plural)
    for i, (elements, sides) in enumerate(sets.values(), 1):
        count = f"num_side_ss{i}" if kind == "side" else f"num_ele_els{i}"
        file.createDimension(count, len(elements))
        file.createVariable(f"elem_{short}{i}", "i4", (count,))[:] = elements
        if sides is not None:
            file.createVariable(f"side_ss{i}", "i4", (count,))[:] = sides


def write_exodus(path, blocks, points, cell_kind, side_sets, element_sets, nodal=None, element=None, times=(), kind="NETCDF3_64BIT_OFFSET"):
    """`blocks`: name -> rows of nodes, from 0. `nodal` and `element`: functions that return the values of a step."""
    with netCDF4.Dataset(path, "w", format=kind) as file:
        file.setncatts({"api_version": np.float32(8.03), "version": np.float32(8.03), "floating_point_word_size": 8,
                        "file_size": 1, "maximum_name_length": 32, "title": "a cube"})
        cells = sum(map(len, blocks.values()))
        for name, size in {"len_string": 33, "len_name": 33, "len_line": 81, "four": 4, "num_dim": 3, "num_nodes": len(points),
                           "num_elem": cells, "num_el_blk": len(blocks)}.items():
            file.createDimension(name, size)
        file.createDimension("time_step", None)
        file.createVariable("time_whole", "f8", ("time_step",))[:] = np.array(times)
        for axis, name in enumerate(("coordx", "coordy", "coordz")):
            file.createVariable(name, "f8", ("num_nodes",))[:] = points[:, axis]
        text(file, "coor_names", ["x", "y", "z"], "num_dim")
        text(file, "eb_names", list(blocks), "num_el_blk")
        file.createVariable("eb_status", "i4", ("num_el_blk",))[:] = 1
        file.createVariable("eb_prop1", "i4", ("num_el_blk",))[:] = np.arange(len(blocks)) + 1
        file["eb_prop1"].setncattr("name", "ID")
        for i, rows in enumerate(blocks.values(), 1):
            file.createDimension(f"num_el_in_blk{i}", len(rows))
            file.createDimension(f"num_nod_per_el{i}", len(rows[0]))
            connect = file.createVariable(f"connect{i}", "i4", (f"num_el_in_blk{i}", f"num_nod_per_el{i}"))
            connect.setncattr("elem_type", cell_kind)
            connect[:] = np.array(rows) + 1
        write_sets(file, "side", side_sets)
        write_sets(file, "elem", element_sets)
        if nodal:
            file.createDimension("num_nod_var", 1)
            text(file, "name_nod_var", ["f"], "num_nod_var")
            file.createVariable("vals_nod_var1", "f8", ("time_step", "num_nodes"))[:] = np.array([nodal(s) for s in range(len(times))])
        if element:
            file.createDimension("num_elem_var", 1)
            text(file, "name_elem_var", ["c"], "num_elem_var")
            file.createVariable("elem_var_tab", "i4", ("num_el_blk", "num_elem_var"))[:] = 1
            at = 0
            for i, rows in enumerate(blocks.values(), 1):
                values = file.createVariable(f"vals_elem_var1eb{i}", "f8", ("time_step", f"num_el_in_blk{i}"))
                values[:] = np.array([element(s)[at : at + len(rows)] for s in range(len(times))])
                at += len(rows)
    return path


def on_side(centers, axis, side):
    """Returns the elements (from 1) that touch a side of the unit cube, and the number of the touching side of each."""
    at = (0 if side == 0 else N - 1) + 0.5
    elements = np.flatnonzero(np.isclose(centers[:, axis] * N, at)) + 1
    return elements, np.full(len(elements), SIDES["xyz"[axis] + str(side)])


@pytest.mark.parametrize("kind", ["NETCDF3_64BIT_OFFSET", "NETCDF4"])
def test_blocks_side_sets_element_sets_and_times(tmp_path, kind):
    points, cells = hexahedra(N)
    centers = points[cells].mean(axis=1)
    order = np.argsort(centers[:, 0] > 0.5, kind="stable")  # elements are numbered through all blocks
    cells, centers = cells[order], centers[order]
    left = int((centers[:, 0] < 0.5).sum())
    inlet, bottom = on_side(centers, 0, 0), on_side(centers, 2, 0)
    both = tuple(np.concatenate(pair) for pair in zip(inlet, bottom))
    core = np.flatnonzero(np.all(np.isclose(centers, 0.5), axis=1) | (centers[:, 0] > 0.8)) + 1
    file = write_exodus(
        tmp_path / "a.exo", {"left": cells[:left], "right": cells[left:]}, points, "HEX8",
        {"inlet": inlet, "wet": both}, {"core": (core, None)},
        nodal=lambda step: linear(points) + step, element=lambda step: linear(centers) + 10 * step, times=(0.25, 0.75), kind=kind,
    )
    dataset = imported(tmp_path, file, "--weld")
    assert dataset.counts()["cells"] == N**3 and dataset.counts()["vertices"] == (N + 1) ** 3
    assert dataset.counts()["components"] == 1 and dataset.volume() == pytest.approx(1)
    assert dataset.times == [0.25, 0.75]
    np.testing.assert_allclose(dataset.values("f", 1), linear(dataset.positions()) + 1, atol=1e-5)
    original = dataset.mesh()["original_cell"][:]
    np.testing.assert_allclose(dataset.values("cell:c", 1), linear(centers[original]) + 10, atol=1e-5)

    groups = dataset.groups()
    assert {name: len(ids) for name, ids in groups.items()} == {
        "left": left, "right": N**3 - left, "inlet": N * N, "wet": 2 * N * N, "core": len(core)
    }
    np.testing.assert_allclose(dataset.positions()[dataset.points_of(groups["inlet"])][:, 0], 0)
    wet = dataset.positions()[dataset.points_of(groups["wet"])]
    assert np.all(np.isclose(wet[:, 0], 0) | np.isclose(wet[:, 2], 0))
    assert set(original[groups["core"]] + 1) == set(core)
    assert set(original[groups["left"]]) == set(range(left))


def test_sets_of_quadratic_elements(tmp_path):
    points, cells = hexahedra(N)
    centers = points[cells].mean(axis=1)
    middle, rows = {}, []
    for cell in cells:
        for a, b in QUADRATIC_EDGES:
            middle.setdefault((min(cell[a], cell[b]), max(cell[a], cell[b])), len(points) + len(middle))
        rows.append([*cell, *(middle[min(cell[a], cell[b]), max(cell[a], cell[b])] for a, b in QUADRATIC_EDGES)])
    all_points = np.vstack([points, [(points[a] + points[b]) / 2 for a, b in middle]])
    file = write_exodus(tmp_path / "a.exo", {"cube": rows}, all_points, "HEX20",
                        {"inlet": on_side(centers, 0, 0)}, {"core": (np.array([14]), None)})
    dataset = imported(tmp_path, file)
    assert dataset.cells() == {"hexahedron": N**3} and dataset.counts()["vertices"] == (N + 1) ** 3
    assert f"{N**3} quadratic hexahedra keep their corners" in dataset.notes
    assert {name: len(ids) for name, ids in dataset.groups().items()} == {"inlet": N * N, "core": 1}


def steps_of_a_cube(tmp_path, times=(0.0, 1.0, 2.0)):
    points, rows = hexahedra(N)
    path = tmp_path / "a.exo"
    write_exodus(path, {"block": rows}, points, "HEX8", {}, {}, nodal=lambda step: linear(points) + step + 10, times=times)
    return path, path.read_bytes()


@pytest.mark.parametrize("bytes_lost, steps", [(0, 3), (1, 2), (8, 2), (600, 1)])
def test_a_file_that_was_cut_off_costs_the_steps_that_are_not_whole(tmp_path, bytes_lost, steps):
    path, content = steps_of_a_cube(tmp_path)
    path.write_bytes(content[: len(content) - bytes_lost])
    dataset = imported(tmp_path, path, code=0 if steps == 3 else 3)
    assert dataset.times == [0, 1, 2][:steps]
    assert ("are incomplete and were left out" in dataset.notes) == (steps < 3)
    assert all(dataset.values("f", step).min() > 0 for step in range(steps)), "nothing is zero that is not"


def test_a_file_without_its_whole_mesh_is_refused(tmp_path):
    path, content = steps_of_a_cube(tmp_path)
    path.write_bytes(content[: len(content) // 2])
    refused = run_import(path, "-o", tmp_path / "out.ciel")
    assert refused.returncode == 1 and "bytes that its mesh needs; copy the file again" in refused.stderr
    path.write_bytes(content[:100])
    refused = run_import(path, "-o", tmp_path / "out.ciel")
    assert refused.returncode == 1 and "its netCDF header is cut off" in refused.stderr
