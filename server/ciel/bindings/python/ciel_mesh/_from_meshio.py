"""Converts a meshio.Mesh to a Mesh."""

import itertools

import numpy

from ._kernel import Mesh

POLYHEDRON = 42
# VTK's cell type number for each cell type of meshio. meshio has the nodes of a cell in VTK's order: corners first.
TYPES = {
    "vertex": 1,
    "line": 3,
    "triangle": 5,
    "quad": 9,
    "tetra": 10,
    "hexahedron": 12,
    "wedge": 13,
    "pyramid": 14,
    "line3": 21,
    "triangle6": 22,
    "quad8": 23,
    "tetra10": 24,
    "hexahedron20": 25,
    "wedge15": 26,
    "pyramid13": 27,
    "quad9": 28,
    "hexahedron27": 29,
    "quad6": 30,
    "wedge12": 31,
    "wedge18": 32,
    "hexahedron24": 33,
    "triangle7": 34,
}


def _type_of(name):
    number = POLYHEDRON if name.startswith("polyhedron") else TYPES.get(name)
    if number is None:
        raise ValueError(f"cells of the type {name!r} are not supported; supported are polyhedra, {', '.join(TYPES)}")
    return number


def _face_stream(cells):
    """Return the faces of polyhedra as a face stream of VTK, and the index in the stream at which each cell begins."""
    streams = [
        list(itertools.chain([len(faces)], *([len(face), *face] for face in faces)))
        for faces in cells
    ]
    begins = numpy.cumsum([0] + [len(stream) for stream in streams])[:-1]
    return numpy.fromiter(itertools.chain.from_iterable(streams), numpy.int64), begins


def from_meshio(mesh):
    """Return the Mesh of a meshio.Mesh.

    Points have the same numbers as in `mesh`, so that point data of `mesh` can be passed to contour(). Cells are
    numbered through all blocks of `mesh.cells`, in order. Cells without volume are left out, but count in this
    numbering. Raises ValueError if `mesh` has no cells, or cells of an unknown type.
    """
    types, sizes, nodes, locations, streams = [], [], [], [], []
    stream_length = 0
    for block in mesh.cells:
        number, count = _type_of(block.type), len(block.data)
        if count == 0:
            continue
        types.append(numpy.full(count, number, numpy.uint8))
        if number == POLYHEDRON:
            stream, begins = _face_stream(block.data)
            sizes.append(numpy.zeros(count, numpy.int64))
            locations.append(begins + stream_length)
            streams.append(stream)
            stream_length += len(stream)
        else:
            rows = numpy.asarray(block.data, numpy.int64).reshape(count, -1)
            sizes.append(numpy.full(count, rows.shape[1], numpy.int64))
            nodes.append(rows.ravel())
            locations.append(numpy.full(count, -1, numpy.int64))
    if not types:
        raise ValueError("the mesh has no cells; pass a mesh that has cells")
    faces = {}
    if streams:
        faces = {"face_locations": numpy.concatenate(locations), "faces": numpy.concatenate(streams)}
    return Mesh.from_cells(
        numpy.asarray(mesh.points, numpy.float64),
        numpy.concatenate(types),
        numpy.concatenate([[0], numpy.cumsum(numpy.concatenate(sizes))]).astype(numpy.int64),
        numpy.concatenate(nodes or [numpy.zeros(0, numpy.int64)]),
        **faces,
    )
