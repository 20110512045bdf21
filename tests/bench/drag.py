#!/usr/bin/python3
"""Measures what a user who drags a slider sees: frames per second, latency from patch to frame, time to the first picture.

usage: drag.py CIEL DATASET.ciel ARRAY [--from A --to B] [--seconds S] [--size WxH] [--axis x] [--turn] [--play]
Starts a server on a free port, opens the dataset, waits for the first picture, then sweeps the iso-value (or, with --axis, a
slice) back and forth, one patch per presented frame, and prints one JSON line. With --turn a slice through the middle turns;
with --play the time goes from step to step and the surface stays.
"""

import argparse
import asyncio
import itertools
import json
import math
import os
import statistics
import struct
import subprocess
import time

import websockets


class Client:
    def __init__(self, socket):
        self.socket, self.next_id, self.answers, self.frames = socket, 0, {}, asyncio.Queue()
        self.pieces = bytearray()  # received pieces of the current frame of the view
        self.reader = asyncio.create_task(self.read())

    async def read(self):
        async for message in self.socket:
            if isinstance(message, bytes):
                await self.join(message)
            else:
                answer = json.loads(message)
                if answer.get("method") == "view.failed":
                    await self.frames.put(RuntimeError(answer["params"]["message"]))
                elif answer.get("id") in self.answers:
                    self.answers.pop(answer["id"]).set_result(answer)

    async def next_frame(self):
        """Returns the time of arrival and the frame. Raises RuntimeError if the server could not draw the scene."""
        arrived = await self.frames.get()
        if isinstance(arrived, RuntimeError):
            raise arrived
        return arrived

    async def join(self, message):
        """Collects pieces. A complete frame is the header of its first piece and the payloads of all."""
        whole, offset = struct.unpack_from("<II", message, 64)
        self.pieces = self.pieces + message[80:] if offset else bytearray(message)
        if len(self.pieces) == 80 + whole:
            await self.frames.put((time.monotonic(), bytes(self.pieces)))

    async def call(self, method, **params):
        self.next_id += 1
        future = self.answers[self.next_id] = asyncio.get_running_loop().create_future()
        await self.socket.send(json.dumps({"jsonrpc": "2.0", "id": self.next_id, "method": method, "params": params}))
        answer = await future
        if "error" in answer:
            raise RuntimeError(answer["error"])
        return answer["result"]

    async def ack(self, view, frame):
        params = {"view": view, "frame": frame}
        await self.socket.send(json.dumps({"jsonrpc": "2.0", "method": "view.ack", "params": params}))


def fields(message):
    flags = struct.unpack_from("<H", message, 6)[0]
    frame, revision = struct.unpack_from("<IQ", message, 12)
    wait, extract, draw, encode, triangles = struct.unpack_from("<4fI", message, 40)
    return {"flags": flags, "frame": frame, "revision": revision, "wait": wait, "extract": extract, "draw": draw,
            "encode": encode, "triangles": triangles, "bytes": len(message) - 80}


