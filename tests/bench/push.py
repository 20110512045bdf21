#!/usr/bin/env python3
"""Measures the seconds that a script needs to upload a step: tests/bench/push.py CIEL DATASET.ciel ARRAY[=COMPONENTS] [COUNT]

Uploads by POST (base64) and by WebSocket (binary): begin, pieces, commit. Uses a copy of the dataset. COMPONENTS: for a new array.
"""

import asyncio
import base64
import os
import pathlib
import shutil
import statistics
import sys
import tempfile
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/python"), str(ROOT / "protocol/python")]
TOKEN = "0123456789abcdef"


def values_of(described: dict, array: str, new_components: int) -> np.ndarray:
    tuples = described["input"]["cells" if array.startswith("cell:") else "vertices"]
    components = next((a["components"] for a in described["arrays"] if a["name"] == array), new_components)
    return np.random.default_rng(1).random((tuples, components) if components > 1 else tuples, dtype="f4")


def by_post(calls, step_time: float, array: str, values: np.ndarray) -> list[float]:
    from ciel_client.append import pieces, pushed

    step = [pushed(array, values)]
    marks = [time.perf_counter()]
    upload = calls.call("append.begin", dataset="bench", time=step_time, arrays=[step[0].wanted])
    marks.append(time.perf_counter())
    for number, offset, data in pieces(step, upload["piece_bytes"]):
        text = base64.b64encode(data).decode()
        calls.call("append.piece", upload=upload["upload"], array=number, offset=offset, data=text)
    marks.append(time.perf_counter())
    calls.call("append.commit", upload=upload["upload"])
    marks.append(time.perf_counter())
    return list(np.diff(marks))


async def by_socket(url: str, step_time: float, array: str, values: np.ndarray) -> list[float]:
    from ciel_client import Stream
    from ciel_client.append import message, pieces, pushed

    async with Stream(url, TOKEN) as stream:
        step = [pushed(array, values)]
        marks = [time.perf_counter()]
        upload = await stream.call("append.begin", dataset="bench", time=step_time, arrays=[step[0].wanted])
        marks.append(time.perf_counter())
        for number, offset, data in pieces(step, upload["piece_bytes"]):
            await stream._socket.send(message(upload["upload"], number, offset, data))
        await stream.call("dataset.list")  # messages are handled in order, so this answer follows the pieces
        marks.append(time.perf_counter())
        await stream.call("append.commit", upload=upload["upload"])
        marks.append(time.perf_counter())
        return list(np.diff(marks))


def main(binary: str, dataset: str, array: str, count: int = 5) -> None:
    os.environ["CIEL_BINARY"] = binary
    from ciel_client import Client
    from serve_process import Server

    with tempfile.TemporaryDirectory() as folder:
        copy = shutil.copytree(dataset, pathlib.Path(folder) / "bench.ciel")
        with Server(copy, "--token", TOKEN, "--allow-append") as server:
            calls = Client(server.base, TOKEN)
            described = calls.call("dataset.describe", dataset="bench")
            array, _, new_components = array.partition("=")
            values = values_of(described, array, int(new_components or 1))
            last = described["times"][-1]
            print(f"{array}: {values.size} values, {values.nbytes / 2**20:.1f} MiB, {count} steps each, seconds (median)")
            rows = {"POST": [], "WebSocket": []}
            for _ in range(count):
                rows["POST"].append(by_post(calls, last := last + 1, array, values))
                url = f"ws://127.0.0.1:{server.port}/ws"
                rows["WebSocket"].append(asyncio.run(by_socket(url, last := last + 1, array, values)))
            for way, runs in rows.items():
                begin, fill, commit = (statistics.median(column) for column in zip(*runs, strict=True))
                print(f"{way}: begin {begin:.3f}, pieces {fill:.3f} ({values.nbytes / fill / 2**20:.0f} MiB/s), "
                      f"commit {commit:.3f}")


if __name__ == "__main__":
    main(*sys.argv[1:4], *map(int, sys.argv[4:5]))
