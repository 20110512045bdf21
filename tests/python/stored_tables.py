"""Reads the ranges beside a chunk, and the table of steps. It knows no more than server/store/README.md."""

import json
import struct

import numpy
from stored_bytes import check_end, check_head, xxh3

STRETCH = 65536


def read_ranges(file):
    """Returns what `ranges/<chunk>` has, by the words of the README; `histograms` as (minimum, maximum, others, counts)."""
    data = file.read_bytes()
    check_end(data)
    blocks, scalars, checksum, limits, low, high, absent, histograms, stretches = struct.unpack_from("<3Q8s5Q", data, 64)

    def by_block(kind, at):
        return numpy.frombuffer(data, kind, scalars * blocks, at).reshape(scalars, blocks)

    limits = limits.rstrip(b"\0").decode()
    of_scalars = [struct.unpack_from("<ddQ256Q", data, histograms + 2072 * i) for i in range(scalars if histograms else 0)]
    return {
        "id": check_head(data, b"rang"), "checksum": checksum, "type": limits,
        "lower": by_block(limits, low), "upper": by_block(limits, high), "without": by_block("<u4", absent),
        "histograms": [(minimum, maximum, others, counts) for minimum, maximum, others, *counts in of_scalars],
        "stretches": numpy.frombuffer(data[stretches:-8] if stretches else b"", "<u8").tolist(),
    }


def stretches_of(chunk):
    return [xxh3(chunk[at : at + STRETCH]) for at in range(0, len(chunk), STRETCH)]


def read_steps(dataset):
    """Returns the steps of the table in the form of the marker's `steps`."""
    table = json.loads((dataset / "steps.json").read_text())["table"]
    rows, arrays = ((dataset / "steps" / name).read_bytes() for name in ("rows", "arrays"))
    assert check_head(rows, b"strw") == check_head(arrays, b"star")
    rows = rows[64 : 64 + 40 * table["steps"]]
    assert f"xxh3:{xxh3(rows):016x}" == table["checksum"]
    steps = []
    for time, mesh, coordinates, at, length, count, checksum in struct.iter_unpack("<dIIQIIQ", rows):
        of_step = arrays[at : at + length]
        assert xxh3(of_step) == checksum, f"the arrays of the step at {time}"
        steps.append({"time": time, "mesh": mesh, "coordinates": coordinates, "arrays": read_arrays(of_step, count, table)})
    return steps


def read_arrays(data, count, table):
    arrays, at = {}, 0
    for _ in range(count):
        number, flags, chunk, checksum, invalid, missing, low, high, components, extremes = struct.unpack_from("<II4QddII", data, at)
        at += 64
        array = {"chunk": chunk, "invalid": invalid, "missing": missing}
        if flags & 1:
            array["checksum"] = f"xxh3:{checksum:016x}"
        pairs = list(struct.iter_unpack("<dd", data[at : at + 16 * components]))
        at += 16 * components
        if flags & 2:
            array |= {"range": [low, high], "component_ranges": [list(pair) for pair in pairs]}
        ends = struct.iter_unpack("<Q3dQ3d", data[at : at + 64 * extremes])
        array["extremes"] = [{"lowest": {"cell": end[0], "place": list(end[1:4])}, "highest": {"cell": end[4], "place": list(end[5:])}}
                             for end in ends]
        at += 64 * extremes
        arrays[table["arrays"][number]["name"]] = array | ({"lazy": True} if flags & 4 else {})
    assert at == len(data)
    return arrays
