"""Reads the blocks of a dataset. It knows no more than server/store/README.md."""

import struct

import numpy

CORNERS = (4, 8, 6, 5)  # of tetrahedra, hexahedra, wedges, pyramids
FACES = (
    ((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1)),
    ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)),
    ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)),
    ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
)


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
    """Yields (cell, kind, ids of vertices), numbered in the whole mesh. Kinds 0 to 3 have one array, the corners of the
    shape; polyhedra, kind 4, have one for each face."""
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
            yield from ((first_cell[b] + cell, kind, [ids[of]]) for cell, of in zip(listed, vertices))
        vertices, begin, faces, of_faces = array(cells, 60), array(cells, 32), array(cells, 36), array(cells, 37)
        listed = array(cells, 52) if 52 in cells else range(max(len(faces) - 1, 0))
        for i, cell in enumerate(listed):
            yield first_cell[b] + cell, 4, [ids[vertices[begin[f] : begin[f + 1]]] for f in of_faces[faces[i] : faces[i + 1]] // 2]


def faces_of(kind, vertices):
    """Returns the faces of a cell as arrays of vertices."""
    return vertices if kind == 4 else [vertices[0][list(face)] for face in FACES[kind]]
