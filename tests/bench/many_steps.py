#!/usr/bin/python3
"""How long it takes to open a dataset of many steps, and to append one.

usage: many_steps.py CIEL DATASET.ciel [--steps 10000] [--arrays 10]
DATASET.ciel: a small dataset of one mesh, for example of `bench_mesh tetrahedra 3`. Makes two copies, one with one step
and one with many. All steps are in the commit marker, as plain Zarr writes them, and share the first chunk of each
array. Prints one JSON line for each copy: seconds until a server listens, and of dataset.describe ("text"); seconds of
three appends, the first of which moves many steps to the table; and the server's seconds after them ("then").
"""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import urllib.request

import numpy

TOKEN = "many-steps-bench"


def describe(port, name):
    """Seconds of dataset.describe. Calls it by POST, because the answer may be too long for a WebSocket."""
    call = {"jsonrpc": "2.0", "id": 1, "method": "dataset.describe", "params": {"dataset": name}}
    request = urllib.request.Request(f"http://127.0.0.1:{port}/rpc?token={TOKEN}", json.dumps(call).encode(), {"Content-Type": "application/json"})
    begin = time.monotonic()
    with urllib.request.urlopen(request) as answer:
        json.load(answer)["result"]
    return round(time.monotonic() - begin, 3)


def served(ciel, dataset):
    """Seconds from the start of a server until it prints its address, and seconds of dataset.describe."""
    begin = time.monotonic()
    server = subprocess.Popen([ciel, "serve", dataset, "--port", "0", "--token", TOKEN], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        port = next(found.group(1) for line in server.stdout if (found := re.search(r"http://[^\s/]+:(\d+)", line)))
        listening = round(time.monotonic() - begin, 3)
        return {"listening": listening, "describe": describe(port, dataset.stem)}
    finally:
        server.terminate()
        server.wait()


def with_steps(source, target, steps, arrays):
    shutil.copytree(source, target)
    marker = json.loads((target / "steps.json").read_text())
    name, first = next(iter(marker["steps"][0]["arrays"].items()))
    folder = target / "meshes/0/arrays"
    for i in range(arrays):
        shutil.copytree(folder / name, folder / f"a{i}")
        attributes = (folder / f"a{i}/.zattrs").read_text()
        (folder / f"a{i}/.zattrs").write_text(attributes.replace(f'"{name}"', f'"a{i}"'))
    marker["steps"] = [
        {"time": step, "mesh": 0, "coordinates": 0, "arrays": {f"a{i}": {**first, "chunk": 0} for i in range(arrays)}} for step in range(steps)
    ]
    (target / "steps.json").write_text(json.dumps(marker))


def append(ciel, dataset, values, step):
    begin = time.monotonic()
    subprocess.run([ciel, "append", dataset, "--time", str(step), "--array", f"a0={values}"], check=True, stdout=subprocess.DEVNULL)
    return round(time.monotonic() - begin, 3)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ciel")
    parser.add_argument("dataset", type=pathlib.Path)
    parser.add_argument("--steps", type=int, default=10000)
    parser.add_argument("--arrays", type=int, default=10)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        for steps in (1, options.steps):
            target = pathlib.Path(scratch) / f"steps{steps}.ciel"
            with_steps(options.dataset, target, steps, options.arrays)
            row = {"steps": steps, "arrays": options.arrays, "text": served(options.ciel, target)}
            values = pathlib.Path(scratch) / "values.npy"
            write_values(values, target)
            row["appends"] = [append(options.ciel, target, values, steps + i) for i in range(3)]
            row["then"] = served(options.ciel, target)
            print(json.dumps(row))


def write_values(file, dataset):
    vertices = json.loads((dataset / "meshes/0/positions/.zarray").read_text())["shape"][1]
    numpy.save(file, numpy.zeros(vertices, dtype=numpy.float32))


if __name__ == "__main__":
    main()
