"""Binary frames (protocol/frame.md)."""

from __future__ import annotations

import json
import struct
from array import array
from dataclasses import dataclass, field
from typing import Any

HEADER = struct.Struct("<4sBBHIIQIIdffffII16x")
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
    if len(message) < HEADER.size:
        raise ValueError(f"a frame has at least {HEADER.size} bytes, this one {len(message)}")
    magic, version, *fields, payload_bytes = HEADER.unpack_from(message)
    if magic != b"CIEL" or version != 1:
        raise ValueError("not a CIEL frame of version 1")
    payload = message[HEADER.size :]
    if len(payload) != payload_bytes:
        raise ValueError(f"the frame announces {payload_bytes} bytes of payload and has {len(payload)}")
    return Frame(*fields, payload)


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
