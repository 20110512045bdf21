#!/usr/bin/python3
"""Compares the memory that the server estimates for a picture with what it uses: tests/bench/picture_memory.py CIEL DATASET.ciel ARRAY

For each scene and size, prints two numbers in MB. The first is the estimate in a refusal, which a limit on the address space causes.
The second is the rise of the peak resident memory while the picture is drawn. A small picture is drawn before both.
Needs a software OpenGL, because the server makes no estimates for others.
"""

import os
import pathlib
import re
import resource
import sys

import requests

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/python")]
SIZES = ((1280, 720), (3840, 2160), (7680, 4320))


def status(pid: int, name: str) -> int:
    """A value of /proc/PID/status in bytes."""
    return int(re.search(rf"{name}:\s+(\d+)", pathlib.Path(f"/proc/{pid}/status").read_text()).group(1)) * 1024


def picture(server, dataset: str, layers: dict, width: int, height: int) -> str:
    """Draws a picture. Returns the reason of a refusal, or an empty string."""
    answer = requests.post(server.base + "/rpc", timeout=600, json={
        "jsonrpc": "2.0", "id": 1, "method": "picture.render",
        "params": {"scene": {"dataset": dataset, "layers": layers}, "width": width, "height": height}}).json()
    return "" if "result" in answer else answer["error"]["data"]["reason"]


def row(server, dataset: str, layers: dict, width: int, height: int) -> tuple[float, float]:
    pid = server.process.pid
    picture(server, dataset, layers, 320, 180)
    named = None
    # In MB. With too little room, cutting the volume fails first, with another message.
    for room in (16 << i for i in range(7)):
        resource.prlimit(pid, resource.RLIMIT_AS, (status(pid, "VmSize") + (room << 20), resource.RLIM_INFINITY))
        refused = picture(server, dataset, layers, width, height)
        resource.prlimit(pid, resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        if named := re.search(r"needs about ([\d,.]+) MB", refused):
            break
    pathlib.Path(f"/proc/{pid}/clear_refs").write_text("5")  # resets the peak
    before = status(pid, "VmRSS")
    assert picture(server, dataset, layers, width, height) == ""
    return (float(named.group(1).replace(",", "")) if named else 0.0), (status(pid, "VmHWM") - before) / 1e6


def main() -> None:
    ciel, path, array = sys.argv[1:4]
    os.environ["CIEL_BINARY"] = ciel
    from serve_process import Server

    colored = {"color": {"array": array}}
    scenes = {"boundary": {"b": {"type": "surface", **colored}},
              "transparent boundary": {"b": {"type": "surface", "opacity": 0.5, **colored}},
              "volume": {"v": {"type": "volume", "array": array}}}
    print("| scene | size | named, MB | taken, MB |\n|---|---|---|---|")
    for name, layers in scenes.items():
        for width, height in SIZES:
            with Server(path) as server:
                named, taken = row(server, pathlib.Path(path).stem, layers, width, height)
                print(f"| {name} | {width}x{height} | {named:.0f} | {taken:.0f} |", flush=True)


main()
