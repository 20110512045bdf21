#!/usr/bin/python3
"""What the server says that a picture needs, and what it takes: tests/bench/picture_memory.py CIEL DATASET.ciel ARRAY

Of each scene and size: MB that a refusal names (address space is limited for it), and by how much the peak of the resident memory
rises when the picture is drawn; a small picture was drawn before both. Needs a software GL, for others are not asked.
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
    """Bytes."""
    return int(re.search(rf"{name}:\s+(\d+)", pathlib.Path(f"/proc/{pid}/status").read_text()).group(1)) * 1024


def picture(server, dataset: str, layers: dict, width: int, height: int) -> str:
    """Empty, or why it was refused."""
    answer = requests.post(server.base + "/rpc", timeout=600, json={
        "jsonrpc": "2.0", "id": 1, "method": "picture.render",
        "params": {"scene": {"dataset": dataset, "layers": layers}, "width": width, "height": height}}).json()
    return "" if "result" in answer else answer["error"]["data"]["reason"]


def row(server, dataset: str, layers: dict, width: int, height: int) -> tuple[float, float]:
    pid = server.process.pid
    picture(server, dataset, layers, 320, 180)
    named = None
    for room in (16 << i for i in range(7)):  # MB; too little for a volume to be cut is another refusal
        resource.prlimit(pid, resource.RLIMIT_AS, (status(pid, "VmSize") + (room << 20), resource.RLIM_INFINITY))
        refused = picture(server, dataset, layers, width, height)
        resource.prlimit(pid, resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        if named := re.search(r"needs about ([\d,.]+) MB", refused):
            break
    pathlib.Path(f"/proc/{pid}/clear_refs").write_text("5")  # the peak begins anew
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
