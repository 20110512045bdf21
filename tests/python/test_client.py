"""The Python client (protocol/python) against a real server."""

import asyncio

import pytest

import box_dataset
from ciel_client import Batches, Client, Pieces, RpcError, Stream, mesh_codec, read_frame
from ciel_client.frame_queue import FrameQueue
from ciel_client.frame_header import GEOMETRY, IMAGE, FrameHeader, write_frame_header
from ciel_client.types import ERROR_CODES
from serve_process import PATIENCE, Server, iso

TOKEN = "0123456789abcdef"


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    box = box_dataset.write_box(tmp_path_factory.mktemp("data") / "box.ciel")
    with Server(box, "--token", TOKEN) as running:
        yield running


def test_calls_and_batches(server):
    client = Client(server.base + "/", TOKEN)
    assert client.call("dataset.list") == [{"name": "box", "problem": ""}]
    listed, error, described = client.batch(
        [("dataset.list", {}), ("dataset.describe", {"dataset": "bax"}), ("dataset.describe", {"dataset": "box"})])
    assert listed[0]["name"] == described["name"] == "box"
    assert isinstance(error, RpcError) and error.code == ERROR_CODES["NotFound"]
    assert client.batch([]) == []
    with pytest.raises(RpcError, match="/dataset is missing") as refused:
        client.call("dataset.describe")
    assert refused.value.path == "/dataset" and refused.value.message == "Invalid params" and refused.value.request
    with pytest.raises(RpcError, match="64"):
        client.batch([("dataset.list", {})] * 65)


def test_the_printed_address_is_enough(server):
    printed = f"{server.base}/?token={TOKEN}"
    assert Client(printed).call("dataset.list")[0]["name"] == "box"

    async def attempt(address: str) -> None:
        async with Stream(address) as stream:
            assert (await stream.call("dataset.list"))[0]["name"] == "box"

    for address in (printed, server.base.replace("http", "ws") + "/ws?token=" + TOKEN):
        asyncio.run(asyncio.wait_for(attempt(address), PATIENCE))
    with pytest.raises(ValueError, match="not the address of a server"):
        Client("127.0.0.1:8080")


def test_a_server_that_refuses_is_named(server):
    with pytest.raises(ConnectionError, match="/rpc: 401"):
        Client(server.base, "another-token").call("dataset.list")


@pytest.mark.parametrize(("stream", "kind"), [("image", IMAGE), ("geometry", GEOMETRY)])
def test_frames_come_until_the_server_ends(tmp_path, stream, kind):
    async def attempt(running: Server) -> None:
        async with Stream(f"ws://127.0.0.1:{running.port}/ws", TOKEN) as viewer:
            session = (await viewer.call("session.open", dataset="box"))["session"]
            view = (await viewer.call("view.open", session=session, width=64, height=48, stream=stream))["view"]
            frames = viewer.frames()
            batches, batch = Batches(), None
            for i in range(20):  # more frames than a server sends without acknowledgements
                revision = (await viewer.call("scene.patch", session=session, patch=iso(0.6 + 0.01 * i)))["revision"]
                async for frame in frames:
                    assert frame.kind == kind and frame.view == view
                    if kind == GEOMETRY:
                        batch = batches.read(frame)
                    if frame.revision == revision:
                        break
            assert frame.triangles > 0 and frame.is_first
            if batch is not None:
                assert len(batch.positions) == 3 * batch.description["vertices"] > 0
                assert max(batch.indices) < batch.description["vertices"]
            with pytest.raises(RpcError):
                await viewer.call("scene.get", session="gone")
            picture = await viewer.call("picture.render", session=session, width=2400, height=2400)
            assert len(picture["data"]) > 512 << 10
            running.process.terminate()
            with pytest.raises(ConnectionError):
                while True:
                    await viewer.next_frame()
            assert (await viewer.notifications.get())["method"] == "server.draining"

    with Server(box_dataset.write_box(tmp_path / "box.ciel"), "--token", TOKEN) as running:
        asyncio.run(asyncio.wait_for(attempt(running), PATIENCE))


def image(number: int, size: int):
    header = FrameHeader(IMAGE, 7, 1, number, 1, 4, 4, 0, 0, 0, 0, 0, 0, size, size, 0)
    return read_frame(write_frame_header(header) + bytes(size))


def test_frames_that_wait_are_limited():
    async def attempt() -> None:
        queue = FrameQueue(100)
        await queue.put(image(1, 150))  # alone, a frame of any size fits
        with pytest.raises(BufferError, match="more than 100 bytes of frames wait"):
            await queue.put(image(2, 1))
        assert (await queue.take()).frame == 1
        for number, size in ((3, 60), (4, 40)):
            await queue.put(image(number, size))
        with pytest.raises(BufferError):
            await queue.put(image(5, 1))
        await queue.end("the end")
        assert [(await queue.take()).frame for _ in range(2)] == [3, 4]
        with pytest.raises(ConnectionError, match="the end"):
            await queue.take()

    asyncio.run(asyncio.wait_for(attempt(), PATIENCE))


