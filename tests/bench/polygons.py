#!/usr/bin/python3
"""Measures the bytes per triangle of streamed polygons.

usage: polygons.py CIEL DATASET.ciel SCALAR COLOR [--size WxH]
Starts a server. Shows the boundary, an iso-surface of SCALAR colored by COLOR, a slice, all three, then changes of one of them.
Prints one JSON line for each, with the bytes of complete frames. Exits with 1 if many triangles have more than MOST_BYTES each.
"""

import argparse
import asyncio
import json
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "protocol/python"))
from ciel_client import Client, Stream  # noqa: E402

MOST_BYTES = 6
FEW = 10_000  # triangles, beside which the head of a batch weighs little


async def shown(stream, session, patch):
    """Returns the payload bytes and the header of the first complete frame that shows the patch."""
    revision = (await stream.call("scene.patch", session=session, patch=patch))["revision"]
    size = 0
    async for frame in stream.frames():
        size = (0 if frame.is_first else size) + len(frame.payload)
        if frame.revision >= revision and frame.is_last:
            await stream.acknowledge(frame)
            await asyncio.sleep(0.3)  # gives the acknowledgement time to arrive before the next change
            return size, frame


async def measure(options, port):
    dataset = Client(f"http://127.0.0.1:{port}").call("dataset.list")[0]["name"]
    described = Client(f"http://127.0.0.1:{port}").call("dataset.describe", dataset=dataset)
    low, high = next(array["range"] for array in described["arrays"] if options.scalar in array["scalars"])
    bounds, scene = described["bounds"], described["default_scene"]
    width, height = (int(side) for side in options.size.split("x"))
    color = {"array": options.color}
    iso = {"type": "iso", "array": options.scalar, "values": [low + 0.3 * (high - low)], "color": color}
    across = {"type": "slice", "axis": "z", "value": (bounds[4] + bounds[5]) / 2, "color": color}
    target = scene["camera"]["target"]
    eye = [at + 0.1 * (from_ - at) for at, from_ in zip(target, scene["camera"]["position"])]
    steps = [
        ("the boundary alone", {"layers": {"walls": {"type": "surface", "color": color}, "far": None}}),
        ("an iso-surface", {"layers": {"walls": None, "iso": iso}}),
        ("of another value", {"layers": {"iso": {"values": [low + 0.31 * (high - low)]}}}),
        ("in one color", {"layers": {"iso": {"color": {"array": None}}}}),
        ("in all colors again", {"layers": {"iso": {"color": color}}}),
        ("and a slice", {"layers": {"across": across}}),
        ("half as opaque", {"layers": {"iso": {"opacity": 0.5}}}),
        ("and the boundary", {"layers": {"walls": {"type": "surface", "opacity": 0.2, "color": color}}}),
        ("ten times as near", {"camera": {"position": eye}}),
        ("a slice alone", {"layers": {"iso": None, "walls": None, "across": {"value": 0.9 * across["value"]}}}),
        ("the boundary alone, near", {"layers": {"across": None, "walls": {"type": "surface", "color": color}}}),
    ]
    async with Stream(f"ws://127.0.0.1:{port}/ws") as stream:
        start = {"dataset": dataset, "camera": scene["camera"], "layers": {"far": {**across, "axis": "x", "value": 0.98 * bounds[1]}}}
        session = (await stream.call("session.open", scene=start))["session"]
        await stream.call("view.open", session=session, width=width, height=height, stream="geometry")
        dear = []
        for name, patch in steps:
            try:
                size, frame = await asyncio.wait_for(shown(stream, session, patch), 20)
            except asyncio.TimeoutError:
                print(json.dumps({"scene": name, "bytes": 0}))
                continue
            print(json.dumps({"scene": name, "triangles": frame.triangles, "bytes": size, "encode_ms": round(frame.encode_ms, 1),
                              "bytes_a_triangle": round(size / max(frame.triangles, 1), 2)}), flush=True)
            if frame.triangles > FEW and size > MOST_BYTES * frame.triangles:
                dear.append(name)
    return dear


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("ciel", "dataset", "scalar", "color"):
        parser.add_argument(name)
    parser.add_argument("--size", default="1280x720")
    options = parser.parse_args()
    server = subprocess.Popen([options.ciel, "serve", options.dataset, "--port", "0"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        for line in server.stdout:
            if found := re.search(r"http://127\.0\.0\.1:(\d+)", line):
                dear = asyncio.run(measure(options, int(found.group(1))))
                if dear:
                    sys.exit(f"more than {MOST_BYTES} bytes a triangle: {', '.join(dear)}")
                break
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    main()
