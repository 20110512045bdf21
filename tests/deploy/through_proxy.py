"""A WebSocket client through the TLS proxy: opens a session on the first dataset and waits for a lossless PNG."""

import asyncio
import json
import ssl
import struct
import sys

import websockets


async def main(url: str, token: str) -> None:
    context = ssl.create_default_context()
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE  # the proxy made its own certificate
    headers = {"Authorization": f"Bearer {token}"}
    async with websockets.connect(url, ssl=context, subprotocols=["ciel.v1"], extra_headers=headers, max_size=None) as socket:
        assert socket.subprotocol == "ciel.v1"

        async def call(number: int, method: str, **params: object) -> dict:
            await socket.send(json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": params}))
            while True:
                message = await socket.recv()
                if isinstance(message, str) and json.loads(message).get("id") == number:
                    answer = json.loads(message)
                    assert "error" not in answer, answer
                    return answer["result"]

        datasets = await call(1, "dataset.list")
        session = (await call(2, "session.open", dataset=datasets[0]["name"]))["session"]
        view = (await call(3, "view.open", session=session, width=640, height=480))["view"]
        while True:
            message = await asyncio.wait_for(socket.recv(), 60)
            if isinstance(message, bytes):
                flags, frame = struct.unpack_from("<H", message, 6)[0], struct.unpack_from("<I", message, 12)[0]
                assert message[:4] == b"CIEL" and message[80:88] == b"\x89PNG\r\n\x1a\n"
                await socket.send(json.dumps({"jsonrpc": "2.0", "method": "view.ack", "params": {"view": view, "frame": frame}}))
                if flags & 1:
                    print(f"a still PNG of {len(message) - 80} bytes came through the proxy")
                    return


asyncio.run(main(sys.argv[1], sys.argv[2]))
