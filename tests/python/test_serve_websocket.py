"""The WebSocket: who may connect, allowed messages, and refusals."""

import asyncio
import json
import random
import socket
import struct

import pytest
import websockets

import box_dataset
from serve_process import PATIENCE, UPGRADE, Client, Server, client, iso, until

TOKEN = "0123456789abcdef"


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    box = box_dataset.write_box(tmp_path_factory.mktemp("data") / "box.ciel")
    with Server(box, "--prefix", "/ciel", "--origin", "https://lab.example.org") as running:
        yield running


def refusal(server: Server, path="/ws", **options) -> int:
    """HTTP status with which the server refuses the handshake."""

    async def attempt():
        with pytest.raises(websockets.InvalidHandshake) as refused:
            async with server.socket(path, **options):
                pass
        return getattr(refused.value, "response", refused.value).status_code  # websockets 14 and later has `response`

    return asyncio.run(attempt())


def opens(server: Server, path="/ws", **options) -> bool:
    async def attempt():
        async with server.socket(path, **options) as opened:
            assert opened.subprotocol == "ciel.v1"
            return (await Client(opened).call("dataset.list"))[0]["name"] == "box"

    return asyncio.run(attempt())


def test_the_subprotocol_is_required_and_echoed(server):
    assert opens(server)
    assert opens(server, subprotocols=["other", "ciel.v1"])
    assert refusal(server, subprotocols=None) == 400
    assert refusal(server, subprotocols=["ciel.v2"]) == 400


def test_origins_are_checked(server):
    assert opens(server, origin=server.base)
    assert opens(server, origin="https://lab.example.org")
    for origin in ("http://evil.example", "null", "http://127.0.0.1:1", "https://lab.example.org.evil.example"):
        assert refusal(server, origin=origin) == 403, origin


def test_hosts_are_checked(server):
    headers = {"Host": "evil.example", "Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13",
               "Sec-WebSocket-Key": "AAAAAAAAAAAAAAAAAAAAAA==", "Sec-WebSocket-Protocol": "ciel.v1"}
    assert server.get("/ws", headers=headers).status_code == 403


def test_the_prefix_may_be_there(server):
    assert opens(server, "/ciel/ws")
    assert refusal(server, "/other/ws") == 404


def test_the_token_is_asked_for(tmp_path):
    box_dataset.write_box(tmp_path / "box.ciel", n=3)
    with Server(tmp_path, "--token", TOKEN) as guarded:
        assert refusal(guarded) == 401
        assert refusal(guarded, "/ws?token=wrong") == 401
        assert opens(guarded, "/ws?token=" + TOKEN)
        assert opens(guarded, headers={"Authorization": "Bearer " + TOKEN})
        assert opens(guarded, headers={"Cookie": f"a=b; ciel_token_{guarded.port}={TOKEN}"})
        assert refusal(guarded, headers={"Cookie": f"ciel_token_{guarded.port + 1}={TOKEN}"}) == 401


def close_code(server: Server, send) -> int:
    async def attempt():
        async with server.socket() as opened:
            with pytest.raises(websockets.ConnectionClosed) as closed:
                await send(opened)
                while True:
                    await opened.recv()
            return closed.value.rcvd.code

    return asyncio.run(asyncio.wait_for(attempt(), PATIENCE))


def test_binary_messages_are_refused(server):
    assert close_code(server, lambda opened: opened.send(b"{}")) == 1003


def test_messages_over_the_limit_are_refused(server):
    limit = server.call("server.info")["limits"]["message_bytes"]
    assert close_code(server, lambda opened: opened.send("x" * (int(limit) + 1))) == 1009

    async def just_fits():
        async with client(server) as caller:
            text = json.dumps({"jsonrpc": "2.0", "id": 1, "method": "dataset.list"})
            await caller.socket.send(text + " " * (int(limit) - len(text)))
            assert "result" in await caller.answer(1)

    asyncio.run(just_fits())


class Raw:
    """A WebSocket client without a library, for messages that libraries refuse to send."""

    def __init__(self, server: Server):
        self.socket = socket.create_connection(("127.0.0.1", server.port), timeout=PATIENCE)
        self.socket.sendall(UPGRADE)
        self.received = b""
        while b"\r\n\r\n" not in self.received:
            self.received += self.socket.recv(4096)
        head, self.received = self.received.split(b"\r\n\r\n", 1)
        assert head.startswith(b"HTTP/1.1 101")

    def send(self, data: bytes) -> "Raw":
        self.socket.sendall(data)
        return self

    def close_code(self) -> int | None:
        """Code of the next close frame, or None when the connection ends without one."""
        try:
            while chunk := self.socket.recv(4096):
                self.received += chunk
        except ConnectionResetError:
            pass
        self.socket.close()
        if not self.received:
            return None
        assert self.received[0] == 0x88, self.received[:10]
        return struct.unpack("!H", self.received[2:4])[0]


