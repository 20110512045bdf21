"""The operator's view of a real server: its log, and the memory that clients make it hold."""

import asyncio
import json
import os
import pwd
import re

import pytest
import requests

import box_dataset
from serve_process import PATIENCE, Server, client, until

TOKEN = "0123456789abcdef0123"
UTC = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z")


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return box_dataset.write_box(tmp_path_factory.mktemp("data") / "box.ciel")


def test_each_line_is_json_with_utc_and_links_the_clients_error(box, tmp_path):
    with Server(box, "--log-format", "json", log=tmp_path / "log", environment={"TZ": "Asia/Tokyo"}) as running:
        answer = requests.post(running.base + "/rpc", timeout=PATIENCE, json={
            "jsonrpc": "2.0", "id": 1, "method": "scene.get", "params": {"session": "s" * 30}})
        opened = running.call("session.open", dataset="box")
        running.call("session.close", session=opened["session"])
        running.call("session.open", dataset="box")
    whole = (tmp_path / "log").read_text()
    lines = [json.loads(line) for line in whole.splitlines() if line.startswith("{")]  # other lines are Mesa's
    assert all(UTC.fullmatch(line["time"]) and line["level"] and line["event"] for line in lines)
    failed, = [line for line in lines if line["event"] == "call failed"]
    assert failed["request"] == answer.json()["error"]["data"]["request"] == answer.headers["X-Request-Id"]
    assert failed["method"] == "scene.get" and failed["ms"] >= 0 and failed["remote"].startswith("127.0.0.1:")
    events = [line["event"] for line in lines]
    assert events.count("session opened") == events.count("session closed") == 2
    assert {line["why"] for line in lines if line["event"] == "session closed"} == {"by a client", "the server stops"}
    own_user = pwd.getpwuid(os.geteuid()).pw_name
    for line in lines:
        if line["event"].startswith("session "):
            assert line["user"] == own_user and line["request"] and line.get("ms", line.get("seconds")) >= 0, line


def test_each_kind_of_refusal_is_told_once_a_minute(box, tmp_path):
    with Server(box, "--token", TOKEN, "--log-format", "json", log=tmp_path / "log") as running:
        for _ in range(3):
            assert running.get("/metrics").status_code == 401
            assert running.get("/healthz", headers={"Host": "elsewhere.example"}).status_code == 403
            assert running.get("/healthz", headers={"Cookie": "a" * 60_000}).status_code == 431
            assert running.get("/nothing").status_code == 404
    lines = [json.loads(line) for line in (tmp_path / "log").read_text().splitlines() if line.startswith("{")]
    refused = [line for line in lines if line["event"] == "a request was refused"]
    assert [line["status"] for line in refused] == ["401", "403", "431"]
    assert all(line["reason"] and line["remote"] == "127.0.0.1" and line["request"] for line in refused), refused


def test_no_line_has_a_query_a_cookie_a_token_or_a_whole_session_id(box, tmp_path):
    with Server(box, "--token", TOKEN, "--log-level", "debug", log=tmp_path / "log") as running:
        headers = {"Authorization": "Bearer " + TOKEN}
        running.get("/rpc?token=wrong-token-0000&secret-query=1", cookies={"ciel_token": "secret-cookie"})
        running.get("/?token=" + TOKEN)
        running.get("/metrics", headers={"Authorization": "Bearer wrong-token-1111"})
        opened = requests.post(running.base + "/rpc", timeout=PATIENCE, headers=headers, json={
            "jsonrpc": "2.0", "id": 1, "method": "session.open", "params": {"dataset": "box"}}).json()["result"]["session"]
        for session in (opened, "missing" * 5):
            requests.post(running.base + "/rpc?token=" + TOKEN, timeout=PATIENCE, json={
                "jsonrpc": "2.0", "id": 1, "method": "scene.patch", "params": {"session": session, "patch": {"time": "x"}}})
    whole = (tmp_path / "log").read_text()
    assert "call failed" in whole and opened[:8] in whole
    for secret in (TOKEN, "wrong-token", "secret", "token=", opened, "missing" * 5):
        assert secret not in whole, secret


