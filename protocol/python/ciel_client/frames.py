"""Binary frames and their pieces (protocol/frame.md)."""

from __future__ import annotations

import json
import struct
from array import array
from dataclasses import dataclass, field, replace
from typing import Any

HEADER = struct.Struct("<4sBBHIIQIIdffffIIII8x")
IMAGE, GEOMETRY = 1, 2
STILL, LAST, FIRST = 1, 2, 4


@dataclass
class Frame:
    kind: int
    flags: int
    view: int
    frame: int
    revision: int
    width: int
    height: int
    time: float
    wait_ms: float
    extract_ms: float
    draw_ms: float
    encode_ms: float
    triangles: int
    whole_bytes: int
    piece_offset: int
    payload: bytes = field(repr=False)

    @property
    def is_still(self) -> bool:
        return bool(self.flags & STILL)

    @property
    def is_last(self) -> bool:
        return bool(self.flags & LAST)

    @property
    def is_first(self) -> bool:
        return bool(self.flags & FIRST)


@dataclass
class Batch:
    """Polygons of one layer; `description` is the batch's JSON."""

    description: dict[str, Any]
    positions: array[float]
    normals: array[float]
    scalars: array[float]
    indices: array[int]


def read_frame(message: bytes) -> Frame:
    """One message: a piece of a frame, or a whole one."""
    if len(message) < HEADER.size:
        raise ValueError(f"a frame has at least {HEADER.size} bytes, this one {len(message)}")
    magic, version, *fields, payload_bytes, whole_bytes, piece_offset = HEADER.unpack_from(message)
    if magic != b"CIEL" or version != 2:
        raise ValueError("not a CIEL frame of version 2")
    payload = message[HEADER.size :]
    if len(payload) != payload_bytes:
        raise ValueError(f"the frame announces {payload_bytes} bytes of payload and has {len(payload)}")
    return Frame(*fields, whole_bytes, piece_offset, payload)


class Pieces:
    """Makes whole pictures and batches of the messages of one WebSocket."""

    def __init__(self) -> None:
        self._begun: dict[int, list[Frame]] = {}

    def add(self, piece: Frame) -> Frame | None:
        """The whole that `piece` completes, or None. Raises ValueError when a piece before it is missing."""
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
        return replace(piece, flags=flags, piece_offset=0, payload=b"".join(one.payload for one in pieces))


def read_batch(payload: bytes) -> Batch:
    (json_bytes,) = struct.unpack_from("<I", payload)
    description = json.loads(payload[4 : 4 + json_bytes])
    at = 4 + json_bytes
    arrays = []
    vertices = description["vertices"]
    for code, count in (
        ("f", 3 * vertices),
        ("f", 3 * vertices * description.get("normals", False)),
        ("f", vertices * description.get("scalars", False)),
        ("I", description["indices"]),
    ):
        values = array(code)
        values.frombytes(payload[at : at + 4 * count])
        at += 4 * count
        arrays.append(values)
    if at != len(payload):
        raise ValueError("the batch's length does not fit its description")
    return Batch(description, *arrays)