def masked(opcode: int, payload: bytes, final: bool = True) -> bytes:
    assert len(payload) < 126
    key = b"\x01\x02\x03\x04"
    body = bytes(byte ^ key[i % 4] for i, byte in enumerate(payload))
    return bytes([(0x80 if final else 0) | opcode, 0x80 | len(payload)]) + key + body


@pytest.mark.parametrize(("name", "data", "code"), [
    ("invalid UTF-8", masked(1, b"\xff\xfe"), 1007),
    ("cut UTF-8", masked(1, b"\xe2\x82"), 1007),
    ("surrogate in UTF-8", masked(1, b"\xed\xa0\x80"), 1007),
    ("UTF-8 cut at the end of a message", masked(1, b"\xe2", final=False) + masked(0, b"\x82"), 1007),
    ("unmasked", b"\x81\x02{}", 1002),
    ("reserved bit", b"\xc1" + masked(1, b"{}")[1:], 1002),
    ("reserved opcode", masked(3, b"{}"), 1002),
    ("continuation of nothing", masked(0, b"{}"), 1002),
    ("two beginnings", masked(1, b"{", final=False) + masked(1, b"}"), 1002),
    ("cut control frame", masked(9, b"", final=False), 1002),
    ("long ping", bytes([0x89, 0xFE, 0x01, 0x00]) + b"\0" * 260, 1002),
    ("huge length", bytes([0x81, 0xFF]) + b"\x7f" + b"\xff" * 7 + b"\0\0\0\0", 1009),
    ("close with one byte", masked(8, b"\x03"), 1002),
    ("HTTP again", b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n", 1002),
    ("noise", b"\xf3\xa7" + random.Random(8).randbytes(200), 1002),
])
def test_broken_frames_end_their_connection_only(server, name, data, code):
    assert Raw(server).send(data).close_code() == code
    assert opens(server)


def test_what_ends_a_connection_has_a_line_in_the_log(tmp_path):
    box_dataset.write_box(tmp_path / "box.ciel", n=3)
    log = tmp_path / "log"
    with Server(tmp_path / "box.ciel", log=log) as running:
        Raw(running).send(masked(3, b"{}")).close_code()
        Raw(running).send(masked(2, b"{}")).close_code()
        Raw(running).send(masked(8, struct.pack("!H", 1000))).close_code()
        lines = [line for line in log.read_text().splitlines() if "a WebSocket was closed" in line]
        assert len(lines) == 2, lines
        assert "illegal opcode" in lines[0] and "--allow-append" in lines[1]
        assert all("remote=127.0.0.1" in line and "seconds=" in line and "request=" in line for line in lines)


def test_another_version_of_the_protocol_is_refused(server):
    for version in ("12", "", "13, 8"):
        headers = {"Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": version,
                   "Sec-WebSocket-Key": "AAAAAAAAAAAAAAAAAAAAAA==", "Sec-WebSocket-Protocol": "ciel.v1"}
        answer = server.get("/ws", headers=headers)
        assert answer.status_code == 426 and answer.headers["Sec-WebSocket-Version"] == "13", version
        assert answer.headers["Date"] and answer.headers["X-Request-Id"]


def test_a_close_is_answered(server):
    assert Raw(server).send(masked(8, struct.pack("!H", 1000))).close_code() == 1000


def test_pings_are_answered_in_between(server):
    raw = Raw(server).send(masked(1, b'{"jsonrpc":', final=False) + masked(9, b"beat"))
    while len(raw.received) < 6:
        raw.received += raw.socket.recv(4096)
    assert raw.received == b"\x8a\x04beat"
    raw.socket.close()


@pytest.mark.parametrize(("text", "code"), [
    ("", -32700), ("{", -32700), ("nonsense", -32700), ("[]", -32600), ("1", -32600), ("null", -32600),
    ("[" * 40 + "]" * 40, None), ('{"jsonrpc":"2.0","id":1,"method":"no.such"}', -32601),
    ('{"jsonrpc":"1.0","id":1,"method":"dataset.list"}', -32600), ('{"jsonrpc":"2.0","id":1}', -32600),
    ('{"jsonrpc":"2.0","id":1,"method":"dataset.describe","params":{}}', -32602),
    ('{"jsonrpc":"2.0","id":1,"method":"dataset.describe","params":{"dataset":1}}', -32602),
])
def test_bad_requests_are_answered_and_the_connection_stays(server, text, code):
    async def attempt():
        async with client(server) as caller:
            await caller.socket.send(text)
            answer = json.loads(await caller.socket.recv())
            assert code is None or answer["error"]["code"] == code, answer
            assert (answer[0] if isinstance(answer, list) else answer)["error"]["message"]
            assert await caller.call("dataset.list")

    asyncio.run(asyncio.wait_for(attempt(), PATIENCE))


@pytest.mark.parametrize("levels", [1, 100_000])
def test_deep_documents_are_refused(server, levels):
    depth = int(server.call("server.info")["limits"]["json_depth"])

    async def attempt():
        async with client(server) as caller:
            deep = "[" * (depth + levels) + "]" * (depth + levels)
            await caller.socket.send('{"jsonrpc":"2.0","id":1,"method":"dataset.list","params":{"a":' + deep + "}}")
            answer = json.loads(await caller.socket.recv())
            assert answer["error"]["code"] in (-32700, -32600, -32003), answer
            assert "deep" in json.dumps(answer) or "depth" in json.dumps(answer), answer

    asyncio.run(asyncio.wait_for(attempt(), PATIENCE))


def test_quick_answers_come_in_the_order_of_requests_and_slow_ones_come(server):
    async def attempt():
        async with client(server) as caller:
            session = (await caller.call("session.open", dataset="box"))["session"]
            numbers, pictures = [], []
            for i in range(300):
                numbers.append(await caller.send("scene.patch", session=session, patch=iso(0.5 + i / 1000)))
                if i % 50 == 0:
                    pictures.append(await caller.send("picture.render", session=session, width=64, height=64))
            answers = [await caller.receive() for _ in numbers + pictures]
            quick = [answer for answer in answers if answer["id"] in numbers]
            assert [answer["id"] for answer in quick] == numbers
            assert {answer["id"] for answer in answers} == {*numbers, *pictures}
            revisions = [answer["result"]["revision"] for answer in quick]
            assert revisions == list(range(revisions[0], revisions[0] + 300))

    asyncio.run(asyncio.wait_for(attempt(), PATIENCE))


def test_only_so_many_sessions(tmp_path):
    box_dataset.write_box(tmp_path / "box.ciel", n=3)
    with Server(tmp_path) as running:
        limit = int(running.call("server.info")["limits"]["sessions"])

        async def attempt():
            async with client(running) as caller:
                names = [(await caller.call("session.open", dataset="box"))["session"] for _ in range(limit)]
                answer = await caller.answer(await caller.send("session.open", dataset="box"))
                assert answer["error"]["code"] == -32003
                await caller.call("session.close", session=names[0])
                await caller.call("session.open", dataset="box")

        asyncio.run(asyncio.wait_for(attempt(), PATIENCE))


def test_only_so_many_connections(tmp_path):
    """WebSockets stay open. A connection that waits for its next request is closed for a new one."""
    with Server(tmp_path) as running:
        limit = int(running.call("server.info")["limits"]["connections"])
        idle = socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE)
        idle.sendall(b"GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n")
        assert idle.recv(4096).startswith(b"HTTP/1.1 200")
        held = []
        for _ in range(limit):
            held.append(socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE))
            held[-1].sendall(UPGRADE)
            assert held[-1].recv(4096).startswith(b"HTTP/1.1 101")
        assert idle.recv(4096) == b"", "it made room"
        refused = running.get("/healthz")
        assert refused.status_code == 503 and refused.headers["Retry-After"] == "1"
        for one in held:
            one.close()
        until(lambda: running.get("/healthz").status_code == 200)


