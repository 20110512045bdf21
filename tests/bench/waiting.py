#!/usr/bin/python3
"""Measures how long server.info waits behind streamed polygons: tests/bench/waiting.py CIEL DATASET.ciel ARRAY [MBIT_PER_SECOND]

The client reads from its socket at the given rate (10 Mbit/s) and opens a view of iso-surfaces as polygons. It calls server.info when
the first polygons have arrived, and again after each answer. Prints milliseconds: first, median and longest.
"""

import json
import os
import pathlib
import socket
import statistics
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/python")]
PIECE = 4096
ASKED = 10
VALUES = 24


class PacedClient:
    def __init__(self, port: int, upgrade: bytes, bytes_per_second: float):
        self.socket = socket.socket()
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 16384)
        self.socket.connect(("127.0.0.1", port))
        self.socket.sendall(upgrade)
        self.seconds_of_piece = PIECE / bytes_per_second
        self.due = time.perf_counter()
        self.taken = b""
        self.number = 0
        while b"\r\n\r\n" not in self.taken:
            self.take_piece()
        self.taken = self.taken.split(b"\r\n\r\n", 1)[1]

    def take_piece(self) -> None:
        wait = self.due - time.perf_counter()
        if wait > 0:
            time.sleep(wait)
        some = self.socket.recv(PIECE)
        assert some, "the server has closed"
        self.due = max(self.due, time.perf_counter() - 0.05) + self.seconds_of_piece * len(some) / PIECE
        self.taken += some

    def take(self, count: int) -> bytes:
        while len(self.taken) < count:
            self.take_piece()
        taken, self.taken = self.taken[:count], self.taken[count:]
        return taken

    def message(self) -> tuple[int, bytes]:
        opcode, length = self.take(2)
        if length > 125:
            length = int.from_bytes(self.take(2 if length == 126 else 8), "big")
        return opcode & 15, self.take(length)

    def send(self, method: str, **params) -> int:
        self.number += 1
        payload = json.dumps({"jsonrpc": "2.0", "id": self.number, "method": method, "params": params}).encode().ljust(126)
        self.socket.sendall(bytes([0x81, 0xFE]) + len(payload).to_bytes(2, "big") + b"\0\0\0\0" + payload)
        return self.number

    def answer(self, number: int) -> dict:
        while True:
            opcode, payload = self.message()
            if opcode == 1 and (answer := json.loads(payload)).get("id") == number:
                assert "result" in answer, answer
                return answer["result"]


def main() -> None:
    ciel, path, array = sys.argv[1:4]
    rate = float(sys.argv[4]) if len(sys.argv) > 4 else 10.0
    os.environ["CIEL_BINARY"] = ciel
    from serve_process import UPGRADE, Server

    with Server(path) as server:
        client = PacedClient(server.port, UPGRADE, rate * 125_000)
        name = pathlib.Path(path).stem
        session = client.answer(client.send("session.open", dataset=name))["session"]
        arrays = client.answer(client.send("dataset.describe", dataset=name))["arrays"]
        low, high = next(a["range"] for a in arrays if a["name"] == array)

        values = [low + (0.1 + 0.8 * i / VALUES) * (high - low) for i in range(VALUES)]
        layers = {"waiting": {"type": "iso", "array": array, "values": values, "color": {"array": array}}}
        client.answer(client.send("scene.patch", session=session, patch={"layers": layers}))
        client.answer(client.send("view.open", session=session, width=1280, height=720, stream="geometry"))
        while client.message()[0] != 2:
            pass
        waits = []
        for _ in range(ASKED):
            asked = time.perf_counter()
            client.answer(client.send("server.info"))
            waits.append(1000 * (time.perf_counter() - asked))
    print(f"server.info at {rate:g} Mbit/s: first {waits[0]:.0f} ms, median {statistics.median(waits):.0f} ms, longest {max(waits):.0f} ms")


main()
