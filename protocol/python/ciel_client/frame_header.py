"""Generated from protocol/frame_header.json; do not edit."""

import struct
from dataclasses import astuple, dataclass

FRAME_HEADER = struct.Struct("<4sBBHIIQIIdffffIIII8x")
FRAME_HEADER_BYTES = 80
IMAGE, GEOMETRY = 1, 2
STILL, LAST_OF_FRAME, FIRST_OF_FRAME = 1, 2, 4


@dataclass
class FrameHeader:
    kind: int
    flags: int
    view: int  # number of the view, from `view.open`
    frame: int  # number of the frame, from 1 in each view
    revision: int  # revision of the scene that the frame shows
    width: int  # width in pixels of the picture, or of the view
    height: int  # height in pixels of the picture, or of the view
    time: float  # simulation time shown
    wait_ms: float  # time from the newest change to the start of the work
    extract_ms: float  # time for iso-surfaces and slices
    draw_ms: float  # time for drawing and reading back
    encode_ms: float  # time for the compression of the payload
    triangles: int  # triangles in the whole frame
    payload_bytes: int  # size of the payload of this message
    whole_bytes: int  # size of the whole picture or batch
    piece_offset: int  # offset of this message's payload in the whole


def read_frame_header(message: bytes) -> FrameHeader:
    """Raises ValueError on a bad magic, version, kind, flag or size."""
    if len(message) < FRAME_HEADER_BYTES:
        raise ValueError(f"a binary frame has {len(message)} bytes; its header alone has 80")
    magic, version, *fields = FRAME_HEADER.unpack_from(message)
    header = FrameHeader(*fields)
    if magic != b"CIEL":
        raise ValueError("a binary frame does not begin with 'CIEL'")
    if version != 2:
        raise ValueError(
            f"a binary frame is of version {version}; this program reads version 2. "
            "Reload the page, or update the client"
        )
    if header.kind not in (1, 2):
        raise ValueError(f"a binary frame is of kind {header.kind}; the known kinds are 1 (image) and 2 (geometry)")
    if header.flags & ~7:
        raise ValueError(f"a binary frame has unknown flags {header.flags}")
    payload = len(message) - FRAME_HEADER_BYTES
    if payload != header.payload_bytes:
        raise ValueError(f"a binary frame announces {header.payload_bytes} bytes after its header and has {payload}")
    if header.piece_offset + header.payload_bytes > header.whole_bytes:
        raise ValueError(
            f"a binary frame has {header.payload_bytes} bytes at offset {header.piece_offset}, "
            f"but the whole frame has only {header.whole_bytes}"
        )
    return header


def write_frame_header(header: FrameHeader) -> bytes:
    return FRAME_HEADER.pack(b"CIEL", 2, *astuple(header))
