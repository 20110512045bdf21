"""`ciel serve` as a process: start, failed starts, shutdown, constant memory and open files."""

import asyncio
import base64
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import struct
import subprocess

import pytest
import requests
import websockets

import box_dataset
from program import CIEL, ciel
from serve_process import PATIENCE, Client, Server, client, iso, until


TETRAHEDRON = """# vtk DataFile Version 3.0
one cell
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 4 float
0 0 0 1 0 0 0 1 0 0 0 1
CELLS 1 5
4 0 1 2 3
CELL_TYPES 1
10
"""


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return box_dataset.write_box(tmp_path_factory.mktemp("data") / "box.ciel", n=24)


def failure(*arguments: str) -> tuple[int, str]:
    result = ciel("serve", *arguments, timeout=PATIENCE)
    assert result.stdout == ""
    return result.returncode, result.stderr


def test_the_address_is_one_line(box):
    with Server(box, "--prefix", "x") as running:
        assert running.line == f"CIEL listening on http://127.0.0.1:{running.port}/x/?token={running.token}"
        assert running.get("/healthz").status_code == 200


@pytest.mark.parametrize(("arguments", "code", "words"), [
    (["--port", "notaport"], 2, ["--port"]),
    (["--port", "70000"], 2, ["--port"]),
    (["--gl", "vulkan"], 2, ["--gl", "osmesa"]),
    (["--algorithm", "magic"], 2, ["--algorithm"]),
    (["--decider", "magic"], 2, ["--decider"]),
    (["--no-such-option"], 2, ["no-such-option"]),
    (["/no/such/data.ciel"], 1, ["/no/such/data.ciel", "does not exist"]),
    (["--port", "0", "--host", "203.0.113.7"], 1, ["203.0.113.7", "--host"]),
    (["--port", "0", "--host", "no.such.host.invalid"], 1, ["no.such.host.invalid", "--host"]),
    (["--port", "0", "--prefix", "/a b"], 1, ["/a b", "prefix"]),
    (["--port", "0", "--token", "short"], 1, ["token", "8 characters"]),
    (["--port", "0", "--token", "semi;colon;token"], 1, ["token"]),
    (["--port", "0", "--webclient", "/no/such/folder"], 1, ["/no/such/folder", "--webclient"]),
])
def test_what_cannot_be_is_said_in_one_line(arguments, code, words):
    status, text = failure(*arguments, "--log-level", "off")
    assert status == code, text
    for word in words:
        assert word in text
    assert text.startswith("ciel: ") and text.count("\n") == 1, text


def test_a_port_in_use_is_named(box):
    with Server(box) as running:
        status, text = failure("--port", str(running.port), "--log-level", "off")
        assert status == 1 and f"127.0.0.1:{running.port} is in use" in text and "--port" in text


def test_it_comes_back_on_the_same_port(box):
    with Server(box) as first:
        first.get("/healthz")
        assert first.stop() == 0
        for _ in range(3):
            with Server(box, "--port", str(first.port)) as again:
                assert again.port == first.port and again.get("/healthz").status_code == 200
                assert again.stop() == 0


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_ends_it_cleanly(box, number, tmp_path):
    with Server(box, log=tmp_path / "log") as running:
        idle = requests.Session()
        idle.get(running.base + "/healthz", timeout=PATIENCE)  # this kept-alive connection must not delay the shutdown
        running.process.send_signal(number)
        assert running.process.wait(PATIENCE) == 0
        assert "stopping" in (tmp_path / "log").read_text()


