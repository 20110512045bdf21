"""Reads what the binary files of a dataset have in common. It knows no more than server/store/README.md."""

import struct

import numpy
from box_dataset import checksum


def xxh3(data):
    return int(checksum(data)[5:], 16)


def check_head(data, kind):
    """Returns the id of the dataset."""
    assert data[:16] == b"\x89CIEL\r\n\x1a" + kind + b"\x02\0\x02\0" and data[48:64] == bytes(16)
    return data[16:48].rstrip(b"\0").decode()


def check_end(data):
    assert struct.unpack("<Q", data[-8:])[0] == xxh3(data[:-8]), "the checksum at the end of the file"


def sections(record, kind):
    name, version, count, length = struct.unpack_from("<4sHHQ", record)
    assert name == kind and version == 1 and length == len(record)
    entries = struct.iter_unpack("<HHIII", record[16 : 16 + 16 * count])
    return {number: (size, record[8 * at : 8 * at + size * n]) for number, _, size, n, at in entries}


def array(found, number, sign="u", width=1):
    """`width`: integers in an element; several are a row."""
    size, data = found.get(number, (4 * width, b""))
    values = numpy.frombuffer(data, f"<{sign}{size // width}").astype("i8")
    return values if width == 1 else values.reshape(-1, width)


def links(found, number):
    """Returns -1 where all bits are ones."""
    values = array(found, number)
    return numpy.where(values == 256 ** found[number][0] - 1, -1, values) if number in found else values
