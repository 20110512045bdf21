"""NASA's grids, and a sphere in a channel: published counts, and physical values at walls."""

import os
import pathlib
import tarfile

import numpy as np
import pytest
from import_support import ciel_info, imported

DATA = pathlib.Path(os.environ.get("CIEL_DATA") or "/nowhere")

needs_data = pytest.mark.skipif(not (DATA / "nasa").is_dir(), reason="CIEL_DATA does not name the folder with the real datasets")


def nasa(name):
    return DATA / f"nasa/{name}xyz.bin", DATA / f"nasa/{name}q.bin"


@needs_data
def test_blunt_fin(tmp_path):
    dataset = imported(tmp_path, *nasa("bluntfin"))
    assert dataset.input == {"vertices": 40960, "edges": 119296, "cells": 37479}
    assert dataset.counts()["half_edges"] == 899496  # 24 half-edges per hexahedron
    assert dataset.cells() == {"hexahedron": 37479}
    density = dataset.values("Density")
    assert 0.19 < density.min() < 0.2 and 4.9 < density.max() < 5
    welded = imported(tmp_path, *nasa("bluntfin"), "--weld", "--force")
    assert welded.input == dataset.input
    assert welded.counts()["vertices"] == 40921 and welded.counts()["edges"] == 119219
    assert welded.counts()["cells"] == 37479  # includes the 39 collapsed cells


@needs_data
def test_oxygen_post(tmp_path):
    dataset = imported(tmp_path, *nasa("post"), "--no-weld")
    assert dataset.input == {"vertices": 109744, "edges": 322012, "cells": 102675}
    assert dataset.counts()["vertices"] == 109744 and dataset.counts()["edges"] == 322012
    welded = imported(tmp_path, *nasa("post"), "--force")
    assert welded.input == dataset.input
    assert welded.counts()["vertices"] == 108300 and welded.counts()["edges"] == 319200
    assert "seam" in welded.notes and "1444 pairs" in welded.notes
    np.testing.assert_array_equal(welded.values("Density"), 1)
    assert np.ptp(welded.values("StagnationEnergy")) > 0


@pytest.fixture(scope="module")
def sphere(tmp_path_factory):
    archive = DATA / "sphere_polyhedra.tar.xz"
    if not archive.is_file():
        pytest.skip("CIEL_DATA does not name the folder with the real datasets")
    folder = tmp_path_factory.mktemp("sphere")
    with tarfile.open(archive) as files:
        files.extractall(folder)
    return imported(folder, folder / "sphere_polyhedra" / "x.foam")


def test_sphere_counts(sphere):
    assert sphere.input["vertices"] == 891387 and sphere.input["cells"] == 145124
    assert sphere.counts()["cells"] == 145124
    assert sphere.cells() == {"hexahedron": 88, "polyhedron": 145036}
    assert sphere.times == [1.6, 3.2, 4.8, 6.4, 8]
    assert {name: len(f) for name, f in sphere.groups().items()} == {
        "inlet": 989, "sides": 8513, "outlet": 985, "body": 8922, "defaultFaces": 66, "fluid": 87,
    }


def test_sphere_ugly_cells_are_named(sphere):
    note = sphere.facts["notes"][0]
    assert note.startswith("19 faces look inwards from the center of 8 cells (inverted face pyramids)")
    assert "first ids: 112, 154, 196, 253, 428, 429, 430, 431" in note
    assert note in ciel_info(sphere.path)


def test_sphere_wall_is_at_rest_and_fully_marked(sphere):
    wall = sphere.points_of(sphere.groups()["body"])
    assert len(wall) == 17823
    for step in range(5):
        assert np.all(sphere.values("U", step)[wall] == 0)
        assert np.all(sphere.values("s", step)[wall] == 1)


def test_sphere_point_data_stays_within_cells_and_patches(sphere):
    for step in range(5):
        made, cells = sphere.values("s", step), sphere.values("cell:s", step)
        assert made.min() >= cells.min() and made.max() <= 1
        inlet = sphere.points_of(sphere.groups()["inlet"])
        np.testing.assert_allclose(sphere.values("U", step)[inlet], np.tile([1, 0.03, 0.02], (len(inlet), 1)), rtol=1e-6)


def test_sphere_interior_follows_the_cells(sphere):
    """Away from walls the field is smooth, so point values are close to those of the surrounding cells."""
    position = sphere.positions()
    calm = (position[:, 0] < -1.2) & (np.abs(position[:, 1]) < 1) & (np.abs(position[:, 2]) < 1)
    assert calm.sum() > 1000
    np.testing.assert_allclose(sphere.values("U", 4)[calm, 0], 1, atol=0.15)
