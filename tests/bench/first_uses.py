#!/usr/bin/python3
"""What the first use of each kind costs on a dataset that is not in the page cache.

usage: first_uses.py CIEL DATASET.ciel [--array smooth] [--uses probe,boundary] [--most-block BYTES]
For each use: takes the dataset's files out of the page cache, starts a server, and calls the method. Prints one JSON
line: seconds from the request to the answer, bytes read from the disk, the server's memory afterwards (its own, and
mapped files), and its peak, in MB. With --most-block, larger blocks of memory are refused, and the use fails if it
cannot do without. Needs a file system that drops pages when it is told to.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import tempfile
import time
import urllib.request

from cold_reads import forget

TOKEN = "first-uses-bench"


def uses_of(name, array, bounds):
    """The measured calls, by name: method and parameters."""
    middle = [0.47 * bounds[axis] + 0.53 * bounds[axis + 1] for axis in (0, 2, 4)]

    def picture(layer):
        return "picture.render", {"scene": {"dataset": name, "layers": {"a": layer}}, "width": 640, "height": 360}

    color = {"array": array}
    iso = {"type": "iso", "array": array, "values": [0.5], "color": color}
    oblique = {"type": "slice", "origin": middle, "normal": [0.5, 0.3, 0.8], "color": color}
    clip = {"type": "clip", "origin": middle, "normal": [1, 0.2, 0], "caps": True}
    clipped = {"dataset": name, "layers": {"a": {"type": "surface", "color": color}, "clip": clip}}
    return {
        "describe": ("dataset.describe", {"dataset": name}),
        "histogram": ("dataset.histogram", {"dataset": name, "array": array, "bins": 128}),
        "histogram of a part": ("dataset.histogram", {"dataset": name, "array": array, "bins": 128, "range": [0.2, 0.7]}),
        "probe": ("probe.point", {"scene": {"dataset": name}, "position": middle}),
        "slice": picture({"type": "slice", "axis": "x", "value": middle[0], "color": color}),
        "iso-surface": picture(iso),
        "free slice": picture(oblique),
        "contour lines": picture({**oblique, "contours": {"array": array, "values": [0.3, 0.5]}}),
        "boundary": picture({"type": "surface", "color": color}),
        "clip with a cap": ("picture.render", {"scene": clipped, "width": 640, "height": 360}),
        "edges": picture({"type": "edges"}),
        "points": picture({"type": "points", "color": color}),
        "points inside": picture({"type": "points", "of": "all", "threshold": {"array": array, "range": [0.5, 0.51]}}),
        "threshold": picture({"type": "surface", "threshold": {"array": array, "range": [0.5, 0.6]}, "color": color}),
        "export": ("surface.export", {"scene": {"dataset": name, "layers": {"a": iso}}, "layer": "a", "format": "vtp"}),
        "volume": picture({"type": "volume", "array": array}),
    }


def status(process, key):
    text = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
    return int(re.search(rf"{key}:\s+(\d+)", text).group(1)) / 1000


def bytes_read(process):
    text = pathlib.Path(f"/proc/{process.pid}/io").read_text(encoding="utf-8")
    return int(re.search(r"^read_bytes: (\d+)", text, re.MULTILINE).group(1))


def call(port, method, params):
    body = json.dumps({"jsonrpc": "2.0", "id": 1, "method": method, "params": params}).encode()
    headers = {"Content-Type": "application/json", "Authorization": f"Bearer {TOKEN}"}
    with urllib.request.urlopen(urllib.request.Request(f"http://127.0.0.1:{port}/rpc", body, headers), timeout=600) as answer:
        answer = json.load(answer)
    if "error" in answer:
        raise RuntimeError(f"{method}: {answer['error']}")
    return answer["result"]


def refused_in(log):
    log.seek(0)
    return log.read().count("refused a block")


def measure(options, wanted):
    forget(options.dataset)
    command = [options.ciel, "serve", options.dataset, "--port", "0", "--token", TOKEN]
    refusing = {"LD_PRELOAD": str(options.refusing.resolve(strict=True)), "CIEL_MOST_BLOCK": options.most_block} if options.most_block else {}
    log = tempfile.TemporaryFile("w+")
    server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log, text=True, env={**os.environ, **refusing})
    try:
        port = next(found.group(1) for line in server.stdout if (found := re.search(r"http://[^\s/]+:(\d+)", line)))
        method, params = wanted
        read, begin = bytes_read(server), time.monotonic()
        call(port, method, params)
        seconds = time.monotonic() - begin
        return {"seconds": round(seconds, 2), "read": round((bytes_read(server) - read) / 1e6, 1),
                **({"refused": refused_in(log)} if refusing else {}), "own": round(status(server, "RssAnon")), "mapped": round(status(server, "RssFile")), "peak": round(status(server, "VmHWM"))}
    finally:
        server.terminate()
        server.wait()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ciel")
    parser.add_argument("dataset", type=pathlib.Path)
    parser.add_argument("--array", default="smooth")
    parser.add_argument("--uses", help="names of some of them, with commas")
    parser.add_argument("--most-block", help="refuse larger blocks of memory, in bytes")
    parser.add_argument("--refusing", default="build/librefused_blocks.so", type=pathlib.Path, help="the library that refuses them")
    options = parser.parse_args()
    attributes = json.loads((options.dataset / "meshes/0/.zattrs").read_text(encoding="utf-8"))["ciel"]
    uses = uses_of(options.dataset.stem, options.array, attributes["bounds"])
    for name in options.uses.split(",") if options.uses else uses:
        print(json.dumps({"use": name, **measure(options, uses[name])}), flush=True)


if __name__ == "__main__":
    main()
