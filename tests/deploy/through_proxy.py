"""The Python client through the TLS proxy: opens a session on the first dataset and waits for a lossless PNG."""

import asyncio
import os
import pathlib
import ssl
import sys
import tempfile
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "protocol/python"))
from ciel_client import Stream  # noqa: E402


async def main(url: str, token: str) -> None:
    async with Stream(url, token) as stream:
        datasets = await stream.call("dataset.list")
        session = (await stream.call("session.open", dataset=datasets[0]["name"]))["session"]
        await stream.call("view.open", session=session, width=640, height=480)
        async for frame in stream.frames():
            if frame.is_still:
                assert frame.payload[:8] == b"\x89PNG\r\n\x1a\n"
                print(f"a still PNG of {len(frame.payload)} bytes came through the proxy")
                return


if __name__ == "__main__":
    address = urllib.parse.urlsplit(sys.argv[1])
    with tempfile.NamedTemporaryFile("w", suffix=".crt") as certificate:  # trusts the proxy's self-signed certificate
        certificate.write(ssl.get_server_certificate((address.hostname, address.port)))
        certificate.flush()
        os.environ["SSL_CERT_FILE"] = certificate.name
        asyncio.run(asyncio.wait_for(main(*sys.argv[1:]), 120))
