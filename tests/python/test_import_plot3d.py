"""PLOT3D in every layout: the layout is detected, and the values are at the right points."""

import itertools
import struct

import numpy as np
import pytest
from import_support import imported, run_import

DIMS = (4, 3, 5)


def grid_of(dims, shift=0.0):
    k, j, i = np.meshgrid(*(np.arange(n, dtype=float) for n in reversed(dims)), indexing="ij")
    return np.stack([i + shift, j, k])


def solution_of(grid):
    x, y, z = grid
    density = 1 + 0.1 * x
    return np.stack([density, density * y, density * z, density * 0, 10 + 2 * x - y])


class Plot3dFile:
    """Writes with or without Fortran records, in both byte orders and precisions."""

    def __init__(self, path, order, records, real):
        self.file, self.order, self.records, self.real = open(path, "wb"), order, records, real

    def write(self, *arrays):
        data = b"".join(a.astype(self.order + kind).tobytes() for a, kind in arrays)
        mark = struct.pack(self.order + "i", len(data)) if self.records else b""
        self.file.write(mark + data + mark)


def write_pair(folder, order=">", records=False, multi=False, real="f4", iblank=None, grids=1, padding=0):
    blocks = [grid_of(DIMS, shift=10.0 * g) for g in range(grids)]
    integers = lambda values: (np.array(values), "i4")
    for name in ("grid.xyz", "grid.q"):
        out = Plot3dFile(folder / name, order, records, real)
        if multi:
            out.write(integers([grids]))
        out.write(integers([n for _ in blocks for n in DIMS]))
        for block in blocks:
            if name.endswith("xyz"):
                out.write((block.ravel(), real), *([integers(iblank)] if iblank is not None else []))
            else:
                out.write((np.array([0.5, 0.0, 1000.0, 0.0]), real))
                out.write((solution_of(block).ravel(), real))
        out.file.write(bytes(padding))
        out.file.close()
    return folder / "grid.xyz", folder / "grid.q"


LAYOUTS = list(itertools.product("<>", (False, True), (False, True), ("f4", "f8"), (False, True)))


@pytest.mark.parametrize("order, records, multi, real, iblank", LAYOUTS)
def test_every_layout_is_found(tmp_path, order, records, multi, real, iblank):
    grids = 2 if multi else 1
    files = write_pair(tmp_path, order, records, multi, real, np.ones(60) if iblank else None, grids)
    dataset = imported(tmp_path, *reversed(files))  # the order of the files has no effect
    assert dataset.input == {"vertices": 60 * grids, "cells": 24 * grids, "edges": 133 * grids}
    position = dataset.positions()
    solution = solution_of(position.T)
    np.testing.assert_allclose(dataset.values("Density"), solution[0], rtol=1e-5)
    np.testing.assert_allclose(dataset.values("StagnationEnergy"), solution[4], rtol=1e-5)
    np.testing.assert_allclose(dataset.values("Momentum"), solution[1:4].T, rtol=1e-5)
    np.testing.assert_allclose(dataset.values("Velocity"), (solution[1:4] / solution[0]).T, rtol=1e-4, atol=1e-6)


def test_text(tmp_path):
    block = grid_of(DIMS)
    row = lambda values: " ".join(repr(float(v)) for v in values)
    (tmp_path / "grid.xyz").write_text("4 3 5\n" + row(block.ravel()) + "\n")
    (tmp_path / "grid.q").write_text("4 3 5\n0.5 0.0 1000.0 0.0\n" + row(solution_of(block).ravel()) + "\n")
    dataset = imported(tmp_path, tmp_path / "grid.xyz", tmp_path / "grid.q")
    np.testing.assert_allclose(dataset.values("Density"), 1 + 0.1 * dataset.positions()[:, 0], rtol=1e-5)


def test_iblank_zero_is_a_hole_and_nothing_else_is(tmp_path):
    iblank = np.ones(60, dtype=int)
    iblank[-1], iblank[5], iblank[20] = 0, -1, 2
    dataset = imported(tmp_path, *write_pair(tmp_path, iblank=iblank))
    assert dataset.counts()["cells"] == 23 and "1 cell is blanked" in dataset.notes
    assert dataset.counts()["vertices"] == 59


def test_a_padded_solution_is_accepted(tmp_path):
    grid, q = write_pair(tmp_path)
    q.write_bytes(q.read_bytes() + bytes(-q.stat().st_size % 512))
    assert imported(tmp_path, grid, q).counts()["cells"] == 24


def test_a_grid_alone_and_a_series_of_solutions(tmp_path):
    grid, q = write_pair(tmp_path)
    alone = tmp_path / "alone"
    alone.mkdir()
    assert imported(alone, grid.rename(alone / grid.name)).array_names() == []
    grid, q = write_pair(tmp_path)
    later = tmp_path / "later.q"
    later.write_bytes(q.read_bytes())
    dataset = imported(tmp_path, grid, q, later, "--force")
    assert dataset.times == [0, 1] and dataset.counts()["cells"] == 24


def test_a_grid_takes_the_solution_of_its_name_along(tmp_path):
    grid, q = write_pair(tmp_path)
    for name in ("grid.xyz", "grid.x", "grid.grid"):
        grid = grid.rename(tmp_path / name)
        dataset = imported(tmp_path, grid, "--force")
        assert "Density" in dataset.array_names() and "read from grid.q" in dataset.notes
    (tmp_path / "grid.Q").write_bytes(q.read_bytes())
    dataset = imported(tmp_path, grid, "--force")
    assert dataset.array_names() == [] and "grid.q and grid.Q; neither was read" in dataset.notes
    (tmp_path / "grid.Q").unlink()
    q.write_bytes(q.read_bytes()[:-4])
    dataset = imported(tmp_path, grid, "--force")
    assert dataset.array_names() == [] and "grid.q lies beside the grid but was not read" in dataset.notes


def test_a_solution_finds_its_grid_and_nasa_names_belong_together(tmp_path):
    grid, q = write_pair(tmp_path)
    dataset = imported(tmp_path, q)
    assert "Density" in dataset.array_names() and "read from grid.xyz" in dataset.notes
    grid, q = grid.rename(tmp_path / "finxyz.bin"), q.rename(tmp_path / "finq.bin")
    for file, beside in ((grid, q), (q, grid)):
        dataset = imported(tmp_path, file, "--force")
        assert "Density" in dataset.array_names() and f"read from {beside.name}" in dataset.notes


def test_refusals_say_why(tmp_path):
    grid, q = write_pair(tmp_path)
    alone = tmp_path / "alone" / q.name
    alone.parent.mkdir()
    alone.write_bytes(q.read_bytes())
    for arguments, words in [
        ((alone,), "give the file of its grid"),
        ((grid, q, "--plot3d", "little"), "of the layout --plot3d little"),
        ((grid, q, "--plot3d", "wide"), "has no word \"wide\""),
    ]:
        done = run_import(*arguments, "-o", tmp_path / "no.ciel")
        assert done.returncode == 1 and words in done.stderr, done.stderr
    grid.write_bytes(grid.read_bytes()[:-4])
    done = run_import(grid, q, "-o", tmp_path / "no.ciel")
    assert done.returncode == 1 and not (tmp_path / "no.ciel").exists()
