"""The TLS proxy of deploy/proxy, started as in its container, in front of a server that reports the requests it receives."""

import contextlib
import http.client
import http.server
import json
import os
import pathlib
import re
import socket
import ssl
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
PROXY = ROOT / "deploy/proxy"


class Echo(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_GET(self):
        body = json.dumps({"path": self.path, "headers": dict(self.headers)}).encode()
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Proxy:
    """A running proxy. `folder` replaces the container's volumes and is kept."""

    def __init__(self, folder: pathlib.Path, name: str, upstream: int):
        for part in ("certificates", "run"):
            (folder / part).mkdir(exist_ok=True)
        self.port = free_port()
        environment = {
            **os.environ,
            "PATH": f"{os.environ['PATH']}:/usr/sbin",
            "CIEL_HOST_NAME": name,
            "CIEL_UPSTREAM": f"127.0.0.1:{upstream}",
            "CIEL_CERTIFICATES": str(folder / "certificates"),
            "CIEL_PROXY_RUN": str(folder / "run"),
            "CIEL_PROXY_TEMPLATE": str(PROXY / "nginx.conf"),
            "CIEL_PROXY_LISTEN": f"127.0.0.1:{self.port}",
        }
        # stdout must be a pipe, as in a container, because nginx opens /dev/stdout again.
        self.process = subprocess.Popen(
            [PROXY / "start"], env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.lines: list[str] = []
        self.reader = threading.Thread(target=lambda: self.lines.extend(self.process.stdout))
        self.reader.start()

    def get(self, path: str, **headers: str) -> tuple[http.client.HTTPMessage, bytes]:
        context = ssl.create_default_context()
        context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
        deadline = time.monotonic() + 30
        while True:
            connection = http.client.HTTPSConnection("127.0.0.1", self.port, context=context, timeout=30)
            try:
                with contextlib.closing(connection):
                    connection.request("GET", path, headers=headers)
                    response = connection.getresponse()
                    return response.headers, response.read()
            except ConnectionRefusedError:
                if self.process.poll() is not None or time.monotonic() > deadline:
                    raise AssertionError("the proxy did not start: " + "".join(self.lines)) from None
                time.sleep(0.05)

    def stop(self) -> str:
        self.process.terminate()
        self.process.wait(30)
        self.reader.join()
        self.process.stdout.close()
        return "".join(self.lines)


@contextlib.contextmanager
def running(folder: pathlib.Path, name: str, upstream: int):
    proxy = Proxy(folder, name, upstream)
    try:
        yield proxy
    finally:
        proxy.stop()


class TheProxy(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        upstream = self.enterContext(http.server.ThreadingHTTPServer(("127.0.0.1", 0), Echo))
        threading.Thread(target=upstream.serve_forever, daemon=True).start()
        self.addCleanup(upstream.shutdown)
        self.upstream = upstream.server_address[1]

    def hsts(self, name: str) -> str | None:
        with running(self.folder, name, self.upstream) as proxy:
            return proxy.get("/")[0]["Strict-Transport-Security"]

    def mount_certificate(self):
        folder = self.folder / "certificates"
        folder.mkdir(exist_ok=True)
        subprocess.run(
            ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-subj", "/CN=ciel.example.org",
             "-keyout", folder / "tls.key", "-out", folder / "tls.crt"], check=True, capture_output=True)

    def test_a_certificate_of_its_own_is_never_made_strict(self):
        self.assertIsNone(self.hsts("ciel.example.org"))
        self.assertIsNone(self.hsts("ciel.example.org"), "the volume has kept the certificate")

    def test_a_mounted_certificate_is_strict_for_names_of_one_owner(self):
        self.hsts("ciel.example.org")  # leaves its self-signed certificate, which the operator replaces
        self.mount_certificate()
        self.assertEqual(self.hsts("ciel.example.org"), "max-age=31536000")
        for name in ("localhost", "ciel.localhost", "192.0.2.7", "2001:db8::7", "[2001:db8::7]"):
            with self.subTest(name):
                self.assertIsNone(self.hsts(name))

    def test_the_access_log_holds_no_query(self):
        proxy = Proxy(self.folder, "localhost", self.upstream)
        seen = json.loads(proxy.get("/some/page?token=secret", Cookie="ciel=secret", Authorization="Bearer secret")[1])
        log = proxy.stop()
        self.assertEqual(seen["path"], "/some/page?token=secret")
        self.assertRegex(log, r"(?m)^\d{4}-\d\d-\d\dT\S+ 127\.0\.0\.1 GET /some/page 200 ")
        self.assertNotIn("secret", log)

    def test_no_error_is_logged_with_a_query(self):
        with socket.socket() as unused:
            unused.bind(("127.0.0.1", 0))  # nobody listens, so that each request fails
            proxy = Proxy(self.folder, "localhost", unused.getsockname()[1])
            proxy.get("/some/page?token=secret")
            log = proxy.stop()
        self.assertRegex(log, r"GET /some/page 502 ")
        self.assertNotIn("secret", log)

    def test_a_client_cannot_name_its_user(self):
        with running(self.folder, "localhost", self.upstream) as proxy:
            headers = json.loads(proxy.get("/", **{"X-Forwarded-User": "root"})[1])["headers"]
        self.assertNotIn("X-Forwarded-User", headers)

    def test_the_last_forwarded_address_is_the_peers(self):
        with running(self.folder, "localhost", self.upstream) as proxy:
            headers = json.loads(proxy.get("/", **{"X-Forwarded-For": "192.0.2.66"})[1])["headers"]
        self.assertEqual(headers["X-Forwarded-For"].split(", ")[-1], "127.0.0.1")

    def test_compose_trusts_the_network_of_its_own_proxy(self):
        compose = (ROOT / "deploy/compose.yaml").read_text(encoding="utf-8")
        trusted = re.search(r'"--trusted-proxy", "([^"]+)"', compose).group(1)
        self.assertEqual(trusted, re.search(r"subnet: ([\d./]+)", compose).group(1))

    def test_the_proxy_gives_up_idle_connections_before_the_server_does(self):
        """Otherwise a request could use a connection that the server is closing, and its user would get status 502."""
        limits = (ROOT / "server/limits/limits.hpp").read_text(encoding="utf-8")
        server = int(re.search(r"\bkeep_alive_seconds = (\d+)", limits).group(1))
        upstream = re.search(r"upstream ciel \{(.*?)\n    \}", (PROXY / "nginx.conf").read_text(encoding="utf-8"), re.S)
        proxy = int(re.search(r"keepalive_timeout (\d+)s;", upstream.group(1)).group(1))
        self.assertLess(proxy, server)


if __name__ == "__main__":
    unittest.main()
