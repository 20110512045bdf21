"""Writes a dataset by the documented format alone: a box of hexahedra with `r` (distance from a moving center) and `x`."""

import ctypes
import json
import pathlib

import numpy as np

NO_NEIGHBOUR = 4294967295

_xxhash = ctypes.CDLL("libxxhash.so.0")
_xxhash.XXH3_64bits.restype = ctypes.c_uint64
_xxhash.XXH3_64bits.argtypes = [ctypes.c_char_p, ctypes.c_size_t]


def checksum(data: bytes) -> str:
    return f"xxh3:{_xxhash.XXH3_64bits(data, len(data)):016x}"


def write_array(folder: pathlib.Path, values: np.ndarray, chunked: bool = False) -> list[str]:
    """Writes one chunk, or with `chunked` one per entry of the first axis. Returns the chunks' checksums."""
    folder.mkdir(parents=True)
    chunks = (1, *values.shape[1:]) if chunked else values.shape
    dtype = values.dtype.str
    fill = "NaN" if values.dtype.kind == "f" else 0
    document = {"zarr_format": 2, "shape": list(values.shape), "chunks": list(chunks), "dtype": dtype, "compressor": None,
                "fill_value": fill, "order": "C", "filters": None}
    (folder / ".zarray").write_text(json.dumps(document))
    pieces = list(values) if chunked else [values]
    sums = []
    for i, piece in enumerate(pieces):
        data = np.ascontiguousarray(piece).tobytes()
        (folder / ".".join([str(i)] + ["0"] * (values.ndim - 1))).write_bytes(data)
        sums.append(checksum(data))
    return sums


def box_faces(n: int):
    """Returns face_vertex [F, 4], owner and neighbor, sorted by owner. Normals point out of the owner."""
    cells = np.arange(n**3, dtype=np.int64).reshape(n, n, n)  # indexed z, y, x
    points = np.arange((n + 1) ** 3, dtype=np.int64).reshape(n + 1, n + 1, n + 1)
    loops, owners, neighbours = [], [], []
    # The lower and the upper face of every cell across each axis. Arrays are indexed z, y, x.
    for axis in range(3):
        u, v = [(1, 2), (2, 0), (0, 1)][axis]
        for high in (0, 1):
            corners = []
            for du, dv in ((0, 0), (0, 1), (1, 1), (1, 0)):
                shift = [0, 0, 0]
                shift[axis], shift[u], shift[v] = high, du, dv
                z, y, x = shift
                corners.append(points[z : z + n, y : y + n, x : x + n])
            quad = np.stack(corners, axis=-1)
            if not high:
                quad = quad[..., ::-1]
            other = np.full((n, n, n), NO_NEIGHBOUR, dtype=np.int64)
            inside = [slice(None)] * 3
            inside[axis] = slice(0, n - 1) if high else slice(1, n)
            source = [slice(None)] * 3
            source[axis] = slice(1, n) if high else slice(0, n - 1)
            other[tuple(inside)] = cells[tuple(source)]
            keep = (other == NO_NEIGHBOUR) | (cells < other)
            loops.append(quad[keep])
            owners.append(cells[keep])
            neighbours.append(other[keep])
    loop, owner, neighbour = np.concatenate(loops), np.concatenate(owners), np.concatenate(neighbours)
    order = np.lexsort((neighbour, owner))
    return loop[order], owner[order], neighbour[order]


def write_box(directory: pathlib.Path, n: int = 12, steps: int = 4, holes: bool = False) -> pathlib.Path:
    """`holes`: also writes `m`, which equals `x` but has no value where x > 0."""
    loop, owner, neighbour = box_faces(n)
    axis = np.linspace(-1, 1, n + 1, dtype=np.float32)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    positions = np.stack([x, y, z], axis=-1).reshape(-1, 3).astype("<f4")
    vertices, cells, faces = len(positions), n**3, len(loop)

    mesh = directory / "meshes" / "0"
    mesh.mkdir(parents=True)
    for group in (directory, directory / "meshes", mesh):
        (group / ".zgroup").write_text('{"zarr_format": 2}')
    arrays = {
        "cell_types": np.full(cells, 12, dtype="|u1"),
        "face_offset": np.arange(0, 4 * faces + 1, 4, dtype="<u8"),
        "face_vertex": loop.reshape(-1).astype("<u4"),
        "owner": owner.astype("<u4"),
        "neighbour": neighbour.astype("<u4"),
        "original_vertex": np.arange(vertices, dtype="<u4"),
        "original_cell": np.arange(cells, dtype="<u4"),
    }
    checksums = {name: write_array(mesh / name, values)[0] for name, values in arrays.items()}
    coordinate_checksums = write_array(mesh / "positions", positions[None], chunked=True)

    times = [0.5 * i for i in range(steps)]
    fields = {
        "r": np.stack([np.linalg.norm(positions - [0.3 * t, 0, 0], axis=1) for t in times]).astype("<f4"),
        "x": np.stack([positions[:, 0] for _ in times]).astype("<f4"),
    }
    if holes:
        fields["m"] = np.where(fields["x"] > 0, np.float32(np.nan), fields["x"])
    marked = [{"time": t, "arrays": {}} for t in times]
    (mesh / "arrays").mkdir()
    (mesh / "arrays" / ".zgroup").write_text('{"zarr_format": 2}')
    for name, values in fields.items():
        sums = write_array(mesh / "arrays" / name, values, chunked=True)
        attributes = {"name": name, "association": "point", "components": 1, "units": "", "description": ""}
        (mesh / "arrays" / name / ".zattrs").write_text(json.dumps({"ciel": attributes}))
        for i, step in enumerate(marked):
            step["arrays"][name] = {"chunk": i, "checksum": sums[i]}

    edges = 3 * n * (n + 1) ** 2
    boundary = int(np.count_nonzero(neighbour == NO_NEIGHBOUR))
    counts = {"vertices": vertices, "edges": edges, "faces": faces, "half_edges": 24 * cells, "boundary_faces": boundary,
              "components": 1, "cells": cells}
    (mesh / ".zattrs").write_text(json.dumps({"ciel": {
        "origin": [0, 0, 0], "bounds": [-1, 1, -1, 1, -1, 1], "counts": counts, "cells": {"hexahedron": cells}, "groups": [],
        "checksums": checksums, "coordinate_checksums": coordinate_checksums}}))
    (directory / ".zattrs").write_text(json.dumps({"ciel": {
        "format_version": 1, "id": f"box-{n}-{steps}", "source": "box_dataset.py", "created": "2026-01-01T00:00:00Z",
        "length_units": "m", "input": {"vertices": vertices, "edges": edges, "cells": cells}, "notes": []}}))
    (directory / "steps.json").write_text(json.dumps({"ciel_steps": 1, "meshes": 1, "steps": marked}))
    return directory
