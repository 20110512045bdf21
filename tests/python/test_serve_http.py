"""`ciel serve` over HTTP, for browsers, scripts, proxies and health checks."""

import asyncio
import re

import pytest
import requests

import box_dataset
from serve_process import PATIENCE, Server

TOKEN = "0123456789abcdef"


@pytest.fixture(scope="module")
def webclient(tmp_path_factory):
    folder = tmp_path_factory.mktemp("dist")
    (folder / "assets").mkdir()
    (folder / "index.html").write_text("<!doctype html><title>the client</title>")
    (folder / "assets" / "index-1a2b3c4d.js").write_text("export {};\n" * 1000)
    (folder.parent / "secret.txt").write_text("secret")
    (folder / "out.txt").symlink_to(folder.parent / "secret.txt")
    return folder


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return box_dataset.write_box(tmp_path_factory.mktemp("data") / "box.ciel")


@pytest.fixture(scope="module")
def server(box, webclient):
    with Server(box, "--webclient", webclient, "--prefix", "/ciel", "--origin", "https://lab.example.org") as running:
        yield running


@pytest.fixture(scope="module")
def guarded(box, webclient):
    with Server(box, "--webclient", webclient, environment={"CIEL_TOKEN": TOKEN}) as running:
        yield running


@pytest.mark.parametrize("prefix", ["", "/ciel"])
def test_everything_is_below_the_prefix_and_without_it(server, prefix):
    assert "the client" in server.get(prefix + "/").text
    assert server.get(prefix + "/assets/index-1a2b3c4d.js").headers["Content-Type"].startswith("text/javascript")
    assert server.get(prefix + "/healthz").text == "ok\n"
    document = {"jsonrpc": "2.0", "id": 7, "method": "dataset.list"}
    answer = requests.post(server.base + prefix + "/rpc", json=document, timeout=PATIENCE).json()
    assert answer == {"jsonrpc": "2.0", "id": 7, "result": [{"name": "box", "problem": ""}]}


def test_the_prefix_itself_leads_to_the_client(server):
    answer = server.get("/ciel?token=x#fragment")
    assert answer.status_code == 308 and answer.headers["Location"] == "/ciel/?token=x"
    assert server.path == "/ciel/"


def test_browsers_keep_hashed_files_and_ask_again_for_the_page(server):
    page, script = server.get("/"), server.get("/assets/index-1a2b3c4d.js")
    assert page.headers["Cache-Control"] == "no-cache"
    assert "immutable" in script.headers["Cache-Control"]
    again = server.get("/", headers={"If-None-Match": page.headers["ETag"]})
    assert again.status_code == 304 and again.content == b"" and again.headers["ETag"] == page.headers["ETag"]


def test_files_are_compressed_for_who_takes_it(server):
    path = "/assets/index-1a2b3c4d.js"
    packed = server.get(path, headers={"Accept-Encoding": "gzip"})
    plain = server.get(path, headers={"Accept-Encoding": "identity"})
    assert packed.headers["Content-Encoding"] == "gzip" and "Content-Encoding" not in plain.headers
    assert int(packed.headers["Content-Length"]) < int(plain.headers["Content-Length"]) / 10
    assert packed.text == plain.text == "export {};\n" * 1000
    assert packed.headers["ETag"] != plain.headers["ETag"]
    for answer in (packed, plain):
        assert "Accept-Encoding" in answer.headers["Vary"]
    again = server.get(path, headers={"Accept-Encoding": "gzip", "If-None-Match": packed.headers["ETag"]})
    assert again.status_code == 304


def test_links_do_not_lead_out_of_the_client(server):
    for path in ("/out.txt", "/../secret.txt", "/%2e%2e/secret.txt", "/assets/..%2f..%2fsecret.txt"):
        session = requests.Session()
        request = requests.Request("GET", server.base + path).prepare()
        request.url = server.base + path  # restores the path, because requests resolves its dots
        answer = session.send(request, timeout=PATIENCE)
        assert answer.status_code == 404 and "secret" not in answer.text.replace("secret.txt", ""), path


def test_dataset_names_are_never_paths(server, box):
    for name in (str(box), "../box", "./box", "box.ciel", "box/../box", "/etc/passwd", "..", "box\0", "box/"):
        document = {"jsonrpc": "2.0", "id": 1, "method": "dataset.describe", "params": {"dataset": name}}
        answer = requests.post(server.base + "/rpc", json=document, timeout=PATIENCE).json()
        assert answer["error"]["code"] == -32001, (name, answer)


def test_names_of_other_sites_are_refused(server):
    for host, status in [("localhost", 200), ("127.0.0.1:9", 200), ("[::1]:9", 200), ("evil.example", 403),
                         ("localhost.evil.example", 403)]:
        assert server.get("/healthz", headers={"Host": host}).status_code == status, host


