"""Access control: the server's own user on loopback, and everyone with the token. Needs root to run clients as other users."""

import os
import pathlib
import re
import resource
import select
import shutil
import socket
import subprocess
import sys
import tempfile
import threading

import pytest
import requests

import box_dataset
from program import CIEL, ciel
from serve_process import PATIENCE, UPGRADE, Server, until

OTHER, ANOTHER = 23456, 23457  # user ids without a name
TOKEN = "0123456789abcdef0123"
needs_users = pytest.mark.skipif(os.geteuid() != 0, reason="only root can be other users")

CALL = b'{"jsonrpc":"2.0","id":1,"method":"dataset.list"}'
REQUEST = (b"POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: "
           + str(len(CALL)).encode() + b"\r\n%s\r\n" + CALL)

# Program of the other user: connects from the given port (0: any), sends stdin, and prints the status of the answer.
CLIENT = """
import socket, struct, sys
host, port, own_port, times = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
request = sys.stdin.buffer.read()
for _ in range(times):
    with socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET) as client:
        client.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        if own_port:
            client.bind(("127.0.0.1", own_port))
            client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        client.connect((host, port))
        client.sendall(request)
        if times == 1:
            print(client.recv(64).split()[1].decode())
"""


@pytest.fixture(scope="module")
def box():
    """A dataset that other users can read; they have no access to pytest's folders."""
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        yield box_dataset.write_box(pathlib.Path(folder) / "box.ciel", n=3)


@pytest.fixture(scope="module")
def server(box):
    with Server(box) as running:
        yield running


def status(server: Server, headers: bytes = b"", host: str = "127.0.0.1", user: int | None = None, port: int = 0,
           times: int = 1) -> int:
    """HTTP status of a method call by a process of `user`, or of our own user."""
    result = subprocess.run([sys.executable, "-c", CLIENT, host, str(server.port), str(port), str(times)],
                            input=REQUEST % headers, capture_output=True, user=user, timeout=PATIENCE, cwd="/")
    assert result.returncode == 0, result.stderr
    return int(result.stdout or 0)


def bearer(server: Server) -> bytes:
    return b"Authorization: Bearer " + server.token.encode() + b"\r\n"


def test_a_token_is_made_at_each_start_and_printed_in_the_address(box, server):
    assert re.fullmatch(r"[0-9a-f]{32}", server.token)
    assert server.line == f"CIEL listening on http://127.0.0.1:{server.port}/?token={server.token}"
    with Server(box) as second:
        assert second.token != server.token


def test_the_own_user_needs_no_token(server):
    for host in ("127.0.0.1", "::ffff:127.0.0.1"):
        assert status(server, host=host) == 200, host
    assert status(server, b"Authorization: Bearer of-a-server-before\r\n") == 200


@needs_users
@pytest.mark.parametrize("host", ["127.0.0.1", "::ffff:127.0.0.1"])
def test_another_user_needs_it(server, host):
    assert status(server, host=host, user=OTHER) == 401
    assert status(server, b"Authorization: Bearer " + b"x" * 32 + b"\r\n", host=host, user=OTHER) == 401
    assert status(server, bearer(server), host=host, user=OTHER) == 200


@needs_users
def test_a_client_that_closes_at_once_is_nobody(server):
    """Linux lists a closed socket with user 0, who runs this server. The server must not take it for its own user's."""
    before = server.metrics().get('ciel_rpc_requests_total{method="dataset.list"}', 0)
    accepted = server.metrics()["ciel_gateway_connections_total"]
    status(server, user=OTHER, times=100)
    until(lambda: server.metrics()["ciel_gateway_connections_total"] > accepted + 100)
    refused = server.metrics()
    assert refused.get('ciel_rpc_requests_total{method="dataset.list"}', 0) == before


@needs_users
def test_a_port_that_was_another_users_is_looked_up_again(server):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    for user, expected in ((None, 200), (OTHER, 401), (None, 200), (ANOTHER, 401)):
        assert status(server, user=user, port=port) == expected, user


@needs_users
def test_a_server_of_another_user_does_not_let_root_in(box):
    program = shutil.copy(CIEL, box.parent / "ciel")
    with Server(box, user=OTHER, program=program, environment={"HOME": "/nonexistent"}) as running:
        assert status(running) == 401
        assert status(running, user=ANOTHER) == 401
        assert status(running, user=OTHER) == 200
        assert status(running, bearer(running)) == 200


@pytest.mark.parametrize("header", [b"Forwarded: for=192.0.2.1", b"X-Forwarded-For: 127.0.0.1", b"x-forwarded-proto: https",
                                    b"X-Forwarded-Anything: x", b"Via: 1.1 proxy"])
def test_what_a_proxy_of_the_own_user_passes_on_needs_the_token(server, header):
    assert status(server, header + b"\r\n") == 401
    assert status(server, header + b"\r\n" + bearer(server)) == 200


