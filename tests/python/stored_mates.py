"""Reads the half-edges of a block, and its record `mates`. It knows no more than server/store/README.md."""

import itertools

import numpy
from stored_blocks import CORNERS, FACES
from stored_bytes import array, links


def standard_half_edges(block):
    return sum(len(block.listed(kind)) * sum(map(len, FACES[kind])) for kind in range(4))


def cell_faces(block):
    """Yields each face of each cell as (kind, local cell, half-edges, the local vertices that they leave, their local edges)."""
    first = 0
    for kind in range(4):
        sides = [[frozenset(side) for side in zip(face, face[1:] + face[:1])] for face in FACES[kind]]
        order = list(dict.fromkeys(itertools.chain(*sides)))
        edges = array(block.cells, 64 + kind).reshape(-1, len(order))
        for cell, corners, of_cell in zip(block.listed(kind), array(block.cells, 56 + kind).reshape(-1, CORNERS[kind]), edges):
            for face, of_face in zip(FACES[kind], sides):
                half_edges = numpy.arange(first, first + len(face))
                yield kind, cell, half_edges, corners[list(face)], of_cell[[order.index(side) for side in of_face]]
                first += len(face)
    vertices, edges, begin, first_face, of_cells = (array(block.cells, section) for section in (60, 68, 32, 36, 37))
    inner = block.counts[3]
    for i, cell in enumerate(block.listed(4)):
        for face, side in (divmod(f, 2) for f in of_cells[first_face[i] : first_face[i + 1]]):
            corners = numpy.arange(begin[face], begin[face + 1])
            half_edges = first + numpy.where(corners < inner, 2 * corners + side, inner + corners)
            if side == 0:
                yield 4, cell, half_edges, vertices[corners], edges[corners]
            else:  # against the stored loop
                yield 4, cell, half_edges[::-1], numpy.roll(vertices[corners[::-1]], 1), edges[corners[::-1]]


def polyhedral_mates(block):
    """Yields (half-edge, mate)."""
    first = standard_half_edges(block)
    bits = (array(block.mates, 19)[:, None] >> numpy.array([0, 4]) & 15).ravel()
    listed = dict(array(block.mates, 20, width=2))
    polyhedra = (of_face for of_face in cell_faces(block) if of_face[0] == 4)
    for _, faces in itertools.groupby(polyhedra, lambda of_face: of_face[1]):
        faces = [(half_edges.tolist(), edges.tolist()) for _, _, half_edges, _, edges in faces]
        for own, (half_edges, edges) in enumerate(faces):
            for half_edge, edge in zip(half_edges, edges):
                if bits[half_edge - first] == 15:
                    yield half_edge, first + listed[half_edge - first]
                    continue
                others = (i for i in range(bits[half_edge - first], len(faces), 15) if i != own and edge in faces[i][1])
                beyond, its_edges = faces[next(others)]
                yield half_edge, beyond[its_edges.index(edge)]


def twins(block):
    """Yields (half-edge, its twin as (block, half-edge) or None) for one half-edge of each face of a cell."""
    standard, inner = standard_half_edges(block), block.counts[3]
    neighbors = block.number + array(block.mates, 1, "i")
    beyond = [(neighbors[at], there) if at >= 0 else None for at, there in zip(links(block.mates, 17), array(block.mates, 18))]
    half_edge = 0
    for kind in range(4):
        for twin, face in zip(links(block.mates, 88 + kind), itertools.cycle(FACES[kind])):
            yield half_edge, None if twin < 0 else (block.number, twin) if twin < standard else beyond[twin - standard]
            half_edge += len(face)
    corners = array(block.cells, 32)[:-1]
    for corner in corners[: block.counts[5]]:
        pair = standard + 2 * corner
        yield from ((pair, (block.number, pair + 1)), (pair + 1, (block.number, pair)))
    first_twin = array(block.mates, 16)[0]
    yield from zip(standard + inner + corners[block.counts[5] :], beyond[first_twin:])
