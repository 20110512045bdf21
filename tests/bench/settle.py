#!/usr/bin/python3
"""Compares the last interactive picture with the still that follows it.

usage: settle.py CIEL DATASET.ciel SCENE.json [--size WxH] [--turns N]
Starts a server on a free port, shows the scene (which has a camera), turns the camera N times by three degrees and waits for the still.
Prints one JSON line: the differences in 255ths, for pixels and for means of blocks of 8 x 8, which do not depend on sharpness;
the milliseconds that each picture took to draw; and the width of the interactive one.
"""

import argparse
import asyncio
import io
import json
import statistics
import struct
import subprocess

import numpy
import websockets
from drag import Client, fields
from PIL import Image

BLOCK, HEADER, STILL = 8, 80, 1


def pixels(message, size):
    picture = Image.open(io.BytesIO(message[HEADER:])).convert("RGB")
    return numpy.asarray(picture.resize(size, Image.Resampling.BILINEAR), dtype=float)


def blocks(picture):
    height, width = (side // BLOCK * BLOCK for side in picture.shape[:2])
    return picture[:height, :width].reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, 3).mean((1, 3))


def turned(camera, degrees):
    """Turns the camera around the z axis through its target."""
    turn = numpy.exp(1j * numpy.radians(degrees))
    x, y, z = numpy.subtract(camera["position"], camera["target"])
    around = (x + 1j * y) * turn
    return {**camera, "position": list(numpy.add(camera["target"], (around.real, around.imag, z)))}


async def frame(client, view, revision, still):
    while True:
        _, message = await client.next_frame()
        row = fields(message)
        await client.ack(view, row["frame"])
        if row["revision"] >= revision and (row["flags"] & STILL == STILL) == still:
            return message, row


async def settle(options, port):
    with open(options.scene, encoding="utf-8") as file:
        scene = json.load(file)
    size = tuple(int(side) for side in options.size.split("x"))
    async with websockets.connect(f"ws://127.0.0.1:{port}/ws", subprotocols=["ciel.v1"], max_size=None) as socket:
        client = Client(socket)
        name = (await client.call("dataset.list"))[0]["name"]
        state = await client.call("session.open", dataset=name)
        opened = await client.call("view.open", session=state["session"], width=size[0], height=size[1])

        async def patch(change):
            return (await client.call("scene.patch", session=state["session"], patch=change, gesture="drag"))["revision"]

        others = {layer: None for layer in state["scene"].get("layers", {})}
        shown = {key: value for key, value in scene.items() if key != "dataset"}
        revision = await patch({**shown, "layers": {**others, **scene["layers"]}})
        await frame(client, opened["view"], revision, True)
        took = []
        for turn in range(options.turns):
            revision = await patch({"camera": turned(scene["camera"], 3 * (turn + 1))})
            message, row = await frame(client, opened["view"], revision, False)
            took.append(row["draw"])
        moving, width = pixels(message, size), struct.unpack_from("<I", message, 24)[0]
        message, row = await frame(client, opened["view"], revision, True)
        still = pixels(message, size)
    off, off_blocks = abs(moving - still), abs(blocks(moving) - blocks(still))
    seen = abs(blocks(still) - blocks(still)[0, 0]).max(-1) > 3
    print(json.dumps({"dataset": name, "scene": options.scene, "size": options.size,
                      "pixels": {"mean": round(off.mean(), 2), "most": round(off.max())},
                      "blocks": {"mean": round(off_blocks[seen].mean(), 2), "most": round(off_blocks.max(), 1)},
                      "draw_moving_ms": round(statistics.median(took)), "moving_width": width, "draw_still_ms": round(row["draw"])}))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ciel")
    parser.add_argument("dataset")
    parser.add_argument("scene")
    parser.add_argument("--size", default="800x500")
    parser.add_argument("--turns", type=int, default=6)
    options = parser.parse_args()
    process = subprocess.Popen([options.ciel, "serve", options.dataset, "--port", "0"],
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        line = next(line for line in process.stdout if "http://" in line)
        asyncio.run(settle(options, int(line.split("http://", 1)[1].split("/")[0].rsplit(":", 1)[1])))
    finally:
        process.terminate()
        process.wait()


if __name__ == "__main__":
    main()
