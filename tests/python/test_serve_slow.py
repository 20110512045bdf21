"""Slow pictures, while another client is active."""

import asyncio
import json
import socket
import threading

import pytest

import box_dataset
from serve_process import PATIENCE, Server, client, iso, until

SIDE = 3000  # Pixels. The next request must arrive before this picture is drawn.


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return box_dataset.write_box(tmp_path_factory.mktemp("data") / "box.ciel", n=24)


def picture(number: int = 1) -> dict:
    scene = {"dataset": "box", "layers": {"iso": {"type": "iso", "array": "r", "values": [0.2, 0.3, 0.4]}}}
    return {"jsonrpc": "2.0", "id": number, "method": "picture.render",
            "params": {"scene": scene, "width": SIDE, "height": SIDE}}


def post(server: Server, body: object) -> socket.socket:
    """Sends a request and returns the connection without reading the answer."""
    text = json.dumps(body).encode()
    connection = socket.create_connection(("127.0.0.1", server.port), timeout=PATIENCE)
    connection.sendall(b"POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
                       b"Content-Length: %d\r\n\r\n" % len(text) + text)
    return connection


def waiting(server: Server) -> float:
    return server.metrics()["ciel_slow_calls_waiting"]


def begun(server: Server) -> float:
    """Number of pictures drawn or being drawn. A picture that has its turn may not be counted yet."""
    samples = server.metrics()
    return samples["ciel_pictures_total"] + samples["ciel_frame_workers_busy"]


def idle(server: Server) -> bool:
    samples = server.metrics()
    return samples["ciel_slow_calls"] == samples["ciel_slow_calls_waiting"] == samples["ciel_frame_workers_busy"] == 0


def test_a_viewer_is_served_beside_many_slow_pictures(box):
    async def look(server: Server) -> None:
        async with client(server) as viewer:
            session = (await viewer.call("session.open", dataset="box"))["session"]
            await viewer.call("view.open", session=session, width=320, height=200)
            for step in range(5):
                patched = await viewer.call("scene.patch", session=session, patch=iso(0.3 + 0.01 * step))
                await viewer.frame(patched["revision"])
                await viewer.call("server.info")

    with Server(box) as server:
        hogs = [post(server, picture()) for _ in range(20)]
        until(lambda: waiting(server) == 18)
        asyncio.run(look(server))
        assert server.get("/readyz").status_code == 200
        assert waiting(server) > 0, "all this while pictures wait"
        for hog in hogs:
            hog.close()
        until(lambda: idle(server))
        assert server.metrics()["ciel_pictures_total"] < 20, "what nobody waits for is not drawn"


def test_a_batch_ends_with_its_client(box):
    with Server(box) as server:
        batch = post(server, [picture(i) for i in range(64)])
        until(lambda: server.metrics()["ciel_slow_calls"] == 1)
        batch.close()
        until(lambda: idle(server))
        assert server.metrics()["ciel_pictures_total"] < 64


def test_a_websocket_that_closes_ends_its_pictures(box):
    async def ask_and_go(server: Server) -> None:
        async with server.socket() as asking:
            for number in range(10):
                await asking.send(json.dumps(picture(number)))
            await asyncio.to_thread(until, lambda: waiting(server) == 8)

    with Server(box) as server:
        asyncio.run(ask_and_go(server))
        until(lambda: idle(server))
        assert server.metrics()["ciel_pictures_total"] < 10


def test_quick_answers_overtake_slow_ones_on_one_websocket(box):
    async def ask(server: Server) -> list[int]:
        async with server.socket() as asking:
            await asking.send(json.dumps(picture(1)))
            await asking.send(json.dumps({"jsonrpc": "2.0", "id": 2, "method": "server.info"}))
            return [json.loads(await asking.recv())["id"] for _ in range(2)]

    with Server(box) as server:
        assert asyncio.run(ask(server)) == [2, 1]


def test_stopping_finishes_what_is_drawn_and_answers_the_rest(box):
    answers: list[bytes] = []

    def read(connection: socket.socket) -> None:
        answers.append(b"".join(iter(lambda: connection.recv(1 << 20), b"")))

    with Server(box, "--limit-drain-seconds", str(PATIENCE)) as server:
        hogs = [post(server, picture()) for _ in range(6)]
        until(lambda: waiting(server) == 4)
        until(lambda: begun(server) >= 2)
        readers = [threading.Thread(target=read, args=(hog,)) for hog in hogs]
        for reader in readers:
            reader.start()
        assert server.stop() == 0
        for reader in readers:
            reader.join(PATIENCE)
    assert len(answers) == 6
    assert sum(b"image/png" in answer for answer in answers) >= 2
    assert all(b"image/png" in answer or b"about to stop" in answer for answer in answers)
