"""Memory of a large dataset or view is given back to the system once it is gone. The server looks every ten seconds."""

import asyncio
import pathlib
import subprocess

import numpy as np
import pytest

from program import CIEL
from serve_process import PATIENCE, Server, client, until


# Kilobytes. The server keeps freed memory of less than 32 MiB (limits/machine_memory.hpp), and an idle drawing thread up to
# 34 MiB more than after a small picture (engine/schedule/frame_workers.cpp); the rest is for noise.
MOST_KEPT = 80_000
LEAST_USED = 130_000  # a part of the memory may be given back before the picture is there


def write_box(path: pathlib.Path, n: int) -> None:
    """Writes a legacy VTK file: a cube of n * n * n cells with `r`, the distance from its center."""
    axis = np.linspace(-1, 1, n + 1)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    head = (f"# vtk DataFile Version 3.0\nbox\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS {n + 1} {n + 1} {n + 1}\n"
            f"ORIGIN -1 -1 -1\nSPACING {2 / n} {2 / n} {2 / n}\nPOINT_DATA {(n + 1) ** 3}\nSCALARS r float 1\nLOOKUP_TABLE default\n")
    path.write_bytes(head.encode() + np.sqrt(x * x + y * y + z * z).astype(">f4").tobytes())


@pytest.fixture(scope="module")
def boxes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("data")
    for name, n in (("small", 4), ("medium", 128), ("large", 156)):
        write_box(folder / f"{name}.vtk", n)
        subprocess.run([CIEL, "import", folder / f"{name}.vtk", "-o", folder / f"{name}.ciel"],
                       check=True, capture_output=True, timeout=4 * PATIENCE)
    return folder


def show(running: Server, dataset: str, layers: dict) -> int:
    """Opens a session with a view, waits for its still and ends the session. Returns the private
    kilobytes while it was open."""
    async def shown():
        async with client(running) as caller:
            session = (await caller.call("session.open", scene={"dataset": dataset, "layers": layers}))["session"]
            await caller.call("view.open", session=session, width=320, height=200)
            await caller.frame(still=True)
            used = running.private_kilobytes()
            await caller.call("session.close", session=session)
            return used
    return asyncio.run(asyncio.wait_for(shown(), PATIENCE))


def test_a_dataset_that_is_gone_leaves_little_behind(boxes):
    layers = {"iso": {"type": "iso", "array": "r", "values": [0.2, 0.5, 0.8, 1.1, 1.4]}, "walls": {"type": "surface"}}
    small, large = boxes / "small.ciel", boxes / "large.ciel"
    with Server(small, large, environment={"CIEL_LIMIT_DATASET_IDLE_SECONDS": "1"}) as running:
        show(running, "small", layers)
        before = running.private_kilobytes()
        assert show(running, "large", layers) > before + LEAST_USED
        until(lambda: running.private_kilobytes() < before + MOST_KEPT)
        until(lambda: str(large) not in running.maps())
        show(running, "large", layers)  # the released dataset can be opened again


def test_a_view_that_is_gone_leaves_little_behind(boxes):
    values = [0.1 + 0.01 * i for i in range(60)]
    with Server(boxes / "medium.ciel", environment={"CIEL_LIMIT_DATASET_IDLE_SECONDS": "3600"}) as running:
        show(running, "medium", {"iso": {"type": "iso", "array": "r", "values": values[:1]}})
        before = running.private_kilobytes()
        for _ in range(2):
            used = show(running, "medium", {"iso": {"type": "iso", "array": "r", "values": values}})
            assert used > before + LEAST_USED
            until(lambda: running.private_kilobytes() < before + MOST_KEPT)