def test_readiness_is_answered_while_the_worker_is_busy(box):
    scene = {"dataset": "box", "layers": {"lines": {"type": "edges", "width": 32, "opacity": 0.3}}}

    async def attempt(running: Server) -> None:
        async with client(running) as caller:
            session = (await caller.call("session.open", scene=scene))["session"]
            await caller.call("view.open", session=session, width=1500, height=1500, pixel_ratio=4)
            await asyncio.to_thread(until, lambda: running.metrics()["ciel_frame_workers_busy"] == 1)
            await asyncio.sleep(1.1)  # longer than a result stays fresh
            answer = await asyncio.to_thread(running.get, "/readyz")
            assert answer.status_code == 200 and answer.json()["ready"]
            assert running.metrics()["ciel_frame_workers_busy"] == 1, "the frame was finished before the answer"

    with Server(box) as running:
        assert running.get("/readyz").json()["ready"]
        asyncio.run(asyncio.wait_for(attempt(running), PATIENCE))


def test_names_and_histories_are_bounded_in_bytes(box):
    """Without limits, 20 layer names of 0.9 MB and 200 patches of 40 bytes held 3.7 GiB."""
    with Server(box) as running:
        session = running.call("session.open", dataset="box")["session"]
        for letter in "abcdefghijklmnopqrst":
            answer = requests.post(running.base + "/rpc", timeout=PATIENCE, json={
                "jsonrpc": "2.0", "id": 1, "method": "scene.patch",
                "params": {"session": session, "patch": {"layers": {letter * 900_000: {"type": "outline"}}}}}).json()
            assert answer["error"]["code"] == -32002 and "256" in answer["error"]["data"]["reason"]
        for letter in "abcdefghijklmnopqrst":
            running.call("scene.patch", session=session, patch={"layers": {letter * 256: {"type": "outline"}}})
        for step in range(200):
            running.call("scene.patch", session=session, patch={"time": step / 1000})
        assert running.metrics()['ciel_memory_bytes{kind="scenes"}'] < 10 << 20


def test_eight_unread_views_hold_what_one_connection_may(tmp_path):
    """Without a limit for the connection, 8 unread geometry views held 1.6 GiB, a whole frame each."""
    large = box_dataset.write_box(tmp_path / "box.ciel", n=64, steps=1)  # its geometry frames have 1.3 MB
    unsent = 'ciel_memory_bytes{kind="unsent"}'

    async def attempt(running: Server) -> None:
        async with client(running, max_queue=1, read_limit=1024) as caller:
            scene = {"dataset": "box", "layers": {"all": {"type": "surface"}}}
            session = (await caller.call("session.open", scene=scene))["session"]
            caller.socket.transport.pause_reading()
            for _ in range(8):
                await caller.send("view.open", session=session, width=64, height=64, stream="geometry")
            held = 0
            for _ in range(50):
                held = max(held, await asyncio.to_thread(lambda: running.metrics()[unsent]))
            assert 0 < held <= 2 << 20
            caller.socket.transport.resume_reading()
            views = set()
            while len(views) < 8:
                message = await caller.receive()
                if not isinstance(message, dict):
                    views.add(message.view)
                    await caller.acknowledge(message)
            assert len(views) == 8

    with Server(large, "--limit-unsent-bytes", "2M") as running:
        asyncio.run(asyncio.wait_for(attempt(running), PATIENCE))


def test_a_batch_has_answers_of_so_many_bytes(box):
    export = {"jsonrpc": "2.0", "method": "surface.export", "params": {
        "scene": {"dataset": "box", "layers": {"all": {"type": "surface"}}}, "layer": "all", "format": "ply"}}
    with Server(box, "--limit-batch-answer-bytes", "256K") as running:
        answer = requests.post(running.base + "/rpc", timeout=PATIENCE,
                               json=[{**export, "id": number} for number in range(16)])
        results = ["result" in each for each in answer.json()]
        assert 0 < sum(results) < 16 and len(answer.content) < 300 << 10
        assert running.metrics()['ciel_memory_bytes{kind="answers"}'] == 0
