"""Reads the record `around` of a block: what leads around its vertices. It knows no more than server/store/README.md."""

import numpy
from stored_bytes import array, links


def entry_lists(block):
    """Returns the entries of each local vertex. An entry is the place of a corner among all corners of the block."""
    following = numpy.concatenate([links(block.around, 80 + kind) for kind in range(5)]).tolist()
    lists = [[first] for first in links(block.around, 8).tolist()]
    for entries in lists:
        while following[entries[-1]] >= 0:
            entries.append(following[entries[-1]])
    return lists


def ring(block):
    """Returns by border vertex: its local number, the next block that has it, its place there."""
    neighbors = block.number + array(block.around, 1, "i")
    return array(block.around, 9), neighbors[array(block.around, 10)], array(block.around, 11)
