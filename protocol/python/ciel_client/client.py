"""Clients for JSON-RPC 2.0 with a CIEL server: HTTP POST for scripts, a WebSocket for frames and notifications."""

from __future__ import annotations

import asyncio
import base64
import contextlib
import itertools
import json
import urllib.error
import urllib.parse
import urllib.request
import warnings
from collections.abc import AsyncIterator, Mapping
from typing import Any

from .append import check_sizes, message, pieces, pushed
from .async_calls import AsyncCalls
from .calls import Calls
from .frame_queue import FrameQueue
from .frames import Frame, Pieces, read_frame
from .types import PROTOCOL

CLOSED = "the server has closed the connection; open a new Stream"
MOST_NOTIFICATIONS = 1000


class RpcError(Exception):
    """Raised when a call fails. `code` is one of types.ERROR_CODES or of JSON-RPC 2.0.

    `path`: the refused member of the parameters; None if no member is to blame. `request`: the id of the call in the
    server's log.
    """

    def __init__(self, error: dict[str, Any]) -> None:
        data = error.get("data") or {}
        super().__init__(data.get("reason") or error["message"])
        self.code: int = error["code"]
        self.message: str = error["message"]
        self.path: str | None = data.get("path")
        self.request: str | None = data.get("request")


def _request(number: int, method: str, params: dict[str, Any]) -> dict[str, Any]:
    params = {name: value for name, value in params.items() if value is not None}
    return {"jsonrpc": "2.0", "protocol": PROTOCOL, "id": number, "method": method, "params": params}


def _result(answer: dict[str, Any]) -> Any:
    if "error" in answer:
        raise RpcError(answer["error"])
    if ignored := answer.get("ignored"):
        warnings.warn(f"the server is older than this client and ignored {', '.join(ignored)}", stacklevel=3)
    return answer["result"]


def _parted(url: str) -> tuple[bool, str, str | None]:
    """Splits the address of a server or WebSocket. Returns: whether it uses TLS, host and path, token or None."""
    parts = urllib.parse.urlsplit(url)
    if parts.scheme not in ("http", "https", "ws", "wss") or not parts.netloc:
        raise ValueError(f"{url!r} is not the address of a server; give an address such as http://127.0.0.1:8080")
    token = urllib.parse.parse_qs(parts.query).get("token", [None])[0]
    place = parts.netloc + parts.path.rstrip("/").removesuffix("/ws")
    return parts.scheme in ("https", "wss"), place, token


class Client(Calls):
    """Calls methods over HTTP POST: `Client("http://127.0.0.1:8080").dataset_list()`. Each method has a function.

    `url` may be the address that the server printed, with its token.
    """

    def __init__(self, url: str = "http://127.0.0.1:8080", token: str | None = None, timeout: float = 60) -> None:
        is_secure, place, offered = _parted(url)
        token = token or offered
        self._url = f"{'https' if is_secure else 'http'}://{place}/rpc"
        self._timeout = timeout
        self._headers = {"Content-Type": "application/json"}
        if token:
            self._headers["Authorization"] = f"Bearer {token}"
        self._ids = itertools.count(1)

    def call(self, method: str, **params: Any) -> Any:
        return _result(self._post(_request(next(self._ids), method, params)))

    def batch(self, calls: list[tuple[str, dict[str, Any]]]) -> list[Any]:
        """Sends calls in one request. Returns the results in order. The result of a failed call is an RpcError.

        Raises RpcError if the server refuses the whole batch.
        """
        requests = [_request(i, method, params) for i, (method, params) in enumerate(calls)]
        results: list[Any] = [None] * len(calls)
        answers = self._post(requests) if calls else []
        if isinstance(answers, dict):
            raise RpcError(answers["error"])
        for answer in answers:
            results[answer["id"]] = RpcError(answer["error"]) if "error" in answer else _result(answer)
        return results

    def append(self, dataset: str, time: float, arrays: Mapping[str, Any]) -> Any:
        """Appends a time step. `arrays`: the values of each array by the name of the array.

        Values are in the order of the imported file's points, or of its cells for an array 'cell:NAME'. The server
        must run with --allow-append, and the client must have the server's token. Returns append.commit's result.
        """
        step = [pushed(name, values) for name, values in arrays.items()]
        upload = self.call("append.begin", dataset=dataset, time=time, arrays=[one.wanted for one in step])
        try:
            check_sizes(step, upload)
            for number, offset, data in pieces(step, upload["piece_bytes"]):
                text = base64.b64encode(data).decode()
                self.call("append.piece", upload=upload["upload"], array=number, offset=offset, data=text)
            return self.call("append.commit", upload=upload["upload"])
        except BaseException:
            with contextlib.suppress(RpcError, OSError):
                self.call("append.cancel", upload=upload["upload"])
            raise

    def _post(self, body: Any) -> Any:
        request = urllib.request.Request(self._url, json.dumps(body).encode(), self._headers)
        try:
            with urllib.request.urlopen(request, timeout=self._timeout) as response:
                return json.load(response)
        except urllib.error.HTTPError as error:
            raise ConnectionError(f"{self._url}: {error.code} {error.reason}; check address and token") from None


