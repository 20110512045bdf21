"""Rewrites OpenFOAM cases of openfoam_files: moved, in binary, compressed."""

import gzip
import re
import shutil

import numpy as np

LIST = re.compile(rb"(\d+)\n\(\n(.*?)\n\)\n", re.S)


def moved(case, offset):
    """Moves the points of every mesh of the case by `offset`, with all digits of a double."""
    for points in case.rglob("points"):
        data = points.read_bytes()
        begin = re.search(rb"\n(\d+)\s*\(", data)
        if b"binary" in data[: begin.start()]:
            rows = np.frombuffer(data, "f8", 3 * int(begin[1]), begin.end()).reshape(-1, 3)
            packed = (rows + np.array(offset, float)).tobytes()
            points.write_bytes(data[: begin.end()] + packed + data[begin.end() + len(packed) :])
        else:
            rows = numbers(data[begin.end() :]).reshape(-1, 3) + np.array(offset, float)
            text = "\n".join("({} {} {})".format(*map(repr, map(float, row))) for row in rows)
            points.write_bytes(data[: begin.end()] + f"\n{text}\n)\n".encode())
    return case


def numbers(rows):
    return np.array(re.sub(rb"[()]", b" ", rows).split(), float)


def as_binary(case, label=32, scalar=64):
    """Rewrites meshes and fields as OpenFOAM does with `writeFormat binary`. The file `boundary` stays text."""
    labels, scalars = np.dtype(f"i{label // 8}"), np.dtype(f"f{scalar // 8}")
    for file in case.rglob("*"):
        if not file.is_file() or "polyMesh" not in file.parts and file.name not in ("U", "p"):
            continue
        text = file.read_bytes().replace(b"format ascii;", f'format binary;\n    arch "LSB;label={label};scalar={scalar}";'.encode())
        raw = lambda found, kind: found[1] + b"\n(" + numbers(found[2]).astype(kind).tobytes() + b")\n"
        if file.name == "faces":
            (_, rows) = LIST.search(text).groups()
            loops = [list(map(int, re.findall(rb"\d+", row)))[1:] for row in rows.splitlines()]
            offsets = np.cumsum([0, *map(len, loops)]).astype(labels)
            corners = np.concatenate(loops).astype(labels)
            lists = b"".join(b"%d\n(%s)\n" % (len(a), a.tobytes()) for a in (offsets, corners))
            text = text[: LIST.search(text).start()].replace(b"faceList", b"faceCompactList") + lists
        elif file.name in ("owner", "neighbour"):
            text = LIST.sub(lambda found: raw(found, labels), text)
        elif file.name == "points" or "polyMesh" not in file.parts:
            text = LIST.sub(lambda found: raw(found, scalars), text)
        else:
            continue
        file.write_bytes(text)
    return case


def compressed(case):
    for file in list(case.rglob("*")):
        if file.is_file() and (file.name in ("U", "p") or "polyMesh" in file.parts):
            with gzip.open(f"{file}.gz", "wb") as packed:
                packed.write(file.read_bytes())
            file.unlink()
    return case


def copied(case, to):
    shutil.copytree(case, to)
    return to
