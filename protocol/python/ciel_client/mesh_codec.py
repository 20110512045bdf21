"""Decoders of meshoptimizer's bitstreams, as glTF's EXT_meshopt_compression describes them: vertices (0xA0), triangles
(0xE1) and sequences of indices (0xD1). They are slow, for checks and small scripts: a million triangles take about a
minute."""

from __future__ import annotations

from array import array


def vertices(data: bytes, count: int, stride: int) -> bytes:
    """Decodes `count` records of `stride` bytes. Raises ValueError if the data is not such a stream."""
    if not data or data[0] != 0xA0:
        raise ValueError("the data is not a vertex stream of version 0")
    block_size = min(8192 // stride & ~15, 256)
    last = bytearray(data[len(data) - stride :])
    out = bytearray(count * stride)
    at = 1
    try:
        for first in range(0, count, block_size):
            size = min(block_size, count - first)
            for byte in range(stride):
                deltas, at = _deltas(data, at, size)
                value = last[byte]
                place = first * stride + byte
                for delta in deltas:
                    value = (value + (delta >> 1 ^ -(delta & 1))) & 0xFF
                    out[place] = value
                    place += stride
                last[byte] = value
    except IndexError:
        raise ValueError("a vertex stream is cut off") from None
    if at + max(stride, 32) != len(data):
        raise ValueError("a vertex stream has the wrong length")
    return bytes(out)


def _deltas(data: bytes, at: int, size: int) -> tuple[list[int], int]:
    """Decodes the deltas of one byte position, for all vertices of a block. Deltas are in groups of 16.

    A group has 0, 2, 4 or 8 bits per delta. Returns the deltas, and the offset in `data` after the deltas.
    """
    groups = (size + 15) // 16
    modes = at
    at += (groups + 3) // 4
    out: list[int] = []
    for group in range(groups):
        bits = (0, 2, 4, 8)[data[modes + group // 4] >> 2 * (group % 4) & 3]
        if bits == 0:
            out += bytes(16)
        elif bits == 8:
            out += data[at : at + 16]
            at += 16
        else:
            packed = at
            at += 2 * bits
            most = (1 << bits) - 1
            for i in range(16):
                place = i * bits
                delta = data[packed + place // 8] >> 8 - bits - place % 8 & most
                if delta == most:  # too large for the bits: the delta follows as a whole byte
                    delta = data[at]
                    at += 1
                out.append(delta)
    return out[:size], at


def _varint(data: bytes, at: int) -> tuple[int, int]:
    value = shift = 0
    while True:
        byte = data[at]
        at += 1
        value |= (byte & 0x7F) << shift
        shift += 7
        if byte < 0x80:
            return value, at


def sequence(data: bytes, count: int) -> array[int]:
    """Decodes `count` indices of lines or points. Raises ValueError if the data is not such a stream."""
    if not data or data[0] != 0xD1:
        raise ValueError("the data is not a sequence of indices of version 1")
    out = array("I")
    last = [0, 0]
    at = 1
    try:
        for _ in range(count):
            value, at = _varint(data, at)
            which, value = value & 1, value >> 1
            last[which] = (last[which] + (value >> 1 ^ -(value & 1))) & 0xFFFFFFFF
            out.append(last[which])
    except IndexError:
        raise ValueError("a sequence of indices is cut off") from None
    if at + 4 != len(data):
        raise ValueError("a sequence of indices has the wrong length")
    return out


class _Triangles:
    def __init__(self, data: bytes, triangles: int) -> None:
        self.data = data
        self.at = 1 + triangles  # offset of the data that follows the one-byte codes of the triangles
        self.next = self.last = 0
        self.edges = [(0, 0)] * 16
        self.corners = [0] * 16

    def edge(self, a: int, b: int) -> None:
        self.edges.insert(0, (a, b))
        self.edges.pop()

    def corner(self, vertex: int) -> int:
        self.corners.insert(0, vertex)
        self.corners.pop()
        return vertex

    def new(self) -> int:
        self.next += 1
        return self.next - 1

    def free(self) -> int:
        value, self.at = _varint(self.data, self.at)
        self.last = (self.last + (value >> 1 ^ -(value & 1))) & 0xFFFFFFFF
        return self.last

    def beside(self, edge: int, code: int) -> tuple[int, int, int]:
        """Decodes a triangle that shares an edge with an earlier triangle."""
        a, b = self.edges[edge]
        if code == 0:
            c = self.corner(self.new())
        elif code < 0xD:
            c = self.corners[code]
        elif code == 0xF:
            c = self.corner(self.free())
        else:
            self.last += 1 if code == 0xE else -1
            c = self.corner(self.last)
        self.edge(c, b)
        self.edge(a, c)
        return a, b, c

    def alone(self, code: int) -> tuple[int, int, int]:
        if code < 0xE:
            aux = self.data[len(self.data) - 16 + code]
            a = self.new()
        else:
            aux = self.data[self.at]
            self.at += 1
            if aux == 0:
                self.next = 0
            a = self.new() if code == 0xE else -1
        kinds = aux >> 4, aux & 15
        if code == 0xF:
            a = self.free()
        found = []
        for kind in kinds:
            if kind == 0:
                found.append(self.new())
            elif kind == 0xF and code >= 0xE:
                found.append(self.free())
            else:
                found.append(self.corners[kind - 1])
        b, c = found
        self.corner(a)
        for kind, vertex in zip(kinds, found):
            if kind == 0 or (kind == 0xF and code >= 0xE):
                self.corner(vertex)
        self.edge(b, a)
        self.edge(c, b)
        self.edge(a, c)
        return a, b, c


def triangles(data: bytes, count: int) -> array[int]:
    """Decodes `count` indices, three per triangle. Raises ValueError if the data is not such a stream."""
    if not data or data[0] != 0xE1:
        raise ValueError("the data is not a triangle stream of version 1")
    out = array("I")
    state = _Triangles(data, count // 3)
    try:
        for i in range(count // 3):
            code = data[1 + i]
            edge, low = code >> 4, code & 15
            out.extend(state.beside(edge, low) if edge < 0xF else state.alone(low))
    except (IndexError, OverflowError):
        raise ValueError("a triangle stream is damaged") from None
    if state.at + 16 != len(data):
        raise ValueError("a triangle stream has the wrong length")
    return out
