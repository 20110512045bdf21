"""Reads the index of the blocks of a mesh, and their cells. It knows no more than server/store/README.md."""

import struct

import numpy
from stored_bytes import array, check_end, check_head, sections, xxh3

CORNERS = (4, 8, 6, 5)  # of tetrahedra, hexahedra, wedges, pyramids
FACES = (
    ((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1)),
    ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)),
    ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)),
    ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
)
RECORDS = (("cells", b"cell"), ("around", b"roun"), ("mates", b"mate"))


class Block:
    """`cells`, `around`, `mates`: sections of the records. `vertices`, `edges`: numbers in the mesh, by local number."""

    def __init__(self, number, records, tables):
        self.number, (self.cells, self.around, self.mates) = number, records
        self.first_cell, self.counts = array(tables, 2)[number], array(self.cells, 2)
        self.vertices, self.edges = self._numbers(3, array(tables, 3)), self._numbers(4, array(tables, 4))

    def _numbers(self, section, first):
        ghosts = array(self.cells, section, width=2)
        owners = self.number + array(self.cells, 1, "i")[ghosts[:, 0]]
        return numpy.concatenate([first[owners] + ghosts[:, 1], numpy.arange(*first[self.number : self.number + 2])])

    def listed(self, kind):
        """Returns the local cells of a kind."""
        every = numpy.arange(self.counts[0] if 56 + kind in self.cells else 0)
        return array(self.cells, 48 + kind) if 48 + kind in self.cells else every


def read_blocks(folder):
    """Returns the bounds, the sections of the tables, and the blocks."""
    index = (folder / "index").read_bytes()
    check_head(index, b"indx"), check_end(index)
    *bounds, count, tables, length, places = struct.unpack_from("<6d4Q", index, 64)
    *files, sizes = struct.unpack_from("<4Q", index, 144)
    tables = sections(index[tables : tables + length], b"tabl")
    places, sizes = struct.iter_unpack("<HBBIIIQ", index[places:sizes]), struct.iter_unpack("<Q", index[sizes:-8])
    records = []
    for (name, kind), n in zip(RECORDS, files):
        data = [(folder / name / str(file)).read_bytes() for file in range(n)]
        assert [(len(of_file),) for of_file in data] == [next(sizes) for _ in data], f"sizes of {name}"
        for b in range(count):
            file, codec, _, at, stored, raw, checksum = next(places)
            record = data[file][64 * at : 64 * at + 8 * raw]
            assert codec == 0 and stored == raw and xxh3(record) == checksum, f"{name} of block {b}"
            records.append(sections(record, kind))
    return bounds, tables, [Block(b, records[b::count], tables) for b in range(count)]


def cells_of(block):
    """Yields (cell, kind, faces), numbered in the whole mesh. A face is an array of vertices, wound outwards."""
    for kind, corners in enumerate(CORNERS):
        for cell, of in zip(block.listed(kind), array(block.cells, 56 + kind).reshape(-1, corners)):
            yield block.first_cell + cell, kind, [block.vertices[of[list(face)]] for face in FACES[kind]]
    corners, begin, first, of_cells = (array(block.cells, section) for section in (60, 32, 36, 37))
    loops = [block.vertices[corners[begin[f] : begin[f + 1]]] for f in range(len(begin) - 1)]
    for i, cell in enumerate(block.listed(4)):
        yield block.first_cell + cell, 4, [loops[f // 2][:: 1 - 2 * (f % 2)] for f in of_cells[first[i] : first[i + 1]]]
