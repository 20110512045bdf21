"""`ciel serve --file-access`: records, values and positions are mapped or copied, and the pictures are the same."""

import pathlib

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import numpy_to_vtk

from import_support import imported
from serve_process import Server
from vtk_files import image, points_of

LAYERS = {"a": {"type": "iso", "array": "p", "values": [1.1], "color": {"array": "p"}}}
READ_BY_BLOCKS = ("/blocks/", "/positions/", "/arrays/")


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    folder = tmp_path_factory.mktemp("data")
    grid = image(20)
    values = numpy_to_vtk(np.linalg.norm(points_of(grid), axis=1), deep=1)
    values.SetName("p")
    grid.GetPointData().AddArray(values)
    writer = vtk.vtkXMLImageDataWriter()
    writer.SetFileName(str(folder / "a.vti"))
    writer.SetInputData(grid)
    writer.Write()
    return imported(folder, folder / "a.vti").path


def picture_of(dataset, access):
    """Returns a picture, and the mapped files that are read block by block."""
    with Server(dataset, "--file-access", access) as running:
        scene = {"dataset": dataset.stem, "layers": LAYERS}
        png = running.call("picture.render", scene=scene, width=320, height=200)["data"]
        maps = pathlib.Path(f"/proc/{running.process.pid}/maps").read_text(encoding="utf-8")
    files = [line.split(maxsplit=5)[-1] for line in maps.splitlines() if str(dataset) in line]
    return png, [file for file in files if any(part in file for part in READ_BY_BLOCKS)]


def test_copied_files_are_not_mapped_and_give_the_same_picture(dataset):
    mapped, files = picture_of(dataset, "mapped")
    assert files
    copied, none = picture_of(dataset, "copied")
    assert copied == mapped and none == []
