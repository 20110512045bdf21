"""ciel demo, info and append, run by a user and observed by another process."""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

import numpy
import pytest
import vtk
import zarr

import box_dataset
from import_support import NO_NEIGHBOUR
from program import CIEL, ciel
from serve_process import Server
from stored_blocks import cells_of, read_blocks
from vtk_files import add_array, image, write


def info(dataset):
    result = ciel("info", dataset, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    path = tmp_path_factory.mktemp("demo") / "demo.ciel"
    result = ciel("demo", "-o", path)
    assert result.returncode == 0, result.stderr
    return path


@pytest.fixture
def copy(demo, tmp_path):
    """A separate copy of the demo dataset. Its files are hard links, since the store replaces files and never rewrites them."""
    return pathlib.Path(shutil.copytree(demo, tmp_path / "copy.ciel", copy_function=os.link))


def test_a_vector_is_colored_by_its_magnitude_and_called_so(demo, tmp_path):
    result = ciel("extract", demo, "--slice", "z=1", "--color", "U", "-o", tmp_path / "s.vtp")
    assert result.returncode == 0 and b'Name="U:magnitude"' in (tmp_path / "s.vtp").read_bytes()


def test_a_dataset_without_blocks_says_how_to_write_it_again(tmp_path):
    old, new = box_dataset.write_box(tmp_path / "old.ciel", 8), tmp_path / "new.ciel"
    text = ciel("info", old, check=True).stdout
    assert "with `ciel import old.ciel -o NEW.ciel`" in text and not info(old)["memory"]["stored_blocks"]
    for wrong in (["--weld"], ["--array", "r"], ["--list"]):
        refused = ciel("import", old, *wrong, "-o", new)
        assert refused.returncode == 1 and "is a dataset" in refused.stderr
    written = ciel("import", old, "-o", new)
    assert written.returncode == 0, written.stderr
    before, after = info(old), info(new)
    assert after["memory"]["stored_blocks"] and "ciel import" not in ciel("info", new, check=True).stdout
    for same in ("input", "meshes", "bounds", "times", "groups"):
        assert before[same] == after[same], same
    assert [(array["name"], array["range"]) for array in before["arrays"]] == [
        (array["name"], array["range"]) for array in after["arrays"]]
    assert ciel("import", old, "-o", old).returncode == 1
    assert ciel("import", old, "-o", old, "--force").returncode == 0 and info(old)["memory"]["stored_blocks"]


def test_a_demo_has_the_name_of_a_dataset(tmp_path):
    result = ciel("demo", "-o", tmp_path / "demo.foo")
    assert result.returncode == 2 and "must end in .ciel" in result.stderr and not any(tmp_path.iterdir())


def test_a_coarse_demo_is_a_small_dataset_of_the_same_kind(demo, tmp_path):
    result = ciel("demo", "--coarseness", 4, "-o", tmp_path / "coarse.ciel")
    assert result.returncode == 0, result.stderr
    small, large = info(tmp_path / "coarse.ciel"), info(demo)
    assert small["input"]["cells"] < large["input"]["cells"] / 50
    assert [(array["name"], array["components"]) for array in small["arrays"]] == [
        (array["name"], array["components"]) for array in large["arrays"]
    ]
    for refused in (0, 5, 1.5):
        result = ciel("demo", "--coarseness", refused, "-o", tmp_path / "refused.ciel")
        assert result.returncode == 2 and "--coarseness" in result.stderr, result.stderr


def test_info_has_the_promised_keys(demo):
    told = info(demo)
    assert set(told["input"]) == {"vertices", "edges", "cells"}
    assert set(told["mesh"]) == {"vertices", "edges", "faces", "half_edges", "boundary_faces", "components", "cells",
                                 "positions"}
    assert told["mesh"]["cells"]["polyhedron"] >= 100_000 and told["mesh"]["components"] == 1
    assert len(told["bounds"]) == 6
    keys = {"name", "association", "components", "range", "units", "times", "ambiguous_faces"}
    assert all(keys <= set(array) for array in told["arrays"])
    assert {array["name"]: array["components"] for array in told["arrays"]} == {"U": 3, "tracer": 1, "vorticity": 1}
    assert told["memory"]["topology_bytes"] > told["mesh"]["half_edges"]
    assert told["memory"]["bytes_per_half_edge"] == pytest.approx(told["memory"]["topology_bytes"] / told["mesh"]["half_edges"])
    assert told["checksums"]["verified"] == 60 and told["checksums"]["without_checksum"] == 0


def test_info_counts_what_zarr_reads(demo):
    mesh = zarr.open_group(str(demo), mode="r")["meshes/0"]
    told = info(demo)
    assert told["mesh"]["boundary_faces"] == (mesh["faces/neighbour"][:] == NO_NEIGHBOUR).sum()
    blocks = read_blocks(demo / "meshes/0/blocks")[2]
    faces = [face for block in blocks for _, _, of_cell in cells_of(block) for face in of_cell]
    corners, end = numpy.concatenate(faces), numpy.cumsum([len(face) for face in faces])
    assert told["mesh"]["half_edges"] == len(corners)
    after = numpy.arange(1, len(corners) + 1)
    after[end - 1] = [0, *end[:-1]]
    pairs = numpy.sort(numpy.stack([corners, corners[after]], 1).astype("u8"), axis=1)
    assert told["mesh"]["edges"] == len(numpy.unique(pairs[:, 0] << numpy.uint64(32) | pairs[:, 1]))
    speed = max(numpy.linalg.norm(mesh["arrays/U"][step].astype("f8"), axis=1).max() for step in range(20))
    assert next(a for a in told["arrays"] if a["name"] == "U")["range"][1] == pytest.approx(speed)


def test_info_reads_well(demo):
    text = ciel("info", demo).stdout
    for word in ("polyhedron", "cylinder", "vorticity", "per half-edge", "Chaos 3, 555", "60 chunks verified"):
        assert word in text


def test_info_finds_one_damaged_chunk(copy):
    chunk = copy / "meshes/0/arrays/tracer/7.0"
    content = bytearray(chunk.read_bytes())
    content[1000] ^= 1
    chunk.unlink()
    chunk.write_bytes(content)
    result = ciel("info", copy)
    assert result.returncode == 1 and "tracer/7.0" in result.stderr and "checksum" in result.stderr
    assert len(result.stderr.splitlines()) == 1


def test_demo_does_not_overwrite_unless_told(demo):
    before = (demo / ".zattrs").read_bytes()
    result = ciel("demo", "-o", demo)
    assert result.returncode == 1 and "exists already" in result.stderr
    assert (demo / ".zattrs").read_bytes() == before


def test_a_killed_demo_leaves_no_dataset(tmp_path):
    process = subprocess.Popen([CIEL, "demo", "-o", str(tmp_path / "a.ciel")])
    deadline = time.monotonic() + 120
    while not any(tmp_path.glob(".a.ciel.writing-*/meshes/0/arrays/U/*")):
        assert process.poll() is None and time.monotonic() < deadline
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    assert not (tmp_path / "a.ciel").exists()


def test_append_npy(copy, tmp_path):
    vertices = info(copy)["mesh"]["vertices"]
    values = numpy.random.default_rng(1).random(vertices)
    numpy.save(tmp_path / "t.npy", values)
    numpy.save(tmp_path / "u.npy", numpy.ones((vertices, 3), "<f4"))
    result = ciel("append", copy, "--time", 2, "--array", f"tracer={tmp_path}/t.npy", "--array", f"U={tmp_path}/u.npy")
    assert result.returncode == 0, result.stderr
    told = info(copy)
    assert told["times"][-1] == 2 and len(told["times"]) == 21
    arrays = {array["name"]: array for array in told["arrays"]}
    assert arrays["tracer"]["times"][-1] == 2 and arrays["vorticity"]["times"][-1] < 2
    group = zarr.open_group(str(copy), mode="r")["meshes/0/arrays"]
    assert (group["tracer"][20] == values.astype("<f4")).all()
    assert numpy.isnan(group["vorticity"][20]).all(), "not written at that time"


def test_append_other_dataset(demo, copy, tmp_path):
    marker = json.loads((copy / "steps.json").read_text())
    marker["steps"] = marker["steps"][:15]
    (tmp_path / "new").write_text(json.dumps(marker))
    os.replace(tmp_path / "new", copy / "steps.json")
    result = ciel("append", copy, "--from", demo)
    assert result.returncode == 0 and "5 of 20" in result.stdout, result.stderr
    assert info(copy)["times"] == info(demo)["times"]
    again = ciel("append", copy, "--from", demo)
    assert again.returncode == 1 and "no step later" in again.stderr


def write_moving_box(directory, steps, moved_from):
    """Writes a box whose positions change at step `moved_from`."""
    box_dataset.write_box(directory, n=3, steps=steps)
    mesh = directory / "meshes/0"
    positions = (numpy.fromfile(mesh / "positions/0.0.0", "<f4") + 1).tobytes()
    (mesh / "positions/1.0.0").write_bytes(positions)
    shape = json.loads((mesh / "positions/.zarray").read_text())
    shape["shape"][0] = 2
    (mesh / "positions/.zarray").write_text(json.dumps(shape))
    attributes = json.loads((mesh / ".zattrs").read_text())
    attributes["ciel"]["coordinate_checksums"].append(box_dataset.checksum(positions))
    (mesh / ".zattrs").write_text(json.dumps(attributes))
    marker = json.loads((directory / "steps.json").read_text())
    for step in marker["steps"][moved_from:]:
        step["coordinates"] = 1
    (directory / "steps.json").write_text(json.dumps(marker))
    return directory


def test_append_adds_positions_only_where_a_mesh_moves(tmp_path):
    ours = box_dataset.write_box(tmp_path / "ours.ciel", n=3, steps=1)
    moving = write_moving_box(tmp_path / "moving.ciel", steps=6, moved_from=2)
    result = ciel("append", ours, "--from", moving)
    assert result.returncode == 0 and "5 of 6" in result.stdout, result.stderr
    assert [step["coordinates"] for step in json.loads((ours / "steps.json").read_text())["steps"]] == [0, 0, 1, 1, 1, 1]
    assert sorted(path.name for path in (ours / "meshes/0/positions").glob("*.0.0")) == ["0.0.0", "1.0.0"]
    assert info(ours)["times"] == info(moving)["times"]


def test_appended_cell_values_have_point_values_as_imported_ones_do(tmp_path):
    box = box_dataset.write_box(tmp_path / "box.ciel", n=3)
    numpy.save(tmp_path / "w.npy", numpy.arange(27, dtype="f4"))
    result = ciel("append", box, "--time", 9, "--array", f"cell:w={tmp_path}/w.npy")
    assert result.returncode == 0 and "made from cell values: w" in result.stdout, result.stderr
    arrays = {array["name"]: array for array in info(box)["arrays"]}
    assert arrays["w"]["association"] == "point" and arrays["w"]["range"] == [0, 26]
    assert "new arrays: cell:w, w" in result.stdout and "not written: r, x" in result.stdout


@pytest.mark.parametrize(
    "arguments, error",
    [
        ([], "--from"),
        (["--time", 5], "--array"),
        (["--time", 5, "--array", "p"], "NAME=FILE.npy"),
        (["--time", 5, "--array", "p=nothing.npy"], "nothing.npy"),
        (["--time", 5, "--array", "tracer={few}"], "3 x 1 values; 'tracer' must have"),
        (["--time", 5, "--array", "tracer={text}"], "not a .npy"),
        (["--time", 5, "--array", "tracer={integers}"], "float32"),
        (["--time", 0.1, "--array", "tracer={good}"], "not later"),
        (["--time", 5, "--array", "../x={good}"], "holds a '/'"),
        (["--time", 5, "--array", "cell:a/b={good}"], "holds a '/'"),
        (["--time", 5, "--array", "a:b={good}"], "':'"),
        (["--time", 5, "--array", "..={good}"], "is . or .."),
        (["--time", 5, "--array", "cell:={good}"], "is empty"),
        (["--time", 5, "--array", " p={good}"], "begins or ends with a space"),
        (["--time", 5, "--array", "a\nb={good}"], "control character"),
        (["--time", 5, "--array", "x" * 201 + "={good}"], "longer than 200 bytes"),
        (["--from", "{text}"], "is a file"),
    ],
)
def test_append_refuses(demo, tmp_path, arguments, error):
    vertices = zarr.open_group(str(demo), mode="r")["meshes/0/original_vertex"].shape[0]
    files = {name: tmp_path / f"{name}.npy" for name in ("few", "text", "integers", "good")}
    numpy.save(files["few"], numpy.zeros(3))
    files["text"].write_text("no numbers")
    numpy.save(files["integers"], numpy.zeros(3, "i8"))
    numpy.save(files["good"], numpy.zeros(vertices, "f4"))
    result = ciel("append", demo, *[str(a).format(**files) for a in arguments])
    assert result.returncode in (1, 2) and error in result.stderr + result.stdout
    assert len(json.loads((demo / "steps.json").read_text())["steps"]) == 20


def test_the_recipe_of_the_readme_appends_a_step_with_plain_zarr(tmp_path, monkeypatch):
    grid = image(6)
    values = numpy.arange(grid.GetNumberOfPoints(), dtype="f8")
    add_array(grid.GetPointData(), "p", values)
    write(vtk.vtkXMLImageDataWriter(), tmp_path / "a.vti", grid)
    assert ciel("import", tmp_path / "a.vti", "-o", tmp_path / "run.ciel").returncode == 0
    readme = (pathlib.Path(__file__).parents[2] / "server/store/README.md").read_text(encoding="utf-8")
    recipe = re.search(r"```python\n(group = .*?)```", readme, re.DOTALL).group(1)
    monkeypatch.chdir(tmp_path)
    exec(recipe, {"zarr": zarr, "json": json, "os": os, "values": 7 * values})
    with Server(tmp_path / "run.ciel") as running:
        for vertex in (0, 17, 100):
            scene = {"dataset": "run", "time": 1.5, "layers": {}}
            answer = running.call("probe.point", scene=scene, position=list(grid.GetPoint(vertex)))
            assert answer["vertex"] == vertex and answer["values"]["p"] == 7 * vertex
