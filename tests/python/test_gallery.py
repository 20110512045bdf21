"""The gallery: its commands reproduce its pictures, and its scene documents are those that it shows."""

import os
import pathlib
import re
import shlex
import tarfile

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from program import ciel

GALLERY = pathlib.Path(__file__).resolve().parents[2] / "protocol" / "gallery"
DATA = pathlib.Path(os.environ.get("CIEL_DATA", "data"))
NASA, SPHERE = DATA / "nasa", DATA / "sphere_polyhedra.tar.xz"
COMMANDS = [shlex.split(line, comments=True) for line in re.findall(r"^build/ciel .*$", (GALLERY / "README.md").read_text(), re.MULTILINE)]
RENDERS = {pathlib.Path(words[4]).stem: words for words in COMMANDS if words[1] == "render"}
MAKES = {words[-1]: words for words in COMMANDS if words[1] != "render"}


def pixels(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(float)


def test_every_scene_has_a_picture_and_a_command():
    scenes = {path.stem for path in GALLERY.glob("*.json")}
    assert scenes == {path.stem for path in GALLERY.glob("*.png")} == set(RENDERS)
    for name, words in RENDERS.items():
        assert words[2] in MAKES, f"how {words[2]} is made is not said"
        assert (GALLERY / f"{name}.png").stat().st_size < 200_000
        width, height = map(int, words[words.index("--size") + 1].split("x"))
        assert pixels(GALLERY / f"{name}.png").shape == (height, width, 3)


def input_of(word, folder):
    """Returns the local path of a file that a command of the gallery reads."""
    if word.endswith(".foam"):
        with tarfile.open(SPHERE) as files:
            files.extractall(folder)
        return folder / "sphere_polyhedra" / word
    return NASA / word if word.endswith(".bin") else word


@pytest.mark.parametrize("name", sorted(RENDERS))
def test_its_command_draws_the_picture(name, tmp_path):
    render = RENDERS[name]
    make = MAKES[render[2]]
    if make[1] == "import" and not (NASA.is_dir() and SPHERE.is_file()):
        pytest.skip("CIEL_DATA does not name the folder with the real datasets")
    inputs = [input_of(word, tmp_path) for word in make[1:]]
    for words in (inputs, [GALLERY.parents[1] / word if word.endswith(".json") else word for word in render[1:]]):
        done = ciel(*words, cwd=tmp_path)
        assert done.returncode == 0, done.stderr
    kept, drawn = pixels(GALLERY / f"{name}.png"), pixels(tmp_path / render[-1])
    # Compares means of 8 x 8 pixels. Edges may differ between drivers; colors and cameras may not.
    height, width = kept.shape[0] // 8 * 8, kept.shape[1] // 8 * 8
    blocks = [image[:height, :width].reshape(height // 8, 8, width // 8, 8, 3).mean((1, 3)) for image in (kept, drawn)]
    differing = (np.abs(blocks[0] - blocks[1]).max(2) > 12).mean()
    assert differing < 0.02, f"{100 * differing:.1f} % of the picture differ"
