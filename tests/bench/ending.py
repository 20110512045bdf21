#!/usr/bin/python3
"""Measures the times of the operator: tests/bench/ending.py CIEL DATASET.ciel ARRAY [RUNS]

Three states of a server: idle, large pictures under way, a view whose client does not read. For each, prints the longest answer
to /readyz, and the time from SIGTERM to the exit: median and longest of the runs (5), in milliseconds.
"""

import asyncio
import os
import pathlib
import signal
import statistics
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/python")]
SIDE = 4096  # pixels: one picture takes seconds
PICTURES = 8
PROBES = 10


def scene(server, array: str) -> dict:
    name = server.call("dataset.list")[0]["name"]
    low, high = next(a["range"] for a in server.call("dataset.describe", dataset=name)["arrays"] if a["name"] == array)
    values = [low + (0.1 + 0.8 * i / 24) * (high - low) for i in range(24)]
    return {"dataset": name, "layers": {"busy": {"type": "iso", "array": array, "values": values, "opacity": 0.5}}}


async def nothing(_server, _caller, _wanted: dict) -> None:
    pass


async def pictures(server, caller, wanted: dict) -> None:
    for _ in range(PICTURES):
        await caller.send("picture.render", scene=wanted, width=SIDE, height=SIDE)
    while server.metrics()["ciel_frame_workers_busy"] == 0:
        await asyncio.sleep(0.01)


async def unread(_server, caller, wanted: dict) -> None:
    session = (await caller.call("session.open", dataset=wanted["dataset"]))["session"]
    await caller.call("scene.patch", session=session, patch={"layers": wanted["layers"]})
    caller.socket.transport.pause_reading()
    await caller.send("view.open", session=session, width=1280, height=720, stream="geometry")
    await asyncio.sleep(2)


def seconds_of(act) -> float:
    begun = time.perf_counter()
    act()
    return time.perf_counter() - begun


async def one_run(path: str, array: str, occupy) -> tuple[float, float]:
    from serve_process import PATIENCE, Server, client

    with Server(path) as server:
        wanted = scene(server, array)
        server.get("/readyz")  # draws the test picture, which is not to be timed
        async with client(server, close_timeout=0.1) as caller:
            await occupy(server, caller, wanted)
            probes = [seconds_of(lambda: server.get("/readyz")) for _ in range(PROBES)]
            server.process.send_signal(signal.SIGTERM)
            return max(probes), seconds_of(lambda: server.process.wait(PATIENCE))


def main() -> None:
    ciel, path, array = sys.argv[1:4]
    runs = int(sys.argv[4]) if len(sys.argv) > 4 else 5
    os.environ["CIEL_BINARY"] = ciel
    print("| the server is | /readyz, longest | exit, median | exit, longest |\n|---|---|---|---|")
    for state, occupy in {"idle": nothing, "drawing pictures": pictures, "sending to a client that does not read": unread}.items():
        measured = [asyncio.run(one_run(path, array, occupy)) for _ in range(runs)]
        ready, ends = (sorted(1000 * value for value in column) for column in zip(*measured))
        print(f"| {state} | {ready[-1]:.0f} | {statistics.median(ends):.0f} | {ends[-1]:.0f} |")


main()
