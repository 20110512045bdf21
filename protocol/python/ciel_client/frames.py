"""Reads binary frames and joins their pieces (protocol/frame.md)."""

from __future__ import annotations

import json
import math
import struct
from array import array
from dataclasses import dataclass, field, replace
from typing import Any

from . import mesh_codec
from .frame_header import FIRST_OF_FRAME, FRAME_HEADER_BYTES, LAST_OF_FRAME, STILL, FrameHeader, read_frame_header


@dataclass
class Frame(FrameHeader):
    """A binary message of the server: header and payload."""

    payload: bytes = field(repr=False)

    @property
    def is_still(self) -> bool:
        return bool(self.flags & STILL)

    @property
    def is_last(self) -> bool:
        return bool(self.flags & LAST_OF_FRAME)

    @property
    def is_first(self) -> bool:
        return bool(self.flags & FIRST_OF_FRAME)


@dataclass
class Batch:
    """Polygons of one layer. `description`: the batch's JSON. `values.of` in it tells what `scalars` belong to."""

    description: dict[str, Any]
    positions: array[float]
    normals: array[float]
    scalars: array[float]
    indices: array[int]


def read_frame(message: bytes) -> Frame:
    """Reads one message: a frame or a piece of a frame. Raises ValueError if its header is damaged."""
    return Frame(**vars(read_frame_header(message)), payload=message[FRAME_HEADER_BYTES:])


class Pieces:
    """Joins the messages of one WebSocket to whole pictures and batches."""

    def __init__(self) -> None:
        self._begun: dict[int, list[Frame]] = {}

    def add(self, piece: Frame) -> Frame | None:
        """Returns the message that `piece` completes, or None. Raises ValueError when an earlier piece is missing."""
        if piece.piece_offset == 0:
            self._begun[piece.view] = []
        pieces = self._begun.get(piece.view, [])
        end = pieces[-1].piece_offset + len(pieces[-1].payload) if pieces else 0
        if piece.piece_offset != end or any(piece.frame != other.frame for other in pieces):
            raise ValueError(f"a piece of frame {piece.frame} of view {piece.view} is missing")
        pieces.append(piece)
        if end + len(piece.payload) < piece.whole_bytes:
            return None
        del self._begun[piece.view]
        flags = pieces[0].flags | piece.flags
        payload = b"".join(one.payload for one in pieces)
        return replace(piece, flags=flags, payload_bytes=len(payload), piece_offset=0, payload=payload)


class Batches:
    """Reads the batches of one view. Keeps their arrays as long as later batches may refer to them."""

    def __init__(self) -> None:
        self._kept: dict[str, tuple[int, Any]] = {}  # by id: last frame that had the arrays, and the arrays

    def read(self, frame: Frame) -> Batch:
        """Returns the batch of a message. Raises ValueError if its sizes are wrong or earlier arrays are missing."""
        payload = frame.payload
        (json_bytes,) = struct.unpack_from("<I", payload)
        description = json.loads(payload[4 : 4 + json_bytes])
        base = description["base"]
        self._kept = {key: kept for key, kept in self._kept.items() if kept[0] >= base}
        rest = payload[4 + json_bytes :]
        if description["batches"] == 0:
            return Batch(description, array("f"), array("f"), array("f"), array("I"))
        mesh = description["mesh"]
        if "bytes" in mesh:
            ends = mesh["bytes"][0], sum(mesh["bytes"])
            arrays = _mesh(description, rest[: ends[0]], rest[ends[0] : ends[1]])
            rest = rest[ends[1] :]
        else:
            arrays = self._of(mesh["id"])
        self._kept[mesh["id"]] = frame.frame, arrays
        scalars = array("f")
        if "values" in description:
            values = description["values"]
            if "bytes" in values:
                scalars = _values(description, rest[: values["bytes"]])
                rest = rest[values["bytes"] :]
            else:
                scalars = self._of(values["id"])
            self._kept[values["id"]] = frame.frame, scalars
        if rest:
            raise ValueError("the batch is longer than its description says")
        positions, normals, indices = arrays
        return Batch(description, positions, normals, scalars, indices)

    def _of(self, key: str) -> Any:
        if key not in self._kept:
            raise ValueError(f"the arrays {key} of a batch are missing; call view.resize to get all arrays again")
        return self._kept[key][1]


def _mesh(description: dict[str, Any], vertices: bytes, indices: bytes) -> tuple[array[float], array[float], array[int]]:
    step, low = description["mesh"]["step"], description["mesh"]["low"]
    stride = 16 if description["normals"] else 12
    record = struct.Struct("<3Ibbxx" if description["normals"] else "<3I")
    positions, normals = array("f"), array("f")
    for place in record.iter_unpack(mesh_codec.vertices(vertices, description["vertices"], stride)):
        positions.extend((low[axis] + place[axis]) * step for axis in range(3))
        if description["normals"]:
            normals.extend(_normal(place[3] / 127, place[4] / 127))
    decode = mesh_codec.triangles if description["kind"] == "triangles" else mesh_codec.sequence
    return positions, normals, decode(indices, description["indices"])


def _normal(x: float, y: float) -> tuple[float, float, float]:
    z = 1 - abs(x) - abs(y)
    if z < 0:
        x, y = math.copysign(1 - abs(y), x), math.copysign(1 - abs(x), y)
    length = math.sqrt(x * x + y * y + z * z)
    return x / length, y / length, z / length


def _values(description: dict[str, Any], data: bytes) -> array[float]:
    values = description["values"]
    corners = {"triangles": 3, "lines": 2, "points": 1}
    count = description["vertices"] if values["of"] == "vertices" else description["indices"] // corners[values["of"]]
    plain = mesh_codec.vertices(data, count, 4)
    if "step" not in values:
        return array("f", (value for (value,) in struct.iter_unpack("<f", plain)))
    origin, low, step = values["origin"], values["low"], values["step"]
    places = (place for (place,) in struct.iter_unpack("<I", plain))
    return array("d", (math.nan if place == 0xFFFFFFFF else origin + step * (low + place) for place in places))
