"""Frames: only the newest is sent. Slow, dead or misbehaving clients do not delay others."""

import asyncio
import base64
import contextlib
import io
import json
import socket

import numpy
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader

import box_dataset
from program import ciel
from serve_process import PATIENCE, UPGRADE, Frame, Server, client, iso, until


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    box = box_dataset.write_box(tmp_path_factory.mktemp("data") / "box.ciel", n=24)
    with Server(box) as running:
        yield running


async def open_view(caller, stream="image", width=320, height=240) -> tuple[str, int]:
    session = (await caller.call("session.open", dataset="box"))["session"]
    view = (await caller.call("view.open", session=session, width=width, height=height, stream=stream))["view"]
    return session, view


def run(task):
    asyncio.run(asyncio.wait_for(task(), PATIENCE))


def test_frames_follow_the_scene(server):
    async def attempt():
        async with client(server) as caller:
            session, view = await open_view(caller)
            pictures = []
            for value in (0.5, 0.8):
                revision = (await caller.call("scene.patch", session=session, patch=iso(value)))["revision"]
                frame = await caller.frame(revision, still=True)
                assert (frame.view, frame.kind, frame.revision) == (view, 1, revision)
                assert (frame.width, frame.height) == (320, 240)
                assert frame.payload.startswith(b"\x89PNG\r\n\x1a\n") and frame.triangles > 0
                pictures.append(frame.payload)
            assert pictures[0] != pictures[1]
            numbers = [frame.number for frame in caller.frames]
            assert numbers == sorted(set(numbers))

    run(attempt)


def pixels(reader, payload: bytes) -> numpy.ndarray:
    reader.SetMemoryBuffer(payload)
    reader.SetMemoryBufferLength(len(payload))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3).astype(int)


def test_moving_pictures_are_jpeg_where_the_view_asks_for_it_and_stills_never(server):
    async def attempt():
        async with client(server) as caller:
            session = (await caller.call("session.open", dataset="box"))["session"]
            view = (await caller.call("view.open", session=session, width=333, height=240, moving="jpeg"))["view"]
            for value in (0.5, 0.8, 0.6):
                revision = (await caller.call("scene.patch", session=session, patch=iso(value)))["revision"]
                still = await caller.frame(revision, still=True)
                moving = [frame for frame in caller.frames if frame.revision == revision and not frame.still]
                assert still.payload.startswith(b"\x89PNG\r\n\x1a\n") and len(moving) == 1
                assert moving[0].payload.startswith(b"\xff\xd8\xff") and moving[0].payload.endswith(b"\xff\xd9")
                exact, near = pixels(vtkPNGReader(), still.payload), pixels(vtkJPEGReader(), moving[0].payload)
                assert exact.shape == near.shape == (240, 333, 3)
                assert numpy.abs(exact - near).mean() < 3 and (exact != near).any()
            asked = ((0.7, None, b"\xff\xd8"), (0.72, "png", b"\x89P"), (0.74, None, b"\x89P"), (0.76, "jpeg", b"\xff\xd8"))
            for value, codec, signature in asked:
                await caller.call("view.stream", view=view, stream="image", **({"moving": codec} if codec else {}))
                revision = (await caller.call("scene.patch", session=session, patch=iso(value)))["revision"]
                await caller.frame(revision, still=True)
                frame = next(frame for frame in caller.frames if frame.revision == revision and not frame.still)
                assert frame.payload.startswith(signature), codec
            number = await caller.send("view.open", session=session, width=320, height=240, moving="webp")
            error = (await caller.answer(number))["error"]
            assert "moving" in json.dumps(error)

    run(attempt)


