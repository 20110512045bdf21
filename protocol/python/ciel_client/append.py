"""Prepares a time step for upload to a server: its arrays as bytes, cut into pieces (append.begin in openrpc.json)."""

from __future__ import annotations

import struct
import sys
from array import array
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

HEADER = struct.Struct("<4sBBH16sIIQ")
PIECE = 16


@dataclass
class Pushed:
    """One array of an upload: its entry in the params of append.begin, and its values as little-endian float32."""

    wanted: dict[str, Any]
    data: memoryview


def pushed(name: str, values: Any) -> Pushed:
    """Converts an array for upload.

    `values`: a NumPy array of one or two dimensions (values x components), or any sequence of numbers.
    """
    wanted: dict[str, Any] = {"name": name}
    if hasattr(values, "astype"):
        if values.ndim not in (1, 2):
            raise ValueError(f"array '{name}' must have one or two dimensions: values, or values x components")
        if values.ndim == 2:
            wanted["components"] = int(values.shape[1])
        data = values.astype("<f4").tobytes()
    else:
        floats = array("f", values)
        if sys.byteorder == "big":
            floats.byteswap()
        data = floats.tobytes()
    return Pushed(wanted, memoryview(data))


def check_sizes(arrays: list[Pushed], upload: Mapping[str, Any]) -> None:
    for one, expected in zip(arrays, upload["arrays"], strict=True):
        if len(one.data) != expected["bytes"]:
            raise ValueError(
                f"array '{expected['name']}' has {len(one.data) // 4} values where {expected['tuples']} x "
                f"{expected['components']} are needed, in the order of the imported file"
            )


def pieces(arrays: list[Pushed], piece_bytes: int) -> Iterator[tuple[int, int, memoryview]]:
    """Yields (index of the array, byte offset in the array, bytes) for each piece."""
    for number, one in enumerate(arrays):
        for offset in range(0, len(one.data), piece_bytes):
            yield number, offset, one.data[offset : offset + piece_bytes]


def message(upload: str, number: int, offset: int, data: memoryview) -> bytes:
    """Returns the binary message of one piece (protocol/frame.md)."""
    return HEADER.pack(b"CIEL", 1, PIECE, 0, bytes.fromhex(upload), number, len(data), offset) + data