async def sweep(options, port, process):
    async with websockets.connect(f"ws://127.0.0.1:{port}/ws", subprotocols=["ciel.v1"], max_size=None) as socket:
        client = Client(socket)
        name = (await client.call("dataset.list"))[0]["name"]
        width, height = (int(side) for side in options.size.split("x"))
        opened = time.monotonic()
        state = await client.call("session.open", dataset=name)
        view = (await client.call("view.open", session=state["session"], width=width, height=height))["view"]
        arrived, message = await client.next_frame()
        first_picture = arrived - opened
        await client.ack(view, fields(message)["frame"])

        low, high = options.low, options.high
        description = await client.call("dataset.describe", dataset=name)
        if low is None:
            if options.axis:
                bounds = description["bounds"]
                low, high = bounds[2 * "xyz".index(options.axis)], bounds[2 * "xyz".index(options.axis) + 1]
            else:
                array = next(a for a in description["arrays"] if options.array.split(":")[0] == a["name"])
                low, high = array["range"]
        color = {"array": options.array}
        played = itertools.cycle(description["times"])

        def layers(value):
            if options.axis:
                place = (low + high) / 2 if options.play else value
                layer = {"type": "slice", "axis": options.axis, "value": place, "color": color}
            elif options.turn:
                angle = 2 * math.pi * (value - low) / (high - low)
                middle = [sum(description["bounds"][axis : axis + 2]) / 2 for axis in (0, 2, 4)]
                normal = [math.cos(angle), math.sin(angle), 0.3]
                layer = {"type": "slice", "origin": middle, "normal": normal, "color": color}
            else:
                iso = (low + high) / 2 if options.play else value
                layer = {"type": "iso", "array": options.array, "values": [iso]}
            return {"layers": {"bench": layer}, **({"time": next(played)} if options.play else {})}

        others = {key: None for key in state["scene"].get("layers", {})}
        await client.call("scene.patch", session=state["session"], patch={"layers": others})
        await asyncio.sleep(1)
        while not client.frames.empty():
            await client.ack(view, fields((await client.next_frame())[1])["frame"])

        cpu_before, started, rows, step = process_cpu(process.pid), time.monotonic(), [], 0
        own_before = memory(process.pid, "RssAnon")
        while time.monotonic() - started < options.seconds:
            step += 1
            share = 0.02 + 0.96 * abs((step / 200) % 2 - 1)
            sent = time.monotonic()
            revision = (await client.call("scene.patch", session=state["session"], gesture="drag",
                                          patch=layers(low + (high - low) * share)))["revision"]
            while True:
                arrived, message = await client.next_frame()
                row = fields(message)
                await client.ack(view, row["frame"])
                if row["revision"] >= revision:
                    break
            rows.append({**row, "latency": 1000 * (arrived - sent)})
        elapsed = time.monotonic() - started
        cpu = process_cpu(process.pid) - cpu_before
        median = {key: round(statistics.median(row[key] for row in rows), 2)
                  for key in ("latency", "extract", "draw", "encode", "triangles", "bytes")}
        slowest = sorted(row["latency"] for row in rows)[int(0.95 * len(rows))]
        print(json.dumps({"dataset": name, "what": "turn" if options.turn else "play" if options.play else options.axis or options.array, "size": options.size,
                          "first_picture_s": round(first_picture, 2), "frames": len(rows), "frames_per_s": round(len(rows) / elapsed, 1),
                          "latency_p95_ms": round(slowest, 1), "cpu_s_per_frame": round(cpu / len(rows), 4),
                          "peak_memory_mb": round(memory(process.pid, "VmHWM") / 1e6),
                          "own_memory_mb": [round(own_before / 1e6), round(memory(process.pid, "RssAnon") / 1e6)], "median": median}))


def process_cpu(pid):
    with open(f"/proc/{pid}/stat", encoding="ascii") as stat:
        ticks = stat.read().rsplit(")", 1)[1].split()
    return (int(ticks[11]) + int(ticks[12])) / os.sysconf("SC_CLK_TCK")


def memory(pid, of):
    """Bytes of the process. `of`: VmHWM (peak of all resident pages, mapped files included) or RssAnon (own memory)."""
    with open(f"/proc/{pid}/status", encoding="ascii") as status:
        return 1024 * int(next(line for line in status if line.startswith(of)).split()[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ciel")
    parser.add_argument("dataset")
    parser.add_argument("array")
    parser.add_argument("--from", dest="low", type=float)
    parser.add_argument("--to", dest="high", type=float)
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--axis", choices=["x", "y", "z"])
    parser.add_argument("--turn", action="store_true")
    parser.add_argument("--play", action="store_true")
    parser.add_argument("--serve", nargs=argparse.REMAINDER, default=[], help="further options of ciel serve")
    options = parser.parse_args()
    process = subprocess.Popen([options.ciel, "serve", options.dataset, "--port", "0", *options.serve],
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        line = next(line for line in process.stdout if "http://" in line)
        port = int(line.split("http://", 1)[1].split("/")[0].rsplit(":", 1)[1])
        asyncio.run(sweep(options, port, process))
    finally:
        process.terminate()
        process.wait()


if __name__ == "__main__":
    main()
