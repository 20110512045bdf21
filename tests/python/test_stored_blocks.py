"""The blocks on disk, read by another program."""

import collections

import numpy
import pytest
import zarr

from program import ciel
from stored_blocks import cells_of, faces_of


@pytest.mark.parametrize("coarseness", [2, 4])
def test_another_program_reads_the_cells_from_their_blocks(tmp_path, coarseness):
    dataset = tmp_path / "demo.ciel"
    assert ciel("demo", "--coarseness", coarseness, "-o", dataset).returncode == 0
    mesh = zarr.open_group(str(dataset), mode="r")["meshes/0"]
    beside, used = collections.defaultdict(list), set()
    cells = 0
    for cell, kind, vertices in cells_of(dataset / "meshes/0/blocks"):
        cells += 1
        for face in faces_of(kind, vertices):
            used.update(face)
            beside[frozenset(face)].append(cell)
    assert cells == mesh["cell_types"].shape[0] and used == set(range(mesh["positions"].shape[1]))
    assert all(len(of_face) <= 2 for of_face in beside.values()), "a face has at most two cells"
    alone = {face: of_face[0] for face, of_face in beside.items() if len(of_face) == 1}
    begin, vertex = mesh["faces/face_offset"][:].astype("i8"), mesh["faces/face_vertex"][:]
    owner = mesh["faces/owner"][:]
    assert {frozenset(vertex[begin[face] : begin[face + 1]]): owner[face] for face in range(len(owner))} == alone