class Stream(AsyncCalls):
    """Exchanges calls, notifications and whole frames over one WebSocket. Needs the package `websockets`.

    async with Stream("ws://127.0.0.1:8080/ws") as stream:
        session = await stream.session_open()
        await stream.view_open(session=session["session"], width=640, height=360)
        async for frame in stream.frames():  # a frame is acknowledged when the next one is requested
            ...

    Frames are acknowledged only after they are taken. If a script takes no frames, the server stops after a few frames
    of each view. `most_frame_bytes` limits the bytes of the frames that wait to be taken, for scripts with many views.
    Above the limit, the connection is closed, and next_frame() raises ConnectionError. `notifications` keeps the newest
    1,000 notifications.
    """

    def __init__(
        self, url: str = "ws://127.0.0.1:8080/ws", token: str | None = None, most_frame_bytes: int = 1 << 30
    ) -> None:
        is_secure, place, offered = _parted(url)
        token = token or offered
        self._url = f"{'wss' if is_secure else 'ws'}://{place}/ws"
        self._by_post = Client(url, token)
        self._headers = {"Authorization": f"Bearer {token}"} if token else {}
        self._ids = itertools.count(1)
        self._waiting: dict[int, asyncio.Future[Any]] = {}
        self._frames = FrameQueue(most_frame_bytes)
        self._pieces = Pieces()
        self._ended: str | None = None  # reason; None while the connection is open
        self.notifications: asyncio.Queue[dict[str, Any]] = asyncio.Queue(MOST_NOTIFICATIONS)

    async def __aenter__(self) -> Stream:
        import websockets

        has_new_names = int(websockets.__version__.split(".")[0]) >= 14
        headers = {"additional_headers" if has_new_names else "extra_headers": self._headers}
        self._socket = await websockets.connect(self._url, subprotocols=["ciel.v1"], max_size=None, **headers)
        self._reader = asyncio.create_task(self._read())
        return self

    async def __aexit__(self, *_: object) -> None:
        await self._socket.close()
        await self._reader

    async def call(self, method: str, **params: Any) -> Any:
        """Calls a method. Requests pictures and exports by POST, because a WebSocket message has at most 512 KiB."""
        if method in ("picture.render", "surface.export"):
            return await asyncio.to_thread(self._by_post.call, method, **params)
        number = next(self._ids)
        self._waiting[number] = asyncio.get_running_loop().create_future()
        await self._send(json.dumps(_request(number, method, params)))
        return await self._waiting[number]

    async def notify(self, method: str, **params: Any) -> None:
        await self._send(json.dumps({"jsonrpc": "2.0", "method": method, "params": params}))

    async def append(self, dataset: str, time: float, arrays: Mapping[str, Any]) -> Any:
        """Appends a step like Client.append(), but as binary messages, which are a quarter smaller than base64."""
        step = [pushed(name, values) for name, values in arrays.items()]
        upload = await self.call("append.begin", dataset=dataset, time=time, arrays=[one.wanted for one in step])
        try:
            check_sizes(step, upload)
            for number, offset, data in pieces(step, upload["piece_bytes"]):
                await self._send(message(upload["upload"], number, offset, data))
            return await self.call("append.commit", upload=upload["upload"])
        except Exception:
            with contextlib.suppress(Exception):
                await self.call("append.cancel", upload=upload["upload"])
            raise

    async def next_frame(self) -> Frame:
        """Returns the next frame, not yet acknowledged. Call acknowledge() after the frame has been presented."""
        return await self._frames.take()

    async def acknowledge(self, frame: Frame) -> None:
        if frame.is_last:
            await self.notify("view.ack", view=frame.view, frame=frame.frame)

    async def frames(self) -> AsyncIterator[Frame]:
        while True:
            frame = await self.next_frame()
            yield frame
            await self.acknowledge(frame)

    async def _send(self, data: str | bytes) -> None:
        if self._ended is not None:
            raise ConnectionError(self._ended)
        await self._socket.send(data)

    async def _read(self) -> None:
        reason = CLOSED
        try:
            async for message in self._socket:
                if isinstance(message, bytes):
                    whole = self._pieces.add(read_frame(message))
                    if whole is not None:
                        await self._frames.put(whole)
                else:
                    self._answer(json.loads(message))
        except BufferError as error:
            reason = str(error)
            await self._socket.close()
        finally:
            self._ended = reason
            await self._frames.end(reason)
            for waiting in self._waiting.values():
                if not waiting.done():
                    waiting.set_exception(ConnectionError(reason))

    def _answer(self, message: dict[str, Any]) -> None:
        if "method" in message:
            if self.notifications.full():
                self.notifications.get_nowait()
            self.notifications.put_nowait(message)
            return
        waiting = self._waiting.pop(message["id"], None) if message["id"] is not None else None
        if waiting is None or waiting.done():
            return
        try:
            waiting.set_result(_result(message))
        except RpcError as error:
            waiting.set_exception(error)