def width_of_lines(picture: numpy.ndarray) -> float:
    """Width of two vertical lines, measured in the picture's middle row. Soft edges count in proportion."""
    return picture[picture.shape[0] // 2, :, 0].sum() / 255 / 2


def test_lines_are_as_wide_in_moving_and_still_pictures_and_on_any_screen(server):
    async def attempt():
        async with client(server) as caller:
            scene = {"dataset": "box", "background": "#000000", "annotations": {"legend": False, "triad": False}, "camera": {
                "position": [0, -8, 0], "target": [0, 0, 0], "up": [0, 0, 1], "parallel": True, "parallel_height": 1.5},
                "lighting": {"on": False},
                "layers": {"lines": {"type": "edges", "angle": 80, "color": {"solid": "#ff0000"}, "width": 3}}}
            session = (await caller.call("session.open", scene=scene))["session"]
            view = (await caller.call("view.open", session=session, width=640, height=360))["view"]
            asked = ((640, 360, {}, 1), (1280, 720, {"pixel_ratio": 2}, 2), (2560, 1440, {}, 2), (1600, 900, {"pixel_ratio": 1}, 1))
            for width, height, ratio, times in asked:
                await caller.call("view.resize", view=view, width=width, height=height, **ratio)
                frame = moving = None
                while frame is None or not (frame.still and frame.width == width):
                    moving = frame  # the last frame before the still; at most 1280 x 720 pixels
                    frame = await caller.next_frame()
                    await caller.acknowledge(frame)
                for frame in (moving, frame):
                    picture = pixels(vtkPNGReader(), frame.payload)
                    shown = width_of_lines(picture) * width / picture.shape[1]
                    assert shown == pytest.approx(3 * times, rel=0.2), (width, height, ratio, frame.still)
            for height, times in ((180, 1), (720, 1), (1440, 2)):
                answer = await caller.call("picture.render", session=session, width=height * 16 // 9, height=height)
                picture = pixels(vtkPNGReader(), base64.b64decode(answer["data"]))
                assert width_of_lines(picture) == pytest.approx(3 * times, rel=0.2), height
            await caller.call("view.resize", view=view, width=640, height=360, pixel_ratio=1.5)
            await caller.call("view.stream", view=view, stream="geometry")
            frame = await caller.next_frame()
            while frame.kind != 2:
                await caller.acknowledge(frame)
                frame = await caller.next_frame()
            assert b'"width": 4.5' in frame.payload

    run(attempt)


def colors_of_stills(running: Server) -> list[int]:
    """Numbers of colors in a view's still and in a separate picture of a white box on black. Soft edges add grays."""
    scene = {"dataset": "box", "background": "#000000", "annotations": {"legend": False, "triad": False},
             "lighting": {"on": False}, "layers": {"all": {"type": "surface", "color": {"solid": "#ffffff"}}},
             "camera": {"position": [3, -8, 5], "target": [0.5, 0.5, 0.5], "up": [0, 0, 1]}}
    stills = []

    async def attempt():
        async with client(running) as caller:
            session = (await caller.call("session.open", scene=scene))["session"]
            await caller.call("view.open", session=session, width=320, height=240)
            frame = await caller.next_frame()
            while not frame.still:
                await caller.acknowledge(frame)
                frame = await caller.next_frame()
            answer = await caller.call("picture.render", session=session, width=320, height=240)
            stills.extend((frame.payload, base64.b64decode(answer["data"])))

    run(attempt)
    return [len(numpy.unique(pixels(vtkPNGReader(), still)[:, :, 0])) for still in stills]


def test_stills_have_as_many_samples_as_the_server_was_given(server, tmp_path):
    assert all(colors > 2 for colors in colors_of_stills(server))
    box = box_dataset.write_box(tmp_path / "box.ciel", n=4)
    with Server(box, "--still-samples", "1") as running:
        assert colors_of_stills(running) == [2, 2]
    with Server(box, environment={"CIEL_STILL_SAMPLES": "1"}) as running:
        assert colors_of_stills(running) == [2, 2]
    refused = ciel("serve", box, "--still-samples", "3")
    assert refused.returncode == 2 and "--still-samples" in refused.stderr


def test_a_burst_of_a_hundred_patches_draws_what_the_line_has_room_for_and_the_last(server):
    async def attempt():
        async with client(server) as caller:
            session, _ = await open_view(caller)
            revision = (await caller.call("scene.get", session=session))["revision"]
            await caller.frame(revision, still=True)  # the view is at rest
            held = await caller.call("scene.patch", session=session, patch=iso(0.3))
            while not isinstance(await caller.receive(), Frame):
                pass  # the frame is not acknowledged, so the window has room for only a few more
            drawn, last = len(caller.frames), held["revision"] + 100
            for i in range(100):
                await caller.send("scene.patch", session=session, patch=iso(0.4 + i / 200))
            while (await caller.call("scene.get", session=session))["revision"] < last:
                pass
            await caller.acknowledge(caller.frames[-1])
            await caller.frame(last)
            shown = [frame.revision for frame in caller.frames[drawn:] if frame.revision > held["revision"] and not frame.still]
            assert len(shown) <= 8 and shown[-1] == last, shown
            assert (await caller.frame(last, still=True)).revision == last

    run(attempt)


def test_without_acknowledgements_two_frames_come_and_no_more(server):
    async def attempt():
        async with client(server) as caller:
            session, view = await open_view(caller)
            for i in range(20):
                await caller.call("scene.patch", session=session, patch=iso(0.4 + i / 100))
                with contextlib.suppress(asyncio.TimeoutError):
                    await asyncio.wait_for(caller.receive(), 0.05)
            assert 1 <= len(caller.frames) <= 2
            await caller.acknowledge(caller.frames[-1])
            newest = (await caller.call("scene.get", session=session))["revision"]
            assert (await caller.frame(newest)).revision == newest

    run(attempt)


def test_geometry_comes_in_batches(server):
    async def attempt():
        async with client(server) as caller:
            session, view = await open_view(caller, stream="geometry")
            revision = (await caller.call("scene.patch", session=session, patch=iso(0.6)))["revision"]
            vertices = 0
            while True:
                frame = await caller.next_frame()
                if frame.flags & 2:
                    await caller.acknowledge(frame)
                if frame.revision < revision:
                    continue
                assert frame.kind == 2 and frame.view == view
                size = int.from_bytes(frame.payload[:4], "little")
                batch = json.load(io.BytesIO(frame.payload[4 : 4 + size]))
                if batch["batches"]:
                    vertices += batch["vertices"]
                if frame.flags & 2:
                    break
            assert vertices > 0

    run(attempt)


def stuck_client(server: Server) -> socket.socket:
    """A WebSocket client with a small buffer that never reads."""
    stuck = socket.socket()
    stuck.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    stuck.connect(("127.0.0.1", server.port))
    stuck.sendall(UPGRADE)
    assert stuck.recv(12) == b"HTTP/1.1 101"
    return stuck


def text_frame(document: dict) -> bytes:
    payload = json.dumps(document).encode()
    return bytes([0x81, 0xFE]) + len(payload).to_bytes(2, "big") + b"\0\0\0\0" + payload


def test_a_client_that_does_not_read_blocks_nobody(server):
    stuck = stuck_client(server)
    discover = text_frame({"jsonrpc": "2.0", "id": 1, "method": "rpc.discover", "params": {}, "pad": "x" * 120})
    before = server.metrics()["ciel_gateway_websockets_open"]
    ended = False
    stuck.settimeout(5)
    try:
        for _ in range(2000):  # each answer has some tens of kilobytes, far more in total than the limit
            stuck.sendall(discover)
    except (ConnectionError, TimeoutError):
        ended = True

    async def attempt():
        async with client(server) as caller:
            session, _ = await open_view(caller)
            revision = (await caller.call("scene.patch", session=session, patch=iso(0.7)))["revision"]
            assert (await caller.frame(revision)).revision == revision

    run(attempt)
    until(lambda: ended or server.metrics()["ciel_gateway_websockets_open"] < before)
    stuck.close()


def test_clients_that_vanish_are_forgotten(server):
    def state() -> tuple[float, int]:
        return server.metrics()["ciel_gateway_websockets_open"], server.open_files()

    async def vanish():
        async with client(server) as caller:
            session, _ = await open_view(caller)
            for i in range(20):
                await caller.send("scene.patch", session=session, patch=iso(0.4 + i / 100))
            await caller.send("picture.render", session=session, width=1024, height=1024)
            sock = caller.socket.transport.get_extra_info("socket")
            # Linger of zero makes the close a reset.
            sock.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
            caller.socket.transport.abort()

    before = state()
    for _ in range(10):
        run(vanish)
    until(lambda: state() <= before)


def test_two_clients_of_a_session_hear_of_each_other(server):
    async def attempt():
        async with client(server) as first, client(server) as second:
            session, _ = await open_view(first)
            await second.call("session.open", session=session)
            revision = (await second.call("scene.patch", session=session, patch=iso(0.55)))["revision"]
            frame = await first.frame(revision)
            assert frame.revision == revision
            assert "scene.changed" in [notification["method"] for notification in first.notifications]
            assert not second.notifications

    run(attempt)


def test_a_session_outlives_its_connection(server):
    async def attempt():
        async with client(server) as caller:
            session, _ = await open_view(caller)
            revision = (await caller.call("scene.patch", session=session, patch=iso(0.65)))["revision"]
        async with client(server) as caller:
            state = await caller.call("session.open", session=session)
            assert state["revision"] == revision and state["scene"]["layers"]["iso"]["values"] == [0.65]

    run(attempt)
