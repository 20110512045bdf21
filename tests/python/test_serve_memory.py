"""A server with little memory refuses pictures with a message, keeps running, and draws later ones that fit."""

import pathlib
import re
import resource

import pytest
import requests

import box_dataset
from serve_process import PATIENCE, Server, until

SURFACE = {"layers": {"a": {"type": "surface", "color": {"array": "r"}}}}
GLASS = {"layers": {"a": {"type": "surface", "opacity": 0.5}, "b": {"type": "iso", "array": "r", "values": [0.4, 0.6], "opacity": 0.5}}}
CLOUD = {"layers": {"a": {"type": "volume", "array": "r"}}}


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return box_dataset.write_box(tmp_path_factory.mktemp("data") / "box.ciel", n=24)


def address_space(running: Server) -> int:
    status = pathlib.Path(f"/proc/{running.process.pid}/status").read_text()
    return int(re.search(r"VmSize:\s+(\d+)", status).group(1)) * 1024


def limit(running: Server, megabytes: int | None) -> None:
    """Limits the address space to this many megabytes above the current size; None removes the limit."""
    soft = resource.RLIM_INFINITY if megabytes is None else address_space(running) + (megabytes << 20)
    resource.prlimit(running.process.pid, resource.RLIMIT_AS, (soft, resource.RLIM_INFINITY))


def picture(running: Server, scene: dict, width: int, height: int) -> str:
    """Draws a picture. Returns the reason of a refusal, or an empty string."""
    answer = requests.post(running.base + "/rpc", timeout=4 * PATIENCE, json={
        "jsonrpc": "2.0", "id": 1, "method": "picture.render",
        "params": {"scene": {"dataset": "box", **scene}, "width": width, "height": height}}).json()
    return "" if "result" in answer else answer["error"]["data"]["reason"]


@pytest.mark.parametrize("megabytes", [100, 200, 300, 450, 600, 800])
@pytest.mark.parametrize("scene", [SURFACE, GLASS, CLOUD], ids=["surface", "glass", "cloud"])
def test_a_picture_that_does_not_fit_is_refused_in_words(box, scene, megabytes):
    with Server(box) as running:
        assert running.get("/readyz").status_code == 200
        limit(running, megabytes)
        for width, height in ((640, 360), (1920, 1080), (3840, 2160), (7680, 4320), (640, 360)):
            refused = picture(running, scene, width, height)
            assert running.process.poll() is None
            assert refused == "" or "memory" in refused or "address space" in refused, refused
            assert "bad_alloc" not in refused and "font" not in refused, refused
        limit(running, None)
        assert picture(running, scene, 640, 360) == ""
        assert running.get("/readyz").status_code == 200
        assert running.stop() == 0


def test_what_was_drawn_before_a_refusal_is_drawn_after_it(box):
    with Server(box) as running:
        assert picture(running, SURFACE, 640, 360) == ""
        limit(running, 300)
        assert picture(running, SURFACE, 640, 360) == ""
        assert "memory" in picture(running, SURFACE, 7680, 4320)
        for _ in range(3):
            assert picture(running, SURFACE, 640, 360) == ""
        until(lambda: running.get("/readyz").status_code == 200)  # a first test picture may take more than a second


def test_a_server_without_room_for_a_picture_is_not_ready(box):
    with Server(box) as running:
        assert running.get("/readyz").status_code == 200
        limit(running, 20)
        until(lambda: running.get("/readyz").status_code == 503)  # a result stays valid for one second
        answer = running.get("/readyz")
        assert "memory" in answer.json()["problem"], answer.text
        limit(running, None)


@pytest.mark.parametrize("megabytes", [1200, 1300, 1400, 1500, 1700, 1900, 2100, 2400])
def test_a_server_that_starts_with_little_tells_the_truth(box, megabytes):
    """Frames and pictures are drawn by different threads, each with its own OpenGL context. Both need room."""
    with Server(box, limits={resource.RLIMIT_AS: megabytes << 20}) as running:
        refused = [picture(running, SURFACE, 640, 360) for _ in range(3)]
        if refused[-1]:
            until(lambda: running.get("/readyz").status_code == 503)  # a result stays valid for one second
        refused.append(picture(running, SURFACE, 7680, 4320))  # once ended the server inside Mesa
        refused.append(picture(running, SURFACE, 640, 360))
        for why in filter(None, refused):
            assert "memory" in why or "address space" in why, why
        assert running.process.poll() is None


def test_a_large_picture_leaves_little_behind(box):
    """The server returns unused drawing memory to the system; it checks every ten seconds."""
    with Server(box) as running:
        assert picture(running, SURFACE, 640, 360) == ""
        before = running.resident_kilobytes()
        assert picture(running, SURFACE, 7680, 4320) == ""
        assert running.peak_kilobytes() > before + 500_000
        until(lambda: running.resident_kilobytes() < before + 100_000)
