"""Scripts upload steps to a running server, and the server or the script dies at different moments."""

import asyncio
import base64
import json
import os
import signal
import socket
import struct
import subprocess
import threading
import time

import numpy as np
import pytest

import box_dataset
from ciel_client import Client, RpcError, Stream
from ciel_client.types import ERROR_CODES
from program import ciel
from serve_process import PATIENCE, Server, client

TOKEN = "0123456789abcdef"
OPTIONS = ["--token", TOKEN, "--allow-append"]


@pytest.fixture
def box(tmp_path):
    return box_dataset.write_box(tmp_path / "box.ciel")


@pytest.fixture
def server(box):
    with Server(box, *OPTIONS) as running:
        yield running


def told(dataset) -> dict:
    result = ciel("info", dataset, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def left_aside(dataset) -> list:
    return [path for path in dataset.rglob("*") if ".new-" in path.name]


def points(dataset) -> int:
    return told(dataset)["input"]["vertices"]


def ones(count: int) -> str:
    return base64.b64encode(np.ones(count, "<f4").tobytes()).decode()


def test_a_pushed_step_is_seen_by_info_and_by_the_page(server, box):
    async def attempt():
        async with client(server, path=f"/ws?token={TOKEN}") as page:
            await page.call("session.open", dataset="box")
            values = np.arange(points(box), dtype="f8")
            done = await asyncio.to_thread(Client(server.base, TOKEN).append, "box", 50, {"r": values})
            while not any(note["method"] == "dataset.changed" for note in page.notifications):
                await page.receive()
            return done, page.notifications[0]["params"]["times"]

    before = told(box)["times"]
    done, times = asyncio.run(asyncio.wait_for(attempt(), PATIENCE))
    assert done == {"step": len(before), "time": 50} and times == [*before, 50]
    info = told(box)
    assert info["times"] == [*before, 50]
    assert info["checksums"]["verified"] > 0
    r = next(array for array in info["arrays"] if array["name"] == "r")
    assert r["times"][-1] == 50 and r["range"][1] >= points(box) - 1


def test_a_socket_pushes_binary_pieces(server, box):
    """The first array needs more than one piece: 512 KiB are 131,072 values."""
    async def attempt():
        async with Stream(f"ws://127.0.0.1:{server.port}/ws", TOKEN) as stream:
            vectors = np.ones((points(box), 64), "f4")
            assert vectors.nbytes > 512 << 10
            await stream.append("box", 50, {"wide": vectors, "r": [2.0] * points(box)})
            with pytest.raises(RpcError, match="not later"):
                await stream.append("box", 50, {"r": [2.0] * points(box)})
            with pytest.raises(ValueError, match="has 3 values; it must have"):
                await stream.append("box", 51, {"r": [1, 2, 3]})

    asyncio.run(asyncio.wait_for(attempt(), PATIENCE))
    assert told(box)["times"][-1] == 50


def test_appending_is_off_unless_allowed_and_needs_the_token(server, box):
    with pytest.raises(ConnectionError, match="401"):
        Client(server.base).append("box", 50, {"r": [0.0] * points(box)})
    with Server(box, "--token", TOKEN) as closed, pytest.raises(RpcError, match="--allow-append") as refused:
        Client(closed.base, TOKEN).append("box", 50, {"r": [0.0] * points(box)})
    assert refused.value.code == ERROR_CODES["NotAllowed"]


def test_our_own_user_needs_the_token_to_append(box):
    with Server(box, "--allow-append") as running:
        own = Client(running.base)
        assert own.call("dataset.list")[0]["name"] == "box", "let in without a token"
        with pytest.raises(RpcError, match="appending needs the token of the server") as refused:
            own.append("box", 50, {"r": [0.0] * points(box)})
        assert refused.value.code == ERROR_CODES["NotAllowed"]
        assert Client(running.base, running.token).append("box", 50, {"r": [0.0] * points(box)})["time"] == 50


def test_a_client_that_dies_half_way_leaves_nothing(server, box):
    calls = Client(server.base, TOKEN)
    upload = calls.call("append.begin", dataset="box", time=50, arrays=[{"name": "r"}])
    header = struct.Struct("<4sBBH16sIIQ")
    piece = header.pack(b"CIEL", 1, 16, 0, bytes.fromhex(upload["upload"]), 0, 400, 0) + bytes(400)
    # A truncated message. Its masking key is zero.
    half = b"\x82\xfe" + struct.pack(">H", len(piece)) + b"\0\0\0\0" + piece[:100]
    raw = socket.create_connection(("127.0.0.1", server.port), timeout=PATIENCE)
    raw.sendall(b"GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                b"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n"
                b"Sec-WebSocket-Protocol: ciel.v1\r\nAuthorization: Bearer " + TOKEN.encode() + b"\r\n\r\n")
    assert b" 101 " in raw.recv(4096)
    raw.sendall(half)
    raw.close()
    steps = len(told(box)["times"])
    assert Client(server.base, TOKEN).append("box", 51, {"r": [1.0] * points(box)})["step"] == steps
    with pytest.raises(RpcError, match="has 0 of"):
        calls.call("append.commit", upload=upload["upload"])
    assert left_aside(box) == []


def test_a_server_killed_in_a_commit_leaves_a_whole_dataset(box):
    """The server is killed at several moments during commits."""
    size = points(box)
    time = 100.0
    for delay in (0.0, 0.002, 0.005, 0.01, 0.02, 0.05):
        steps = len(told(box)["times"])
        with Server(box, *OPTIONS) as running:
            calls = Client(running.base, TOKEN)
            arrays = [{"name": f"a{i}"} for i in range(20)]
            upload = calls.call("append.begin", dataset="box", time=(time := time + 1), arrays=arrays)
            data = ones(size)
            for i in range(len(arrays)):
                calls.call("append.piece", upload=upload["upload"], array=i, offset=0, data=data)

            def commit(calls=calls, upload=upload):
                try:
                    calls.call("append.commit", upload=upload["upload"])
                except (OSError, RpcError):
                    pass

            committing = threading.Thread(target=commit)
            committing.start()
            committing.join(delay)
            running.process.send_signal(signal.SIGKILL)
            running.process.wait(PATIENCE)
            committing.join(PATIENCE)
        assert len(told(box)["times"]) in (steps, steps + 1)
    np.save(box.parent / "r.npy", np.zeros(size))
    result = ciel("append", box, "--time", 200, "--array", f"r={box.parent}/r.npy")
    assert result.returncode == 0, result.stderr
    assert left_aside(box) == []
    assert ciel("info", box).returncode == 0


@pytest.mark.skipif(os.geteuid() != 0, reason="only root may mount a file system")
def test_a_full_disk_is_named_before_the_first_piece_and_in_the_commit(tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=3m", "none", disk], capture_output=True).returncode != 0:
        pytest.skip("no file system can be mounted here")
    try:
        box = box_dataset.write_box(disk / "box.ciel")
        size = points(box)
        with Server(box, *OPTIONS) as running:
            calls = Client(running.base, TOKEN)
            with pytest.raises(RpcError, match="MB free and the step needs") as refused:
                calls.append("box", 50, {"wide": np.zeros((size, 64)), "wider": np.zeros((size, 64))})
            assert str(disk) not in str(refused.value)
            upload = calls.call("append.begin", dataset="box", time=50, arrays=[{"name": "r"}])
            data = ones(size)
            calls.call("append.piece", upload=upload["upload"], array=0, offset=0, data=data)
            filler = disk / "filler"
            with open(filler, "wb", buffering=0) as out, pytest.raises(OSError):
                while True:
                    out.write(bytes(4096))
            with pytest.raises(RpcError, match="No space left") as refused:
                calls.call("append.commit", upload=upload["upload"])
            assert str(disk) not in str(refused.value)
            assert left_aside(box) == [] and 50 not in told(box)["times"]
            filler.unlink()
            assert calls.call("append.commit", upload=upload["upload"])["time"] == 50
        assert told(box)["times"][-1] == 50
    finally:
        subprocess.run(["umount", disk], check=True)


def test_an_upload_that_is_silent_is_given_up(box):
    with Server(box, "--limit-upload-idle-seconds", "1", *OPTIONS) as running:
        calls = Client(running.base, TOKEN)
        upload = calls.call("append.begin", dataset="box", time=50, arrays=[{"name": "r"}])
        assert upload["idle_seconds"] == 1
        time.sleep(1.5)
        with pytest.raises(RpcError, match="without a piece for 1 s is cancelled"):
            calls.call("append.piece", upload=upload["upload"], array=0, offset=0, data="")


def test_an_upload_that_is_cancelled_is_gone(server):
    calls = Client(server.base, TOKEN)
    upload = calls.call("append.begin", dataset="box", time=50, arrays=[{"name": "r"}])
    assert upload["idle_seconds"] == 60 and upload["piece_bytes"] == 512 << 10
    assert calls.call("append.cancel", upload=upload["upload"]) is None
    with pytest.raises(RpcError, match="there is no upload"):
        calls.call("append.commit", upload=upload["upload"])


def test_nothing_is_appended_to_a_copy_that_serve_made(tmp_path):
    (tmp_path / "cube.vtk").write_text(
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nORIGIN 0 0 0\n"
        "SPACING 1 1 1\nPOINT_DATA 8\nSCALARS p float 1\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8\n")
    with Server(tmp_path / "cube.vtk", "--data-dir", tmp_path / "kept", *OPTIONS) as running:
        with pytest.raises(RpcError, match="a copy that `ciel serve` makes again .* `ciel import`") as refused:
            Client(running.base, TOKEN).append("cube", 50, {"p": [0.0] * 8})
        assert str(tmp_path) not in str(refused.value)
    copy = next((tmp_path / "kept").glob("*/cube.ciel"))
    np.save(tmp_path / "p.npy", np.zeros(8))
    result = ciel("append", copy, "--time", 50, "--array", f"p={tmp_path}/p.npy")
    assert result.returncode == 1 and "ciel import" in result.stderr
