#!/usr/bin/python3
"""How soon a server that has just been started shows a dataset, and what it holds then.

usage: opening.py CIEL DATASET.ciel [--scene SCENE.json] [--size WxH]
Starts a server, asks for dataset.describe, opens the default scene and renders it. Prints one JSON line: seconds from the start of
the program to each answer, and the server's memory in MiB: its own, mapped files, and the peak of both.
"""

import argparse
import json
import pathlib
import re
import subprocess
import time
import urllib.request

TOKEN = "opening-bench"


def memory(process):
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
    own, mapped, peak = (int(re.search(rf"{key}:\s+(\d+)", status).group(1)) // 1024 for key in ("RssAnon", "RssFile", "VmHWM"))
    return {"own": own, "mapped": mapped, "peak": peak}


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("ciel")
    parser.add_argument("dataset", type=pathlib.Path)
    parser.add_argument("--scene", type=pathlib.Path, help="shown instead of the default scene")
    parser.add_argument("--size", default="1280x720")
    options = parser.parse_args()
    begin, seconds = time.monotonic(), {}
    server = subprocess.Popen(
        [options.ciel, "serve", options.dataset, "--port", "0", "--token", TOKEN], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    address = next(found.group() for line in server.stdout if (found := re.search(r"http://[^\s/]+", line)))

    def call(name, method, **params):
        body = json.dumps({"jsonrpc": "2.0", "id": 1, "method": method, "params": params}).encode()
        headers = {"Content-Type": "application/json", "Authorization": f"Bearer {TOKEN}"}
        with urllib.request.urlopen(urllib.request.Request(address + "/rpc", body, headers), timeout=600) as answer:
            result = json.load(answer)["result"]
        seconds[name] = round(time.monotonic() - begin, 3)
        return result

    dataset = options.dataset.stem
    call("describe", "dataset.describe", dataset=dataset)
    session = call("session", "session.open", scene={"dataset": dataset})["session"]
    scene = call("default scene", "dataset.open", session=session, dataset=dataset)["scene"]
    if options.scene:
        scene = {**json.loads(options.scene.read_text(encoding="utf-8")), "dataset": dataset}
    width, height = (int(side) for side in options.size.split("x"))
    call("picture", "picture.render", scene=scene, width=width, height=height)
    print(json.dumps({"dataset": dataset, "seconds": seconds, "MiB": memory(server)}))
    server.terminate()
    server.wait()


if __name__ == "__main__":
    main()
