"""Slow connections, and proxies with a limit on messages: frames in small messages, and texts before frames."""

import asyncio
import itertools
import json
import socket

import pytest

import box_dataset
from serve_process import PATIENCE, UPGRADE, Frame, Server, client, until

LONGEST = 512 << 10
SURFACES = {f"iso{i}": {"type": "iso", "array": "r", "values": [0.3 + 0.01 * j + 0.005 * i for j in range(64)],
                       "color": {"array": "x"}} for i in range(2)}


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    box = box_dataset.write_box(tmp_path_factory.mktemp("data") / "box.ciel", n=24)
    with Server(box) as running:
        yield running


def test_no_message_is_longer_than_512_kib_and_a_picture_by_post_has_any_length(server):
    async def attempt():
        async with client(server, max_size=LONGEST) as caller:
            session = (await caller.call("session.open", dataset="box"))["session"]
            await caller.call("scene.patch", session=session, patch={"layers": SURFACES})
            await caller.call("view.open", session=session, width=2600, height=2600)
            frame = await caller.frame(still=True)
            assert frame.kind == 1 and frame.whole_bytes > LONGEST
            size = {"width": 2000, "height": 2000}
            refused = await caller.answer(await caller.send("picture.render", session=session, **size))
            assert "send the call with POST /rpc" in refused["error"]["data"]["reason"]
            assert len(server.call("picture.render", session=session, **size)["data"]) > LONGEST

    asyncio.run(asyncio.wait_for(attempt(), PATIENCE))


class SlowReader:
    """A WebSocket client without a library, which reads single messages only on demand."""

    def __init__(self, server: Server):
        self.socket = socket.socket()
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        self.socket.settimeout(PATIENCE)
        self.socket.connect(("127.0.0.1", server.port))
        self.socket.sendall(UPGRADE)
        while not self.take(1, until_blank_line=True):
            pass
        self.ids = itertools.count(1)

    def take(self, count: int, until_blank_line: bool = False) -> bytes:
        taken = b""
        while not taken.endswith(b"\r\n\r\n") if until_blank_line else len(taken) < count:
            some = self.socket.recv(1 if until_blank_line else count - len(taken))
            assert some, "the server has closed"
            taken += some
        return taken

    def message(self) -> bytes | dict:
        opcode, length = self.take(2)
        if length > 125:
            length = int.from_bytes(self.take(2 if length == 126 else 8), "big")
        payload = self.take(length)
        return json.loads(payload) if opcode == 0x81 else payload

    def send(self, method: str, **params) -> int:
        number = next(self.ids)
        payload = json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": params}).encode().ljust(126)
        self.socket.sendall(bytes([0x81, 0xFE]) + len(payload).to_bytes(2, "big") + b"\0\0\0\0" + payload)
        return number

    def answer(self, number: int) -> tuple[dict, int]:
        """Returns the result, and the bytes of frames that arrived before it."""
        frames = 0
        while not (isinstance(message := self.message(), dict) and message.get("id") == number):
            frames += len(message) if isinstance(message, bytes) else 0
        return message["result"], frames


def test_an_answer_overtakes_the_polygons_that_a_slow_line_has_not_taken(server):
    """On a slow connection, the bytes before an answer decide how long the user waits."""
    reader = SlowReader(server)
    session = reader.answer(reader.send("session.open", dataset="box"))[0]["session"]
    reader.answer(reader.send("scene.patch", session=session, patch={"layers": SURFACES}))
    frames, asked = "ciel_frames_total{kind=\"interactive\"}", "ciel_rpc_requests_total{method=\"server.info\"}"
    made = server.metrics()[frames]
    reader.send("view.open", session=session, width=640, height=360, stream="geometry")
    until(lambda: server.metrics()[frames] > made)  # a frame is in the send queue, and the client does not read
    before = server.metrics().get(asked, 0)
    number = reader.send("server.info")
    until(lambda: server.metrics().get(asked, 0) > before)
    server.metrics()  # the server answers directly after it has counted the request
    bytes_before = reader.answer(number)[1]
    whole = []
    while not whole or not whole[-1].flags & 2:
        message = reader.message()
        whole += [Frame(message)] if isinstance(message, bytes) else []
    assert sum(len(frame.payload) for frame in whole) > 4 * bytes_before, "the frame has to be longer than what overtakes it"
    assert bytes_before < 400 << 10
    reader.socket.close()