def handshake(server: Server, old: bytes, new: bytes) -> bytes:
    """First line of the answer to a handshake in which `old` is replaced by `new`."""
    with socket.create_connection(("127.0.0.1", server.port), timeout=PATIENCE) as opened:
        opened.sendall(UPGRADE.replace(old, new))
        return opened.recv(4096).split(b"\r\n")[0]


def test_the_subprotocol_may_stand_in_any_line(server):
    line = b"Sec-WebSocket-Protocol: ciel.v1\r\n"
    other = b"Sec-WebSocket-Protocol: other\r\n"
    assert b" 101 " in handshake(server, line, other + line)
    assert b" 101 " in handshake(server, line, line + other)
    assert b" 400 " in handshake(server, line, other + other)


def test_the_key_must_be_sixteen_bytes(server):
    key = b"AAAAAAAAAAAAAAAAAAAAAA=="
    for wrong in (b"", b"AAAA", b"AAAAAAAAAAAAAAAAAAAAAAAAAA==", b"????????????????????????"):
        assert b" 400 " in handshake(server, key, wrong), wrong


@pytest.mark.parametrize("code", [0, 999, 1004, 1005, 1006, 1015, 1016, 2999, 5000, 65535])
def test_close_codes_that_do_not_exist_have_no_echo(server, code):
    with socket.create_connection(("127.0.0.1", server.port), timeout=PATIENCE) as opened:
        opened.sendall(UPGRADE)
        head = b""
        while not head.endswith(b"\r\n\r\n"):
            head += opened.recv(1)
        opened.sendall(b"\x88\x82\0\0\0\0" + struct.pack(">H", code))
        try:
            answer = b"".join(iter(lambda: opened.recv(4096), b""))
        except ConnectionResetError:
            answer = b""
        assert answer in (b"", b"\x88\x02" + struct.pack(">H", 1002)), answer
