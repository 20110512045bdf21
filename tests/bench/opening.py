#!/usr/bin/python3
"""How soon a server that has just been started shows a dataset, and what it holds then.

usage: opening.py CIEL DATASET.ciel [--scene SCENE.json] [--size WxH]
Starts a server, asks for dataset.describe, opens the default scene and a view of it, as the page does. Prints one JSON line: seconds
from the start of the program to each answer, to the first frame and to the first still; the milliseconds that these frames took; and
the server's memory in MiB: its own, mapped files, and the peak of both.
"""

import argparse
import asyncio
import json
import pathlib
import re
import subprocess
import time

import websockets
from drag import Client, fields

STILL = 1
TOKEN = "opening-bench"


def memory(process):
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
    own, mapped, peak = (int(re.search(rf"{key}:\s+(\d+)", status).group(1)) // 1024 for key in ("RssAnon", "RssFile", "VmHWM"))
    return {"own": own, "mapped": mapped, "peak": peak}


async def opening(options, port, seconds, begin):
    def note(name):
        seconds.setdefault(name, round(time.monotonic() - begin, 3))

    url = f"ws://127.0.0.1:{port}/ws?token={TOKEN}"
    async with websockets.connect(url, subprotocols=["ciel.v1"], max_size=None) as socket:
        client = Client(socket)
        await client.call("dataset.describe", dataset=options.dataset.stem)
        note("describe")
        scene = {"dataset": options.dataset.stem}
        if options.scene:
            scene = {**json.loads(options.scene.read_text(encoding="utf-8")), **scene}
            session = (await client.call("session.open", scene=scene))["session"]
        else:
            session = (await client.call("session.open", dataset=options.dataset.stem))["session"]
        note("session")
        width, height = (int(side) for side in options.size.split("x"))
        view = (await client.call("view.open", session=session, width=width, height=height))["view"]
        steps = {}
        while "still" not in seconds:
            _, message = await client.next_frame()
            row = fields(message)
            name = "still" if row["flags"] & STILL else "first frame"
            note(name)
            steps.setdefault(name, {step: round(row[step]) for step in ("wait", "extract", "draw", "encode", "triangles")})
            await client.ack(view, row["frame"])
        return steps


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ciel")
    parser.add_argument("dataset", type=pathlib.Path)
    parser.add_argument("--scene", type=pathlib.Path, help="shown instead of the default scene")
    parser.add_argument("--size", default="1280x720")
    options = parser.parse_args()
    begin, seconds = time.monotonic(), {}
    server = subprocess.Popen(
        [options.ciel, "serve", options.dataset, "--port", "0", "--token", TOKEN], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    try:
        port = next(found.group(1) for line in server.stdout if (found := re.search(r"http://[^\s/]+:(\d+)", line)))
        steps = asyncio.run(opening(options, port, seconds, begin))
        print(json.dumps({"dataset": options.dataset.stem, "seconds": seconds, "ms": steps, "MiB": memory(server)}))
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    main()