def catches(process: subprocess.Popen, number: int) -> bool:
    """True when the process has a handler for this signal, or has ended."""
    if process.poll() is not None:
        return True
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    return int(re.search(r"SigCgt:\s+(\w+)", status).group(1), 16) >> (number - 1) & 1 == 1


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_the_first_handler_of_a_signal_ends_it(box, number):
    process = subprocess.Popen([CIEL, "serve", "--port", "0", box], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    until(lambda: catches(process, number))
    process.send_signal(number)
    try:
        process.communicate(timeout=PATIENCE)  # raises when the process ignores the signal
    finally:
        process.kill()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_at_the_moment_of_the_address_ends_it_cleanly(box, number):
    with Server(box) as running:
        running.process.send_signal(number)
        assert running.process.wait(PATIENCE) == 0


def test_sigterm_drains_while_frames_stream(box):
    async def attempt(running: Server) -> None:
        async with client(running) as caller:
            session = (await caller.call("session.open", dataset="box"))["session"]
            await caller.call("view.open", session=session, width=640, height=480)
            with pytest.raises(websockets.ConnectionClosed) as closed:
                for i in range(100_000):
                    await caller.send("scene.patch", session=session, patch=iso(0.4 + i % 100 / 200))
                    message = await caller.receive()
                    if not isinstance(message, dict):
                        await caller.acknowledge(message)
                    if i == 30:
                        running.process.send_signal(signal.SIGTERM)
            assert closed.value.rcvd.code == 1001
            assert "server.draining" in [notification["method"] for notification in caller.notifications]

    with Server(box) as running:
        asyncio.run(asyncio.wait_for(attempt(running), PATIENCE))
        assert running.process.wait(PATIENCE) == 0
        with pytest.raises(requests.ConnectionError):
            running.get("/healthz")


def is_refused(port: int) -> bool:
    try:
        socket.create_connection(("127.0.0.1", port)).close()
    except ConnectionRefusedError:
        return True
    except ConnectionResetError:  # the connection was waiting to be accepted when the listener closed
        return False
    return False


async def picture_under_way(running: Server, caller: Client) -> tuple[int, int]:
    """Starts a picture that is slow enough to still be drawn. Returns the request's id and the picture's side."""
    for side in (16, 1024, 2048, 4096):
        done = running.metrics()["ciel_pictures_total"]
        number = await caller.send("picture.render", scene={"dataset": "box", **iso(0.7)}, width=side, height=side)
        while (now := running.metrics())["ciel_pictures_total"] == done and side > 16:
            if now["ciel_frame_workers_busy"] == 1:
                return number, side
        await caller.answer(number)
    raise AssertionError("no picture takes long enough to be seen under way")


def test_a_picture_under_way_is_delivered_and_nobody_else_is_let_in(box):
    async def attempt(running: Server) -> None:
        async with client(running) as caller:
            number, side = await picture_under_way(running, caller)
            running.process.send_signal(signal.SIGTERM)
            until(lambda: is_refused(running.port))
            answer = await caller.answer(number)
            picture = base64.b64decode(answer["result"]["data"])
            assert picture.startswith(b"\x89PNG") and struct.unpack_from(">II", picture, 16) == (side, side)
            with pytest.raises(websockets.ConnectionClosed) as closed:
                while True:
                    await caller.receive()
            assert closed.value.rcvd.code == 1001
            assert "server.draining" in [notification["method"] for notification in caller.notifications]

    with Server(box, "--limit-drain-seconds", str(PATIENCE)) as running:
        asyncio.run(asyncio.wait_for(attempt(running), PATIENCE))
        assert running.process.wait(PATIENCE) == 0


def test_a_dead_client_does_not_hold_up_the_end(box):
    async def attempt(running: Server) -> None:
        async with client(running, close_timeout=1) as caller:
            session = (await caller.call("session.open", dataset="box"))["session"]
            await caller.call("view.open", session=session, width=640, height=480)
            caller.socket.transport.pause_reading()  # the client will not answer the close frame
            running.process.send_signal(signal.SIGTERM)
            status = await asyncio.get_running_loop().run_in_executor(None, running.process.wait, PATIENCE)
            assert status == 0

    with Server(box) as running:
        asyncio.run(asyncio.wait_for(attempt(running), 2 * PATIENCE))


def test_a_second_signal_ends_it_at_once(box):
    with Server(box) as running:
        held = socket.create_connection(("127.0.0.1", running.port))
        # Half a request body: the connection is busy, so the server waits for it.
        held.sendall(b"POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 9\r\n\r\n{")
        until(lambda: running.metrics()["ciel_gateway_connections_open"] >= 2)
        running.process.send_signal(signal.SIGTERM)
        until(lambda: is_refused(running.port))
        running.process.send_signal(signal.SIGTERM)
        assert running.process.wait(PATIENCE) in (0, 128 + signal.SIGTERM)
        held.close()


def test_a_dataset_truncated_while_it_is_shown_is_named_and_comes_back(tmp_path):
    dataset = box_dataset.write_box(tmp_path / "box.ciel", n=24)
    kept = tmp_path / "kept"
    shutil.copytree(dataset, kept)

    async def attempt(running: Server) -> None:
        async with client(running) as caller:
            opened = await caller.call("session.open", dataset="box", scene={"dataset": "box", **iso(0.4)})
            await caller.call("view.open", session=opened["session"], width=160, height=120)
            await caller.frame(opened["revision"], still=True)
            for file in dataset.rglob("*"):
                if file.is_file() and file.stat().st_size > 4096:
                    os.truncate(file, 0)
            refused = await caller.answer(await caller.send("scene.patch", session=opened["session"], patch=iso(0.6)))
            while "error" not in refused and not any(n["method"] == "view.failed" for n in caller.notifications):
                await caller.receive()
            # Reported by the frame, or by the next check of the directory.
            told = json.dumps([refused, caller.notifications])
            assert "meshes/0" in told and ("shrunk while it was open" in told or "has 0 bytes, but" in told)
            assert running.get("/healthz").status_code == 200
            shutil.copytree(kept, dataset, dirs_exist_ok=True)
            while not any(n["method"] == "dataset.changed" for n in caller.notifications):
                await caller.receive()
            shown = await caller.call("scene.patch", session=opened["session"], patch=iso(0.5))
            await caller.frame(shown["revision"], still=True)

    with Server(dataset) as running:
        asyncio.run(asyncio.wait_for(attempt(running), PATIENCE))
        assert running.stop() == 0


def test_another_dataset_copied_over_a_served_one_is_a_sentence_and_then_served(tmp_path):
    """As by cp -r other.ciel/. served.ciel/, which rewrites each file in place."""
    dataset = box_dataset.write_box(tmp_path / "served.ciel", n=12)
    other = box_dataset.write_box(tmp_path / "other.ciel", n=20)
    asked = [("picture.render", {"width": 64, "height": 64}), ("surface.export", {"layer": "iso", "format": "ply"}),
             ("probe.point", {"pixel": [32, 32], "width": 64, "height": 64})]

    def answers(running: Server) -> list[dict]:
        calls = [{"jsonrpc": "2.0", "id": i, "method": method,
                  "params": {"scene": {"dataset": "served", **iso(0.4)}, **params}} for i, (method, params) in enumerate(asked)]
        return requests.post(running.base + "/rpc", timeout=PATIENCE, json=calls).json()

    with Server(dataset) as running:
        cells = running.call("dataset.describe", dataset="served")["mesh"]["cells"]["hexahedron"]
        assert all("result" in answer for answer in answers(running))
        shutil.copytree(other, dataset, dirs_exist_ok=True)
        for answer in answers(running):
            assert "result" in answer or len(answer["error"]["data"]["reason"]) > 20, answer
        assert running.get("/healthz").status_code == 200
        until(lambda: running.call("dataset.describe", dataset="served")["mesh"]["cells"]["hexahedron"] > cells)
        assert all("result" in answer for answer in answers(running))
        assert running.stop() == 0


def test_one_bad_file_does_not_take_the_others_with_it(box, tmp_path):
    (tmp_path / "bad.vtu").write_text("<VTKFile type='UnstructuredGrid'>")
    with Server(box, tmp_path / "bad.vtu", "--data-dir", tmp_path / "imported", log=tmp_path / "log") as running:
        listed = {entry["name"]: entry["problem"] for entry in running.call("dataset.list")}
        assert listed["box"] == "" and "bad.vtu" in listed["bad"]
        assert str(tmp_path) not in listed["bad"], "clients do not learn paths of the server"
        assert "dataset bad" in (log := (tmp_path / "log").read_text()) and str(tmp_path / "bad.vtu") in log
    status, text = failure(str(tmp_path / "bad.vtu"), "--data-dir", str(tmp_path / "imported"))
    assert status == 1 and "bad.vtu" in text.splitlines()[-1]


def test_the_memory_of_imports_is_a_limit_of_the_server(box, tmp_path):
    points = 1_500_000
    (tmp_path / "large.vtk").write_text(f"# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {points} float\n"
                                       + "0 0 0\n" * points + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n")
    limit = ("--limit-import-memory-bytes", "32M", "--limit-import-stalled-seconds", "600")
    with Server(box, tmp_path / "large.vtk", "--data-dir", tmp_path / "imported", *limit) as running:
        problem = {entry["name"]: entry["problem"] for entry in running.call("dataset.list")}["large"]
        assert "large.vtk: the memory limit of 0.0336 GB was reached; raise the limit with --limit-import-memory-bytes" in problem
        limits = running.call("server.info")["limits"]
        assert (limits["import_memory_bytes"], limits["import_stalled_seconds"]) == (32 << 20, 600)


def test_a_folder_that_cannot_hold_an_import_is_not_told(box, tmp_path):
    imported = tmp_path / "imported"
    (tmp_path / "good.vtk").write_text(TETRAHEDRON)
    with Server(box, tmp_path / "good.vtk", "--data-dir", imported):
        pass
    (folder,) = imported.iterdir()
    shutil.rmtree(folder)
    folder.write_text("a file where the folder should be")
    with Server(box, tmp_path / "good.vtk", "--data-dir", imported) as running:
        problem = {entry["name"]: entry["problem"] for entry in running.call("dataset.list")}["good"]
        assert "cannot be" in problem and str(imported) not in problem and str(tmp_path) not in problem


def test_two_hundred_visitors_leave_nothing_behind(box):
    async def visit(running: Server) -> None:
        async with running.socket() as opened:
            caller = Client(opened)
            session = (await caller.call("session.open", dataset="box"))["session"]
            await caller.call("view.open", session=session, width=64, height=48)
            await caller.frame(1)
            await caller.call("session.close", session=session)

    async def visits(running: Server, count: int) -> None:
        for _ in range(count):
            await visit(running)

    with Server(box) as running:
        def files() -> int:
            """Returns the minimum of 100 counts, because each check opens a connection that takes a moment to close."""
            until(lambda: running.metrics()["ciel_gateway_websockets_open"] == 0)
            return min(running.open_files() for _ in range(100) if running.get("/healthz"))

        asyncio.run(visits(running, 50))  # lets caches and allocator arenas reach their final size
        before, memory = files(), running.resident_kilobytes()
        asyncio.run(visits(running, 200))
        assert any(files() <= before for _ in range(20)), "what the visits opened stays open"
        assert running.resident_kilobytes() < memory + 16_384


def test_limits_are_options_and_variables_and_the_option_comes_first(box):
    with Server(box, "--limit-sessions", "3", "--limit-message-bytes", "64K",
                environment={"CIEL_LIMIT_LAYERS": "5", "CIEL_LIMIT_SESSIONS": "9"}) as running:
        limits = running.call("server.info")["limits"]
        assert (limits["sessions"], limits["message_bytes"], limits["layers"]) == (3, 65536, 5)
        memory = limits["dataset_memory_bytes"]
    with Server(box, "--limit-dataset-memory-bytes", "20%") as running:
        assert running.call("server.info")["limits"]["dataset_memory_bytes"] == pytest.approx(memory / 2, rel=1e-3)


def test_a_variable_that_is_no_limit_is_said_in_one_line():
    result = ciel("serve", timeout=PATIENCE, env={**os.environ, "CIEL_LIMIT_SESSIONS": "many"})
    assert result.returncode == 2 and result.stderr.count("\n") == 1, result.stderr
    assert "many is not a whole number" in result.stderr and "--limit-sessions" in result.stderr
