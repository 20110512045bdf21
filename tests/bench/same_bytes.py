#!/usr/bin/python3
"""Compares two builds byte by byte: tests/bench/same_bytes.py OLD_CIEL NEW_CIEL DATASET.ciel...

Each build makes, of each dataset: surfaces by `ciel extract` with each algorithm, pictures of each kind of layer, and the answers and
frames of a recorded session. Prints what differs, and how much was compared. Exit code 1 if anything differs. A change that is not
to change behaviour is checked so. Needs an idle machine: frames carry their numbers, and a slow frame is sent in several qualities.
"""

import asyncio
import hashlib
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/python"), str(ROOT / "protocol/python")]
ALGORITHMS = ("signatures", "propagation")
SHARES = (0.15, 0.5, 0.83)  # of an array's range
MOST_ARRAYS = 3
SIZE = {"width": 480, "height": 270}


def digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()[:16]


def without_times(value):
    """The value without what differs from run to run: durations, ids and the version of the program."""
    if isinstance(value, dict):
        gone = {"session", "request", "started", "version", "seconds", "view"}
        return {key: without_times(member) for key, member in value.items() if key not in gone and not key.endswith("_ms")}
    return [without_times(member) for member in value] if isinstance(value, list) else value


def levels_of(array: dict) -> list[float]:
    low, high = array["range"]
    return [low + share * (high - low) for share in SHARES]


def surfaces(program: str, dataset: str, arrays: list[dict], environment: dict) -> dict[str, str]:
    """Surfaces by the command line. Returns the digest of each file by the options that made it."""
    cuts = [["--iso", f"{array['name']}={','.join(map(repr, levels_of(array)))}"] for array in arrays]
    cuts += [["--plane", "0,0,0,1,2,3"], ["--slice", "z=0"]]
    made = {}
    with tempfile.TemporaryDirectory() as folder:
        for options, algorithm, kind in itertools.product(cuts, ALGORITHMS, ("ply", "vtp")):
            file = pathlib.Path(folder) / f"out.{kind}"
            file.unlink(missing_ok=True)
            done = subprocess.run([program, "extract", dataset, *options, "--algorithm", algorithm, "-o", file],
                                  env=environment, capture_output=True, text=True)
            name = " ".join(["extract", *options, algorithm, kind])
            made[name] = digest(file.read_bytes()) if done.returncode == 0 else done.stderr
    return made


def scenes(name: str, default: dict, arrays: list[dict]) -> dict[str, dict]:
    """A scene for each kind of layer."""
    array = arrays[0]["name"] if arrays else None
    layers: dict[str, dict] = {"surface": {"type": "surface"}, "outline": {"type": "outline"}, "edges": {"type": "edges"}}
    if array is not None:
        color = {"color": {"array": array}}
        layers |= {
            "iso": {"type": "iso", "array": array, "values": levels_of(arrays[0])},
            "transparent": {"type": "iso", "array": array, "values": levels_of(arrays[0]), "opacity": 0.4},
            "slice": {"type": "slice", "axis": "x", "value": 0, **color},
            "volume": {"type": "volume", "array": array},
            "colored": {"type": "surface", **color},
        }
    return {"default": default} | {kind: {"dataset": name, "layers": {"one": layer}} for kind, layer in layers.items()}


async def session(server, name: str, default: dict, arrays: list[dict], stream: str) -> dict[str, str]:
    """A recorded session: opens, moves, cuts, undoes. Returns the digests of its stills and answers."""
    from ciel_client.frame_header import LAST_OF_FRAME
    from serve_process import client

    patches: list[dict] = []
    if stream == "image":  # a page that has the polygons moves the camera itself
        patches += [{"camera": {"position": [3, -4, 2], "target": [0, 0, 0], "up": [0, 0, 1]}}]
    if arrays:
        patches += [{"layers": {"one": {"type": "iso", "array": arrays[0]["name"], "values": [level]}}} for level in levels_of(arrays[0])]
    patches += [{"layers": {"two": {"type": "clip", "axis": "y", "value": 0}}}, {"layers": {"two": None}}]
    made = {}
    async with client(server) as caller:
        opened = await caller.call("session.open", scene=default)
        made["open"] = digest(json.dumps(without_times(opened)).encode())
        await caller.call("view.open", session=opened["session"], **SIZE, stream=stream)
        steps = [("scene.patch", {"patch": patch}) for patch in patches] + [("scene.undo", {})] * 2 + [("scene.redo", {})]
        for number, (method, params) in enumerate(steps):
            state = await caller.call(method, session=opened["session"], **params)
            made[f"{number} {method}"] = digest(json.dumps(without_times(state)).encode())
            frame = await caller.frame(state["revision"], still=stream == "image")
            while stream == "geometry" and not frame.flags & LAST_OF_FRAME:
                frame = await caller.frame(state["revision"])
            parts = b"".join(part.payload for part in caller.frames if part.number == frame.number)
            made[f"{number} {stream}"] = f"{frame.width}x{frame.height} {frame.triangles} {digest(parts)}"
        await caller.call("session.close", session=opened["session"])
    return made


def everything(program: str, dataset: str) -> dict[str, str]:
    os.environ["CIEL_BINARY"] = program
    from serve_process import Server

    environment = {**os.environ}
    with Server(dataset, program=program) as server:
        name = server.call("dataset.list")[0]["name"]
        about = server.call("dataset.describe", dataset=name)
        # In a constant array all levels are equal. A patch that changes nothing makes no frame, for which the session would wait.
        arrays = [array for array in about["arrays"] if array.get("association") == "point" and array["components"] == 1
                  and array["range"][0] < array["range"][1]][:MOST_ARRAYS]
        made = {"describe": digest(json.dumps(without_times(about)).encode())}
        for kind, scene in scenes(name, about["default_scene"], arrays).items():
            picture = server.call("picture.render", scene=scene, **SIZE)
            made[f"picture {kind}"] = digest(picture["data"].encode())
        for stream in ("image", "geometry"):
            made |= {f"session {key}": value
                     for key, value in asyncio.run(session(server, name, about["default_scene"], arrays, stream)).items()}
    return made | surfaces(program, dataset, arrays, environment)


def main() -> None:
    old, new, *datasets = sys.argv[1:]
    compared = differ = 0
    for dataset in datasets:
        before, after = (everything(str(pathlib.Path(program).resolve()), dataset) for program in (old, new))
        for key in sorted(before.keys() | after.keys()):
            compared += 1
            if before.get(key) != after.get(key):
                differ += 1
                print(f"{dataset}: {key}: {before.get(key)} before, {after.get(key)} now")
    print(f"{compared} compared, {differ} differ")
    sys.exit(differ > 0)


main()
