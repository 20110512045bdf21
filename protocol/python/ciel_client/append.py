"""Converts the arrays of a time step to bytes and splits them into pieces for upload (append.begin in openrpc.json)."""

from __future__ import annotations

import struct
import sys
from array import array
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

HEADER = struct.Struct("<4sBBH16sIIQ")
PIECE = 16
ITEM_TYPE = {"float32": "<f4", "float64": "<f8"}
FITS_FLOAT32 = {"f2", "f4", "b1", "i1", "i2", "u1", "u2"}


@dataclass
class Pushed:
    """One array of an upload. `wanted`: its entry in the params of append.begin. `data`: its values, little-endian."""

    wanted: dict[str, Any]
    data: memoryview


def pushed(name: str, values: Any) -> Pushed:
    """Converts an array for upload.

    `values`: a NumPy array of one or two dimensions (values x components), or any sequence of numbers. If float32 can
    represent all values of the type (float32, float16, bool, integers of 8 and 16 bits), the array is sent as float32.
    Arrays of all other types are sent as float64.
    """
    wanted: dict[str, Any] = {"name": name, "type": "float64"}
    if hasattr(values, "astype"):
        if values.ndim not in (1, 2):
            raise ValueError(f"array '{name}' must have one or two dimensions: values, or values x components")
        if values.ndim == 2:
            wanted["components"] = int(values.shape[1])
        if values.dtype.kind + str(values.dtype.itemsize) in FITS_FLOAT32:
            wanted["type"] = "float32"
        data = values.astype(ITEM_TYPE[wanted["type"]]).tobytes()
    else:
        doubles = array("d", values)
        if sys.byteorder == "big":
            doubles.byteswap()
        data = doubles.tobytes()
    return Pushed(wanted, memoryview(data))


def check_sizes(arrays: list[Pushed], upload: Mapping[str, Any]) -> None:
    for one, expected in zip(arrays, upload["arrays"], strict=True):
        if len(one.data) != expected["bytes"]:
            found = len(one.data) // int(ITEM_TYPE[one.wanted["type"]][2:])
            raise ValueError(
                f"array '{expected['name']}' has {found} values; it must have {expected['tuples']} x "
                f"{expected['components']}, in the order of the imported file"
            )


def pieces(arrays: list[Pushed], piece_bytes: int) -> Iterator[tuple[int, int, memoryview]]:
    """Yields (index of the array, byte offset in the array, bytes) for each piece."""
    for number, one in enumerate(arrays):
        for offset in range(0, len(one.data), piece_bytes):
            yield number, offset, one.data[offset : offset + piece_bytes]


def message(upload: str, number: int, offset: int, data: memoryview) -> bytes:
    """Returns the binary message of one piece (protocol/frame.md)."""
    return HEADER.pack(b"CIEL", 1, PIECE, 0, bytes.fromhex(upload), number, len(data), offset) + data