def test_a_name_that_is_not_local_needs_the_token(box):
    with Server(box, "--allowed-host", "viewer.example.org") as running:
        for host, expected in (("localhost", 200), ("127.0.0.1:9", 200), ("[::1]", 200), ("viewer.example.org", 401)):
            assert running.get("/metrics", headers={"Host": host}).status_code == expected, host
        with_token = {"Host": "viewer.example.org", "Authorization": "Bearer " + running.token}
        assert running.get("/metrics", headers=with_token).status_code == 200


def test_a_given_token_is_needed_by_everybody(box, tmp_path):
    file = tmp_path / "token"
    file.write_text(TOKEN + "\n")
    file.chmod(0o600)
    for arguments, environment in ((["--token", TOKEN], {}), ([], {"CIEL_TOKEN": TOKEN}), (["--token-file", file], {})):
        with Server(box, *arguments, environment=environment) as running:
            assert status(running) == 401, arguments
            assert status(running, b"Authorization: Bearer " + TOKEN.encode() + b"\r\n") == 200, arguments


def test_a_token_file_that_others_can_read_is_told(box, tmp_path):
    file = tmp_path / "token"
    file.write_text(TOKEN)
    file.chmod(0o644)
    with Server(box, "--token-file", file, log=tmp_path / "log"):
        assert "chmod 600" in (tmp_path / "log").read_text()


def test_token_files_that_cannot_be(tmp_path):
    (tmp_path / "empty").write_text("")
    (tmp_path / "short").write_text("short\n")
    (tmp_path / "blank").write_text("\n" + TOKEN + "\n")
    (tmp_path / "spaces").write_text(" \t\n")
    for file, words in ((tmp_path / "absent", "cannot be read"), (tmp_path / "empty", "empty"), (tmp_path / "blank", "empty"),
                        (tmp_path / "spaces", "empty"), (tmp_path / "short", "8 characters")):
        result = ciel("serve", "--port", "0", "--token-file", file, "--log-level", "off", timeout=PATIENCE)
        assert result.returncode == 1 and words in result.stderr, result.stderr
    result = ciel("serve", "--token", TOKEN, "--token-file", tmp_path / "short", timeout=PATIENCE)
    assert result.returncode == 2 and "--token" in result.stderr


def test_only_the_answers_to_wrong_tokens_wait_and_few_of_them(box):
    """Only answers to wrong tokens are delayed, at most two at once. Any other delayed answer would make this test hang."""
    limits = ["--limit-wrong-token-seconds", "3600", "--limit-wrong-tokens-waiting", "2"]
    with Server(box, "--token", TOKEN, *limits) as running:
        wrong = REQUEST % b"Authorization: Bearer wrong-one\r\n"
        guesses = [socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE) for _ in range(5)]
        for one in guesses:
            one.sendall(wrong)
        until(lambda: len(select.select(guesses, [], [], 0)[0]) == 3)
        answered = select.select(guesses, [], [], 0)[0]
        assert all(one.recv(4096).startswith(b"HTTP/1.1 429") for one in answered)
        waiting = [one for one in guesses if one not in answered]
        refused = running.get("/metrics?token=wrong")
        assert refused.status_code == 429 and refused.headers["Retry-After"] == "3600"
        assert running.get("/metrics").status_code == 401, "without any token"
        assert running.get("/metrics?token=" + TOKEN).status_code == 200
        for one in waiting:
            one.setblocking(False)
            with pytest.raises(BlockingIOError):
                one.recv(1)
        assert running.stop() == 0
        for one in guesses:
            one.close()


def test_no_log_line_holds_a_query_a_cookie_or_a_token_and_guesses_are_told_once(box, tmp_path):
    secrets = ["guessed-token", "cookie-value", "session-of-somebody-else", "in-the-query"]
    with Server(box, "--token", TOKEN, "--log-level", "debug", "--limit-wrong-tokens-waiting", "1",
                log=tmp_path / "log") as running:
        for _ in range(2):
            running.get("/metrics?token=guessed-token&x=in-the-query")
            running.get("/?token=guessed-token")
            running.get("/metrics?in-the-query=1", cookies={f"ciel_token_{running.port}": "cookie-value"})
            running.get("/nothing?in-the-query", headers={"Authorization": "Bearer guessed-token"})
        authorized = {"Authorization": "Bearer " + TOKEN}
        document = {"jsonrpc": "2.0", "id": 1, "method": "session.open",
                    "params": {"session": "session-of-somebody-else", "dataset": "box"}}
        answer = requests.post(running.base + "/rpc?x=in-the-query", json=document, headers=authorized, timeout=PATIENCE)
        assert "result" in answer.json(), answer.text
        metrics = running.get("/metrics", headers=authorized).text
        running.get("/metrics?token=" + TOKEN)
        with socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE) as viewer:
            viewer.sendall(UPGRADE.replace(b"/ws", b"/ws?token=" + TOKEN.encode()))
            assert b" 101 " in viewer.recv(4096)
        assert running.stop() == 0
        log = (tmp_path / "log").read_text()
    for secret in [TOKEN, *secrets]:
        assert secret not in log, secret
        assert secret not in metrics, secret
    assert log.count("a wrong token was refused") == 1, log