def test_a_script_that_takes_no_frames_is_cut_at_its_limit(server):
    async def attempt() -> None:
        async with Stream(server.base, TOKEN, most_frame_bytes=1) as stream:
            session = (await stream.session_open(dataset="box"))["session"]
            for _ in range(2):
                await stream.view_open(session=session, width=64, height=48)
            with pytest.raises(ConnectionError, match="more than 1 bytes of frames wait"):
                while True:
                    await stream.next_frame()
                    await asyncio.sleep(0.5)
            with pytest.raises(ConnectionError, match="more than 1 bytes of frames wait"):
                await stream.call("dataset.list")

    asyncio.run(asyncio.wait_for(attempt(), PATIENCE))


def test_the_newest_notifications_are_kept():
    stream = Stream()
    for number in range(1005):
        stream._answer({"method": "scene.changed", "params": {"revision": number}})
    assert stream.notifications.qsize() == 1000
    assert stream.notifications.get_nowait()["params"]["revision"] == 5


def test_damaged_frames_are_refused():
    whole = write_frame_header(FrameHeader(IMAGE, 7, 1, 1, 1, 4, 4, 0, 0, 0, 0, 0, 0, 3, 3, 0)) + b"abc"
    assert read_frame(whole).payload == b"abc"
    for damaged, words in [
        (whole[:79], "has 79 bytes"),
        (b"X" + whole[1:], "does not begin with 'CIEL'"),
        (whole[:4] + b"\3" + whole[5:], "is of version 3"),
        (whole[:5] + b"\3" + whole[6:], "is of kind 3"),
        (whole[:7] + b"\x80" + whole[8:], "unknown flags 32775"),
        (whole[:-1], "announces 3 bytes after its header and has 2"),
        (whole[:68] + b"\1" + whole[69:], "has 3 bytes at offset 1, but the whole frame has only 3"),
    ]:
        with pytest.raises(ValueError, match=words):
            read_frame(damaged)


def piece(frame: int, offset: int, payload: bytes, whole: int, flags: int = 0, view: int = 1):
    return read_frame(
        write_frame_header(FrameHeader(IMAGE, flags, view, frame, 1, 4, 4, 0, 0, 0, 0, 0, 0, len(payload), whole, offset)) + payload
    )


def test_pieces_make_a_whole_and_a_newer_frame_takes_the_place_of_half_an_older_one():
    pieces = Pieces()
    assert pieces.add(piece(1, 0, b"ab", 5, flags=4)) is None
    assert pieces.add(piece(9, 0, b"x", 1, view=2)).payload == b"x"
    assert pieces.add(piece(1, 2, b"cd", 5)) is None
    whole = pieces.add(piece(1, 4, b"e", 5, flags=2))
    assert (whole.payload, whole.flags, whole.piece_offset) == (b"abcde", 6, 0)
    assert pieces.add(piece(2, 0, b"ab", 5)) is None
    assert pieces.add(piece(3, 0, b"new", 3)).payload == b"new"
    with pytest.raises(ValueError, match="a piece of frame 2 of view 1 is missing"):
        pieces.add(piece(2, 2, b"cd", 5))
    assert pieces.add(piece(4, 0, b"ab", 5)) is None
    with pytest.raises(ValueError, match="a piece of frame 4"):
        pieces.add(piece(4, 3, b"d", 5))


def test_polygons_that_stay_are_named_not_sent(server):
    async def attempt() -> None:
        async with Stream(f"ws://127.0.0.1:{server.port}/ws", TOKEN) as viewer:
            session = (await viewer.call("session.open", dataset="box"))["session"]
            await viewer.call("view.open", session=session, width=64, height=48, stream="geometry")
            batches = Batches()

            async def shown(patch: dict) -> tuple[dict, int]:
                revision = (await viewer.call("scene.patch", session=session, patch=patch))["revision"]
                layers, size = {}, 0
                async for frame in viewer.frames():
                    if frame.is_first:
                        layers, size = {}, 0
                    batch = batches.read(frame)
                    layers[batch.description.get("layer")] = batch
                    size += len(frame.payload)
                    if frame.revision >= revision and frame.is_last:
                        await viewer.acknowledge(frame)  # acknowledges before the next change
                        return layers, size
                raise AssertionError("no frame")

            before, whole = await shown(iso(0.6))
            named, small = await shown({"layers": {"further": {"type": "slice", "axis": "x", "value": 0.51}}})
            assert "bytes" in before["iso"].description["mesh"] and "bytes" not in named["iso"].description["mesh"]
            assert "bytes" in named["further"].description["mesh"]
            assert small < whole
            assert named["iso"].positions == before["iso"].positions and named["iso"].indices == before["iso"].indices

    asyncio.run(asyncio.wait_for(attempt(), PATIENCE))


def test_damaged_polygons_are_refused():
    vertices = bytes([0xA0]) + bytes(40)
    for decode, arguments in [(mesh_codec.vertices, (1, 12)), (mesh_codec.triangles, (3,)), (mesh_codec.sequence, (2,))]:
        for data in (b"", bytes([0x55]) + vertices, vertices[:5], bytes([0xE1, 0xFF]), bytes([0xD1, 0x80])):
            with pytest.raises(ValueError):
                decode(data, *arguments)
