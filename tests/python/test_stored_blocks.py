"""The blocks on disk, read by a program that knows no more than server/store/README.md."""

import pathlib
import struct

import numpy
import pytest
import zarr

from program import ciel

CORNERS = (4, 8, 6, 5)  # of tetrahedra, hexahedra, wedges, pyramids


def sections(record, kind):
    name, _, count, length = struct.unpack_from("<4sHHQ", record)
    assert name == kind and length == len(record)
    entries = struct.iter_unpack("<HHIII", record[16 : 16 + 16 * count])
    return {number: (size, record[8 * at : 8 * at + size * n]) for number, _, size, n, at in entries}


def array(found, number, dtype=None):
    size, data = found.get(number, (1, b""))
    return numpy.frombuffer(data, dtype or f"<u{size}").astype("i8")


def read_index(data):
    assert data[:16] == b"\x89CIEL\r\n\x1aindx\x02\0\x02\0"
    blocks, tables, length, places = struct.unpack_from("<4Q", data, 112)
    found = list(struct.iter_unpack("<HBBIIIQ", data[places : places + 24 * 3 * blocks]))
    return sections(data[tables : tables + length], b"tabl"), found[:blocks]


def ghosts(cells, number, neighbors, first):
    size, data = cells.get(number, (4, b""))
    pairs = numpy.frombuffer(data, f"<u{size // 2}").reshape(-1, 2)
    return first[neighbors[pairs[:, 0]]] + pairs[:, 1].astype("i8")


def cells_of(folder):
    """Yields (cell, ids of its vertices), both numbered in the whole mesh."""
    tables, places = read_index((folder / "index").read_bytes())
    first_cell, first_vertex = array(tables, 2), array(tables, 3)
    for b, (file, codec, _, offset, stored, raw, _) in enumerate(places):
        assert codec == 0 and stored == raw
        with open(folder / "cells" / str(file), "rb") as records:
            records.seek(64 * offset)
            cells = sections(records.read(8 * raw), b"cell")
        lent = ghosts(cells, 3, b + array(cells, 1, "<i4"), first_vertex)
        ids = numpy.concatenate([lent, numpy.arange(first_vertex[b], first_vertex[b + 1])])
        for kind, corners in enumerate(CORNERS):
            vertices = array(cells, 56 + kind).reshape(-1, corners)
            listed = array(cells, 48 + kind) if 48 + kind in cells else range(len(vertices))
            yield from ((first_cell[b] + cell, set(ids[of])) for cell, of in zip(listed, vertices))
        vertices, begin, faces, of_faces = array(cells, 60), array(cells, 32), array(cells, 36), array(cells, 37)
        listed = array(cells, 52) if 52 in cells else range(max(len(faces) - 1, 0))
        for i, cell in enumerate(listed):
            loops = [vertices[begin[f] : begin[f + 1]] for f in of_faces[faces[i] : faces[i + 1]] // 2]
            yield first_cell[b] + cell, set(ids[numpy.concatenate(loops)])


@pytest.mark.parametrize("coarseness", [2, 4])
def test_another_program_reads_the_cells_from_their_blocks(tmp_path, coarseness):
    dataset = tmp_path / "demo.ciel"
    assert ciel("demo", "--coarseness", coarseness, "-o", dataset).returncode == 0
    mesh = zarr.open_group(str(dataset), mode="r")["meshes/0"]
    begin, loops = mesh["face_offset"][:].astype("i8"), mesh["face_vertex"][:]
    expected = [set() for _ in range(mesh["cell_types"].shape[0])]
    for face, sides in enumerate(zip(mesh["owner"][:], mesh["neighbour"][:])):
        for cell in sides:
            if cell != 2**32 - 1:
                expected[cell].update(loops[begin[face] : begin[face + 1]])
    found = dict(cells_of(pathlib.Path(dataset) / "meshes/0/blocks"))
    assert len(found) == len(expected)
    assert all(found[cell] == vertices for cell, vertices in enumerate(expected))