def test_session_ids_that_can_be_guessed_are_refused(server):
    def opened(session: str) -> dict:
        document = {"jsonrpc": "2.0", "id": 1, "method": "session.open", "params": {"session": session, "dataset": "box"}}
        return requests.post(server.base + "/rpc", json=document, timeout=PATIENCE).json()

    assert opened("a" * 21)["error"]["code"] == -32602
    assert opened("a" * 22)["result"]["session"] == "a" * 22
    made = {server.call("session.open", dataset="box")["session"] for _ in range(5)}
    assert len(made) == 5 and all(re.fullmatch(r"[0-9a-f]{32}", each) for each in made)


def test_the_limit_of_one_address_counts_what_a_trusted_proxy_says(box):
    """Connections from loopback itself are not limited."""
    arguments = ["--trusted-proxy", "127.0.0.1", "--limit-connections-of-address", "2"]
    with Server(box, *arguments) as running:
        def begin(client: str) -> socket.socket:
            """Starts a call without sending its body, so the connection stays busy."""
            one = socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE)
            head = REQUEST % (f"X-Forwarded-For: 203.0.113.9, {client}\r\nExpect: 100-continue\r\n".encode() + bearer(running))
            one.sendall(head[:-len(CALL)])
            return one

        held = [begin(client) for client in ("192.0.2.1", "192.0.2.1", "2001:db8::1", "2001:db8::2")]
        for one in held:
            assert one.recv(4096).startswith(b"HTTP/1.1 100")
        for client, answer in (("192.0.2.1", b"HTTP/1.1 429"), ("2001:db8::3", b"HTTP/1.1 429"),
                               ("192.0.2.2", b"HTTP/1.1 100"), ("2001:db8:0:1::1", b"HTTP/1.1 100"),
                               ("unknown", b"HTTP/1.1 100"), ("127.0.0.1", b"HTTP/1.1 100")):
            held.append(begin(client))
            assert held[-1].recv(4096).startswith(answer), client
        held[0].sendall(CALL)
        assert b"result" in held[0].recv(4096)

        def has_room() -> bool:  # true once the server has noticed the end of the request
            held.append(begin("192.0.2.1"))
            return held[-1].recv(4096).startswith(b"HTTP/1.1 100")

        until(has_room)
        for one in held:
            one.close()


def test_what_is_no_proxy_is_not_believed(box):
    with Server(box, "--limit-connections-of-address", "1") as running:
        held = []
        for _ in range(3):
            one = socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE)
            one.sendall((REQUEST % (b"X-Forwarded-For: 192.0.2.1\r\nExpect: 100-continue\r\n" + bearer(running)))[:-len(CALL)])
            assert one.recv(4096).startswith(b"HTTP/1.1 100")
            held.append(one)
        for one in held:
            one.close()


def test_dripping_connections_keep_nobody_out(box):
    """More connections than the limit, each with a header that never ends."""
    with Server(box) as running:
        most = int(running.call("server.info")["limits"]["connections"])
        dripping = []
        for _ in range(most + 20):
            one = socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE)
            one.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\nX: ")
            dripping.append(one)
        stop = threading.Event()

        def drip() -> None:
            while not stop.wait(0.05):
                for one in dripping:
                    try:
                        one.send(b"x")
                    except OSError:
                        pass

        thread = threading.Thread(target=drip)
        thread.start()
        try:
            for _ in range(20):
                assert running.get("/healthz").status_code == 200
            assert running.metrics()["ciel_gateway_connections_refused_total"] == 0
        finally:
            stop.set()
            thread.join()
            for one in dripping:
                one.close()


def test_with_few_descriptors_sessions_still_open_and_it_is_said_once(box, tmp_path):
    with Server(box, log=tmp_path / "log", limits={resource.RLIMIT_NOFILE: 64}) as running:
        idle = [socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE) for _ in range(100)]
        for _ in range(5):
            state = running.call("session.open", dataset="box")
            running.call("picture.render", session=state["session"], width=64, height=64)
        for one in idle:
            one.close()
        assert running.stop() == 0
        log = (tmp_path / "log").read_text()
    assert log.count("file descriptors are in use") == 1, log
    assert "was not accepted" not in log


def test_without_a_descriptor_a_client_waits_until_there_is_one(box, tmp_path):
    with Server(box, log=tmp_path / "log") as running:
        before = resource.prlimit(running.process.pid, resource.RLIMIT_NOFILE)
        resource.prlimit(running.process.pid, resource.RLIMIT_NOFILE, (3, before[1]))
        with socket.create_connection(("127.0.0.1", running.port), timeout=PATIENCE) as client:
            client.sendall(b"GET /healthz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
            until(lambda: "a connection was not accepted" in (tmp_path / "log").read_text())
            resource.prlimit(running.process.pid, resource.RLIMIT_NOFILE, before)
            assert client.recv(4096).startswith(b"HTTP/1.1 200")
        assert running.stop() == 0
        log = (tmp_path / "log").read_text()
    assert log.count("was not accepted") == 1, log  # tried again every tenth of a second, said once