def test_other_sites_pages_may_not_post(server):
    document = {"jsonrpc": "2.0", "id": 1, "method": "dataset.list"}
    for origin, status in [(server.base, 200), ("https://lab.example.org", 200), ("http://evil.example", 403),
                           ("null", 403)]:
        answer = requests.post(server.base + "/rpc", json=document, headers={"Origin": origin}, timeout=PATIENCE)
        assert answer.status_code == status, origin


def test_data_needs_the_token(guarded):
    document = {"jsonrpc": "2.0", "id": 1, "method": "dataset.list"}

    def post(query="", **headers):
        return requests.post(guarded.base + "/rpc" + query, json=document, headers=headers, timeout=PATIENCE).status_code

    assert post() == 401
    assert post("?token=wrong") == 401
    assert post("?token=" + TOKEN) == 200
    assert post(Authorization="Bearer " + TOKEN) == 200
    assert post(Authorization="Bearer " + TOKEN[:-1]) == 401
    assert post(Authorization="Basic " + TOKEN) == 401
    assert guarded.get("/metrics").status_code == 401
    assert guarded.get("/metrics", headers={"Authorization": "Bearer " + TOKEN}).status_code == 200
    refusal = guarded.get("/metrics")
    assert refusal.headers["WWW-Authenticate"] == "Bearer" and "token" in refusal.text


def test_probes_and_the_page_need_no_token(guarded):
    for path in ("/healthz", "/readyz", "/", "/assets/index-1a2b3c4d.js"):
        assert guarded.get(path).status_code == 200, path
    assert guarded.get("/?token=wrong").status_code == 401


def test_a_browser_gets_a_cookie_for_its_token(guarded):
    assert guarded.line == f"CIEL listening on {guarded.base}/", "a given token is not printed"
    browser = requests.Session()
    page = browser.get(guarded.base + "/?token=" + TOKEN, timeout=PATIENCE)
    cookie = page.headers["Set-Cookie"]
    assert "HttpOnly" in cookie and "SameSite=Strict" in cookie and "Path=/" in cookie and "Secure" not in cookie
    document = {"jsonrpc": "2.0", "id": 1, "method": "dataset.list"}
    assert browser.post(guarded.base + "/rpc", json=document, timeout=PATIENCE).status_code == 200
    assert "Set-Cookie" not in guarded.get("/").headers
    behind_tls = guarded.get("/?token=" + TOKEN, headers={"X-Forwarded-Proto": "https"})
    assert "Secure" in behind_tls.headers["Set-Cookie"]


def test_beyond_loopback_a_token_is_made():
    with Server("--host", "0.0.0.0") as running:
        token = re.search(r"\?token=([0-9a-f]{32})$", running.line).group(1)
        assert running.get("/metrics").status_code == 401
        assert running.get("/metrics?token=" + token).status_code == 200


@pytest.mark.parametrize("backend", ["auto", "egl-device", "egl-surfaceless", "osmesa"])
def test_readiness_draws_with_the_backend_asked_for(backend):
    with Server("--gl", backend) as running:
        answer = running.get("/readyz")
        state = answer.json()
        if answer.status_code != 200 and backend != "auto":
            assert state["problem"] and not state["ready"]
            pytest.skip(f"{backend} is not on this machine: {state['problem']}")
        assert answer.status_code == 200 and state["ready"] and state["problem"] == ""
        assert state["gl_renderer"] and state["gl_version"]
        assert backend in ("auto", state["backend"])
        assert running.call("server.info")["gl_renderer"] == state["gl_renderer"]


SAMPLE = re.compile(r'^([a-zA-Z_:][a-zA-Z0-9_:]*)(\{(?:[a-zA-Z_][a-zA-Z0-9_]*="(?:[^"\\\n]|\\["\\n])*",?)*\})? (\S+)$')


def test_metrics_are_prometheus_text(server):
    server.get("/nothing")

    async def connect():
        async with server.socket():
            pass

    asyncio.run(connect())
    answer = server.get("/metrics")
    assert answer.headers["Content-Type"].startswith("text/plain; version=0.0.4")
    assert answer.text.endswith("\n")
    types, seen, helped = {}, set(), set()
    for line in answer.text.splitlines():
        if line.startswith("# TYPE "):
            _, _, name, kind = line.split(" ")
            assert name not in types and kind in ("counter", "gauge", "histogram", "summary", "untyped"), line
            types[name] = kind
        elif line.startswith("# HELP "):
            name = line.split(" ", 3)[2]
            assert name not in helped, line
            helped.add(name)
        elif line:
            match = SAMPLE.match(line)
            assert match, line
            name, labels, value = match.groups()
            float(value)
            family = name if name in types else re.sub(r"_(bucket|sum|count)$", "", name)
            assert family in types, f"{line}: no TYPE before it"
            assert types[family] != "counter" or name.endswith("_total"), line
            assert (name, labels) not in seen, line
            seen.add((name, labels))
    metrics = server.metrics()
    assert metrics['ciel_gateway_responses_total{status="4xx"}'] >= 1
    assert metrics['ciel_gateway_responses_total{status="1xx"}'] >= 1
    assert types["ciel_gateway_websockets_open"] == "gauge"
