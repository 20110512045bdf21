"""Starts a real `ciel serve` on a free port, and clients for it."""

import contextlib
import itertools
import json
import os
import pathlib
import re
import resource
import signal
import struct
import subprocess
import time
from collections.abc import Callable

import requests
import websockets

from program import CIEL

PATIENCE = 60  # seconds after which an operation counts as hanging
UPGRADE = (b"GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
           b"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n"
           b"Sec-WebSocket-Protocol: ciel.v1\r\n\r\n")


def until(holds: Callable[[], bool]) -> None:
    """Polls `holds` until it is true. Fails after PATIENCE seconds."""
    deadline = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < deadline, "it does not come"


def iso(value: float) -> dict:
    """A patch with one iso-surface of the box dataset's `r`."""
    return {"layers": {"iso": {"type": "iso", "array": "r", "values": [value]}}}


class Server:
    def __init__(self, *arguments: str, environment: dict[str, str] | None = None, log: pathlib.Path | None = None,
                 user: int | None = None, limits: dict[int, int] | None = None, program: str = CIEL):
        self.log = open(log, "w+") if log else open(os.devnull, "w+")
        self.process = subprocess.Popen(
            [program, "serve", *([] if "--port" in arguments else ["--port", "0"]), *map(str, arguments)],
            stdout=subprocess.PIPE, stderr=self.log, text=True, env={**os.environ, **(environment or {})}, user=user,
            preexec_fn=limits and (lambda: [resource.setrlimit(of, (most, most)) for of, most in limits.items()]))
        self.line = self.process.stdout.readline().strip()
        match = re.search(r"http://([^/]+?:(\d+))(/[^?\s]*)", self.line)
        if not match:
            self.process.kill()
            raise AssertionError(f"the server did not start: {self.line!r}")
        self.port = int(match.group(2))
        self.base = f"http://127.0.0.1:{self.port}"
        self.path = match.group(3)
        token = re.search(r"\?token=(\S+)$", self.line)
        self.token = token.group(1) if token else (environment or {}).get("CIEL_TOKEN", "")

    def __enter__(self) -> "Server":
        return self

    def __exit__(self, *_) -> None:
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            try:
                self.process.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                self.process.kill()
                raise
        self.process.stdout.close()
        self.log.close()

    def stop(self) -> int:
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(PATIENCE)

    def get(self, path: str, **options) -> requests.Response:
        return requests.get(self.base + path, timeout=PATIENCE, allow_redirects=False, **options)

    def call(self, method: str, **params):
        """Calls one method over HTTP and returns its result."""
        answer = requests.post(self.base + "/rpc", timeout=PATIENCE,
                               json={"jsonrpc": "2.0", "id": 1, "method": method, "params": params}).json()
        assert "error" not in answer, answer
        return answer["result"]

    def socket(self, path: str = "/ws", headers: dict[str, str] | None = None, **options):
        is_new = int(websockets.__version__.split(".")[0]) >= 14
        name = "additional_headers" if is_new else "extra_headers"
        if is_new:
            options.pop("read_limit", None)  # exists only in the older versions' API
        options = {"subprotocols": ["ciel.v1"], "max_size": None, "open_timeout": PATIENCE, name: headers, **options}
        return websockets.connect(f"ws://127.0.0.1:{self.port}{path}", **options)

    def metrics(self) -> dict[str, float]:
        """Parses the metrics: a value for each name with labels."""
        samples = {}
        for line in self.get("/metrics").text.splitlines():
            if line and not line.startswith("#"):
                name, value = line.rsplit(" ", 1)
                samples[name] = float(value)
        return samples

    def open_files(self) -> int:
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def resident_kilobytes(self) -> int:
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"VmRSS:\s+(\d+)", status).group(1))

    def peak_kilobytes(self) -> int:
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"VmHWM:\s+(\d+)", status).group(1))

    def private_kilobytes(self) -> int:
        """Resident memory without the pages of mapped files."""
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"RssAnon:\s+(\d+)", status).group(1))

    def maps(self) -> str:
        """The mapped files, as the system lists them."""
        return pathlib.Path(f"/proc/{self.process.pid}/maps").read_text()


class Frame:
    """A frame: the header of protocol/frame.md and its payload, of one message or of all its pieces."""

    def __init__(self, message: bytes):
        assert len(message) <= 512 << 10
        fields = struct.unpack_from("<4sBBHIIQIIdffffIIII", message)
        (self.magic, self.version, self.kind, self.flags, self.view, self.number, self.revision, self.width, self.height,
         self.time, self.wait_ms, self.extract_ms, self.draw_ms, self.encode_ms, self.triangles, payload_bytes,
         self.whole_bytes, self.offset) = fields
        self.payload = message[80:]
        assert self.magic == b"CIEL" and self.version == 2 and len(self.payload) == payload_bytes

    @property
    def still(self) -> bool:
        return bool(self.flags & 1)


class Client:
    """JSON-RPC on a WebSocket. Keeps answers by id, and frames and notifications in order of arrival."""

    def __init__(self, socket):
        self.socket = socket
        self.ids = itertools.count(1)
        self.frames: list[Frame] = []
        self.begun: dict[int, Frame] = {}  # by view: frames with missing pieces
        self.looked_at = 0  # number of frames that next_frame has returned
        self.notifications: list[dict] = []

    async def send(self, method: str, **params) -> int:
        number = next(self.ids)
        await self.socket.send(json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": params}))
        return number

    async def receive(self) -> dict | Frame:
        message = await self.socket.recv()
        if isinstance(message, bytes):
            piece = Frame(message)
            frame = piece if piece.offset == 0 else self.begun[piece.view]
            if piece.offset > 0:
                assert (piece.number, piece.offset) == (frame.number, len(frame.payload))
                frame.payload += piece.payload
                frame.flags |= piece.flags
            self.begun[piece.view] = frame
            if len(frame.payload) < frame.whole_bytes:
                return await self.receive()
            self.frames.append(frame)
            return frame
        answer = json.loads(message)
        if "method" in answer:
            self.notifications.append(answer)
        return answer

    async def answer(self, number: int) -> dict:
        while True:
            message = await self.receive()
            if isinstance(message, dict) and message.get("id") == number:
                return message

    async def call(self, method: str, **params):
        answer = await self.answer(await self.send(method, **params))
        assert "error" not in answer, answer
        return answer["result"]

    async def acknowledge(self, frame: Frame) -> None:
        notification = {"jsonrpc": "2.0", "method": "view.ack", "params": {"view": frame.view, "frame": frame.number}}
        await self.socket.send(json.dumps(notification))

    async def next_frame(self) -> Frame:
        """Returns the oldest frame not returned yet. It may have arrived while an answer was awaited."""
        while self.looked_at == len(self.frames):
            await self.receive()
        self.looked_at += 1
        return self.frames[self.looked_at - 1]

    async def frame(self, revision: int = 0, still: bool = False) -> Frame:
        """Acknowledges frames until one shows at least this revision (and is a still if asked for). Returns that frame."""
        while True:
            frame = await self.next_frame()
            await self.acknowledge(frame)
            if frame.revision >= revision and (frame.still or not still):
                return frame


@contextlib.asynccontextmanager
async def client(server: Server, **options):
    async with server.socket(**options) as socket:
        yield Client(socket)
