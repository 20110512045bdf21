#!/usr/bin/python3
"""How much of a dataset is read from the disk for one surface, and how long that takes.

usage: cold_reads.py CIEL DATASET.ciel [--array smooth] [--color noisy]
For five quantiles of the array's range: takes the dataset's files out of the page cache, extracts the iso-surface with gradient normals
and the colors of another array in a new process, and counts the bytes that the process read. Prints one JSON line for each value, then
the mean, as a share of the records, the positions and the two arrays. Needs a file system that drops pages when it is told to.
"""

import argparse
import json
import os
import pathlib
import resource
import subprocess
import tempfile
import time

import numpy

BLOCK = 512  # unit of ru_inblock
QUANTILES = [0.1, 0.3, 0.5, 0.7, 0.9]


def files_of(dataset, arrays):
    mesh = dataset / "meshes" / "0"
    wanted = [mesh / "positions", mesh / "blocks", *(mesh / "arrays" / name for name in arrays)]
    return [file for folder in wanted for file in folder.rglob("*") if file.is_file()]


def values_of(dataset, array):
    folder = dataset / "meshes" / "0" / "arrays" / array
    kind = json.loads((folder / ".zarray").read_text(encoding="utf-8"))["dtype"]
    return numpy.fromfile(folder / "0.0", dtype=kind)


def forget(dataset):
    for file in dataset.rglob("*"):
        if file.is_file():
            descriptor = os.open(file, os.O_RDONLY)
            os.posix_fadvise(descriptor, 0, 0, os.POSIX_FADV_DONTNEED)
            os.close(descriptor)


def extract(options, value, out):
    command = [options.ciel, "extract", options.dataset, "--iso", f"{options.array}={value}", "-o", out / "surface.ply"]
    if options.color:
        command += ["--color", options.color]
    forget(options.dataset)
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_inblock, time.monotonic()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    seconds = time.monotonic() - begin
    return (resource.getrusage(resource.RUSAGE_CHILDREN).ru_inblock - before) * BLOCK, seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ciel")
    parser.add_argument("dataset", type=pathlib.Path)
    parser.add_argument("--array", default="smooth")
    parser.add_argument("--color")
    options = parser.parse_args()
    arrays = [options.array, *([options.color] if options.color else [])]
    total = sum(file.stat().st_size for file in files_of(options.dataset, arrays))
    shares = []
    with tempfile.TemporaryDirectory() as out:
        for value in numpy.quantile(values_of(options.dataset, options.array), QUANTILES).tolist():
            read, seconds = extract(options, value, pathlib.Path(out))
            shares.append(read / total)
            print(json.dumps({"value": value, "MB": round(read / 1e6, 1), "share": round(read / total, 4), "seconds": round(seconds, 2)}))
    print(json.dumps({"of MB": round(total / 1e6, 1), "mean share": round(sum(shares) / len(shares), 4)}))


if __name__ == "__main__":
    main()
