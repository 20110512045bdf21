"""Imports that write the first and the last step, and read the others from the source when they are needed."""

import asyncio
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import threading

import numpy as np
import pytest
import requests
import vtk
from import_support import Dataset
from openfoam_files import N, write_case, write_decomposed
from program import CIEL_IMPORT, ciel
from serve_process import PATIENCE, Server, client, until
from vtk_files import CUBE, add_array, ring, structured, unstructured, with_fields, write

STEPS = 6


def write_pvd(path: pathlib.Path, files: list[str]) -> pathlib.Path:
    rows = "".join(f'<DataSet timestep="{step}" part="0" file="{file}"/>' for step, file in enumerate(files))
    path.write_text(f'<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1"><Collection>{rows}</Collection></VTKFile>')
    return path


def grid(step: int):
    return with_fields(structured(5), shift=float(step))


def write_series(folder: pathlib.Path, grids) -> pathlib.Path:
    folder.mkdir(exist_ok=True)
    files = []
    for step, data in enumerate(grids):
        files.append(f"{step}.vts")
        write(vtk.vtkXMLStructuredGridWriter(), folder / files[-1], data)
    return write_pvd(folder / "run.pvd", files)


@pytest.fixture()
def source(tmp_path):
    return write_series(tmp_path / "source", [grid(step) for step in range(STEPS)])


def run(*arguments, cache: pathlib.Path):
    return ciel(*arguments, timeout=300, env={**os.environ, "XDG_CACHE_HOME": str(cache)})


WHOLE = ["--all"]


def imported(source, output, cache, *options):
    done = run("import", source, "-o", output, *options, cache=cache)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def written(output) -> list[int]:
    """The steps whose chunks of the array f are in the dataset."""
    return sorted(int(file.name.split(".")[0]) for file in (output / "meshes/0/arrays/f").glob("[0-9]*"))


def files_of(output) -> dict[str, bytes]:
    """All chunks and ranges of arrays. The ranges contain the dataset's id, which differs."""
    array = output / "meshes/0/arrays"
    return {str(file.relative_to(array)): file.read_bytes() for file in array.rglob("*")
            if file.is_file() and file.parent.name not in ("late", "ranges")}


def test_the_first_and_the_last_step_are_written_and_the_others_are_late(source, tmp_path):
    said = imported(source, tmp_path / "a.ciel", tmp_path)
    assert "4 steps are read from the source when they are needed" in said
    assert re.search(r"memory \d+ MB after reading, at most \d+ MB more while writing \(\d+ bytes a cell\)", said)
    assert written(tmp_path / "a.ciel") == [0, 5]
    dataset = Dataset(tmp_path / "a.ciel")
    assert dataset.times == list(range(STEPS)) and dataset.array("f").shape[0] == STEPS
    assert dataset.facts["late"]["inputs"] == [str(source)]
    assert "16 not yet read from the source" in run("info", tmp_path / "a.ciel", cache=tmp_path).stdout


def test_all_writes_the_same_bytes_now_or_later(source, tmp_path):
    assert "are read from the source" not in imported(source, tmp_path / "whole.ciel", tmp_path, *WHOLE)
    imported(source, tmp_path / "late.ciel", tmp_path)
    one = run("import", tmp_path / "late.ciel", "--step", "3", cache=tmp_path)
    assert one.returncode == 0, one.stderr
    assert written(tmp_path / "late.ciel") == [0, 3, 5]
    rest = run("import", tmp_path / "late.ciel", "--all", cache=tmp_path)
    assert rest.returncode == 0, rest.stderr
    assert files_of(tmp_path / "late.ciel") == files_of(tmp_path / "whole.ciel")
    summary = [json.loads(run("info", tmp_path / f"{name}.ciel", "--json", cache=tmp_path).stdout) for name in ("late", "whole")]
    assert summary[0]["arrays"] == summary[1]["arrays"]


def test_a_short_series_is_written_whole(tmp_path):
    source = write_series(tmp_path / "source", [grid(0), grid(1)])
    imported(source, tmp_path / "a.ciel", tmp_path)
    assert written(tmp_path / "a.ciel") == [0, 1]


def test_a_mesh_that_changes_until_the_last_step_is_written_whole(tmp_path):
    moved = structured(5, bend=0.3)
    source = write_series(tmp_path / "source", [grid(0), grid(1), grid(2), with_fields(moved)])
    imported(source, tmp_path / "a.ciel", tmp_path)
    assert written(tmp_path / "a.ciel") == [0, 1, 2, 3]


def test_a_mesh_that_moves_and_comes_back_is_written_whole(tmp_path):
    source = write_series(tmp_path / "source", [grid(0), with_fields(structured(5, bend=0.3)), grid(2)])
    imported(source, tmp_path / "a.ciel", tmp_path)
    assert written(tmp_path / "a.ciel") == [0, 1, 2]


def test_an_array_of_the_steps_between_is_not_lost(tmp_path):
    more = grid(1)
    add_array(more.GetPointData(), "g", np.arange(125))
    source = write_series(tmp_path / "source", [grid(0), more, grid(2), grid(3)])
    imported(source, tmp_path / "a.ciel", tmp_path)
    assert written(tmp_path / "a.ciel") == [0, 1, 2, 3]


def test_the_environment_asks_for_all_steps(source, tmp_path):
    done = ciel("import", source, "-o", tmp_path / "a.ciel", env={**os.environ, "CIEL_IMPORT_ALL": "yes"})
    assert done.returncode == 0, done.stderr
    assert written(tmp_path / "a.ciel") == list(range(STEPS))


def test_a_step_with_another_mesh_is_refused(tmp_path):
    source = write_series(tmp_path / "source", [grid(0), with_fields(structured(5, bend=0.3)), grid(2), grid(3)])
    imported(source, tmp_path / "a.ciel", tmp_path)
    refused = run("import", tmp_path / "a.ciel", "--step", "1", cache=tmp_path)
    assert refused.returncode == 1 and "has another mesh at time 1.0" in refused.stderr and "--all --force" in refused.stderr
    assert run("import", tmp_path / "a.ciel", "--all", cache=tmp_path).returncode == 1
    assert written(tmp_path / "a.ciel") == [0, 2, 3]


def test_a_step_that_cannot_be_read_does_not_stop_the_others(source, tmp_path):
    (source.parent / "2.vts").write_text("no data")
    imported(source, tmp_path / "a.ciel", tmp_path)
    done = run("import", tmp_path / "a.ciel", "--all", cache=tmp_path)
    assert done.returncode == 1, done.stdout
    assert written(tmp_path / "a.ciel") == [0, 1, 3, 4, 5]


def test_a_loss_at_one_step_is_not_taken_for_one_of_the_next(tmp_path):
    other = structured(5)
    add_array(other.GetPointData(), "f", np.zeros((125, 3)))
    source = write_series(tmp_path / "source", [grid(0), other, grid(2), grid(3)])
    imported(source, tmp_path / "a.ciel", tmp_path)
    done = run("import", tmp_path / "a.ciel", "--all", cache=tmp_path)
    assert done.returncode == 1 and "cannot be read whole at time 1.0" in done.stderr and "2.0" not in done.stderr
    assert written(tmp_path / "a.ciel") == [0, 2, 3]


def test_an_array_that_a_step_lacks_is_absent_there(tmp_path):
    lacking = structured(5)
    add_array(lacking.GetPointData(), "f", np.arange(125))
    source = write_series(tmp_path / "source", [grid(0), lacking, grid(2), grid(3)])
    imported(source, tmp_path / "a.ciel", tmp_path)
    assert run("import", tmp_path / "a.ciel", "--all", cache=tmp_path).returncode == 0
    info = json.loads(run("info", tmp_path / "a.ciel", "--json", cache=tmp_path).stdout)
    times = {array["name"]: array["times"] for array in info["arrays"]}
    assert times["f"] == [0, 1, 2, 3] and times["v"] == [0, 2, 3]


def test_a_source_that_changed_or_is_gone_is_a_sentence(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    changed_file = source.parent / "2.vts"
    os.utime(changed_file, (changed_file.stat().st_mtime + 5,) * 2)
    changed = run("import", tmp_path / "a.ciel", "--all", cache=tmp_path)
    assert changed.returncode == 1 and "has changed at time 2.0 since it was imported" in changed.stderr
    assert written(tmp_path / "a.ciel") == [0, 1, 3, 4, 5]
    source.unlink()
    gone = run("import", tmp_path / "a.ciel", "--step", "2", cache=tmp_path)
    assert gone.returncode == 1 and "is not there any more" in gone.stderr
    assert written(tmp_path / "a.ciel") == [0, 1, 3, 4, 5]


def test_a_file_that_changes_while_it_is_read_is_told(tmp_path):
    """The process is stopped while it reads step 1. If it was too fast, the test begins again."""
    source = write_series(tmp_path / "source", [with_fields(structured(48), shift=float(step)) for step in range(3)])
    changed_file = source.parent / "1.vts"
    for attempt in range(5):
        dataset = tmp_path / f"{attempt}.ciel"
        imported(source, dataset, tmp_path)
        with subprocess.Popen([CIEL_IMPORT, "--step=1", "--", dataset], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as reader:
            next(line for line in reader.stdout if "reading, step 1" in line)
            reader.send_signal(signal.SIGSTOP)
            os.utime(changed_file, (changed_file.stat().st_mtime + 5,) * 2)
            reader.send_signal(signal.SIGCONT)
            said, problem = reader.communicate(timeout=PATIENCE)
        if not re.search("^step 1$", said, re.MULTILINE):
            break
    assert reader.returncode == 1 and "has changed at time 1.0 since it was imported" in problem
    assert written(dataset) == [0, 2]


def test_another_file_for_the_same_time_is_a_change(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    shutil.copy2(source.parent / "3.vts", source.parent / "other.vts")
    write_pvd(source, ["0.vts", "1.vts", "2.vts", "other.vts", "4.vts", "5.vts"])
    assert run("import", tmp_path / "a.ciel", "--step", "2", cache=tmp_path).returncode == 0
    changed = run("import", tmp_path / "a.ciel", "--step", "3", cache=tmp_path)
    assert changed.returncode == 1 and "since it was imported" in changed.stderr


def test_a_series_that_has_grown_is_read_on(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    write(vtk.vtkXMLStructuredGridWriter(), source.parent / f"{STEPS}.vts", grid(STEPS))
    write_pvd(source, [f"{step}.vts" for step in range(STEPS + 1)])
    assert run("import", tmp_path / "a.ciel", "--step", "2", cache=tmp_path).returncode == 0
    assert written(tmp_path / "a.ciel") == [0, 2, 5]


def test_an_openfoam_case_that_has_grown_is_read_on(tmp_path):
    case = write_foam_series(tmp_path / "case", is_decomposed=False)
    imported(case, tmp_path / "a.ciel", tmp_path)
    shutil.copytree(case / "1", case / "5")
    shutil.copy2(case / "2/p", case / "2/pMean")  # as a post-processing tool adds it
    assert run("import", tmp_path / "a.ciel", "--step", "1", cache=tmp_path).returncode == 0
    os.utime(case / "3/p", (0, 0))
    changed = run("import", tmp_path / "a.ciel", "--step", "2", cache=tmp_path)
    assert changed.returncode == 1 and "since it was imported" in changed.stderr


def write_foam_series(case: pathlib.Path, is_decomposed: bool) -> pathlib.Path:
    if is_decomposed:
        write_decomposed(case, [cell % N // 2 for cell in range(N**3)], {})
    else:
        write_case(case)
    for root in [case / f"processor{rank}" for rank in range(2)] if is_decomposed else [case]:
        for written, time in ("13", "24"):  # write_case and write_decomposed write the times 1 and 2
            shutil.copytree(root / written, root / time)
    return case


@pytest.mark.parametrize("is_decomposed", [False, True])
def test_values_in_cells_and_on_patches_are_the_same_now_or_later(tmp_path, is_decomposed):
    """The mesh of a whole case is known again; that of a decomposed case, whose pieces are welded, is matched again."""
    case = write_foam_series(tmp_path / "case", is_decomposed)
    imported(case, tmp_path / "whole.ciel", tmp_path, *WHOLE)
    imported(case, tmp_path / "late.ciel", tmp_path)
    assert (Dataset(tmp_path / "late.ciel").facts["late"]["mesh"] == "") == is_decomposed
    done = run("import", tmp_path / "late.ciel", "--all", cache=tmp_path)
    assert done.returncode == 0, done.stderr
    assert files_of(tmp_path / "late.ciel") == files_of(tmp_path / "whole.ciel")
    assert any("patch" in name for name in files_of(tmp_path / "late.ciel"))


def two_blocks(step: int):
    """Two hexahedra beside each other in two blocks, and a surface that is matched by the places of its corners."""
    blocks = vtk.vtkMultiBlockDataSet()
    for number, offset in enumerate((0, 1)):
        blocks.SetBlock(number, with_fields(unstructured([(vtk.VTK_HEXAHEDRON, list(range(8)))],
                                                         [(x + offset, y, z) for x, y, z in CUBE]), shift=float(step)))
    surface = unstructured([(vtk.VTK_QUAD, [0, 3, 2, 1])], CUBE[:4])
    add_array(surface.GetCellData(), "c", [100.0 + step])
    blocks.SetBlock(2, surface)
    return blocks


def with_bad_cells(step: int):
    """Three hexahedra in a row; the second one is a ghost, and a tetrahedron without volume and an unused point follow."""
    points = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in range(4)] + [(9, 9, 9)]
    row = [[i, i + 1, i + 5, i + 4, i + 8, i + 9, i + 13, i + 12] for i in range(3)]
    data = with_fields(unstructured([(vtk.VTK_HEXAHEDRON, nodes) for nodes in row] + [(vtk.VTK_TETRA, [0, 1, 2, 2])], points),
                       shift=float(step))
    ghosts = vtk.vtkUnsignedCharArray()
    ghosts.SetName("vtkGhostType")
    for ghost in (0, vtk.vtkDataSetAttributes.DUPLICATECELL, 0, 0):
        ghosts.InsertNextValue(ghost)
    data.GetCellData().AddArray(ghosts)
    return data


@pytest.mark.parametrize(("data", "writer", "ending", "is_known_again"), [
    (two_blocks, vtk.vtkXMLMultiBlockDataWriter, "vtm", True),
    (with_bad_cells, vtk.vtkXMLUnstructuredGridWriter, "vtu", True),
    (lambda step: with_fields(ring(), shift=float(step)), vtk.vtkXMLStructuredGridWriter, "vts", False),
], ids=["blocks", "bad cells", "a welded ring"])
def test_all_kinds_of_meshes_have_the_same_bytes_now_or_later(tmp_path, data, writer, ending, is_known_again):
    (tmp_path / "source").mkdir()
    names = [f"{step}.{ending}" for step in range(4)]
    for step, name in enumerate(names):
        write(writer(), tmp_path / "source" / name, data(step))
    source = write_pvd(tmp_path / "source/run.pvd", names)
    imported(source, tmp_path / "whole.ciel", tmp_path, *WHOLE)
    imported(source, tmp_path / "late.ciel", tmp_path, "--allow-bad")
    assert (Dataset(tmp_path / "late.ciel").facts["late"]["mesh"] != "") == is_known_again
    done = run("import", tmp_path / "late.ciel", "--all", cache=tmp_path)
    assert done.returncode == 0, done.stderr
    assert files_of(tmp_path / "late.ciel") == files_of(tmp_path / "whole.ciel")


@pytest.mark.parametrize("name", ["{step}/0.vts", "{step}_0.vts", "piece{step}.vts"])
def test_the_pieces_of_a_step_count(tmp_path, name):
    (tmp_path / "source").mkdir()
    names = []
    for step in range(4):
        piece = name.format(step=step)
        (tmp_path / "source" / piece).parent.mkdir(exist_ok=True)
        write(vtk.vtkXMLStructuredGridWriter(), tmp_path / "source" / piece, grid(step))
        names.append(f"{step}.vtm")
        (tmp_path / "source" / names[-1]).write_text(
            f'<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet><DataSet index="0" file="{piece}"/>'
            "</vtkMultiBlockDataSet></VTKFile>")
    source = write_pvd(tmp_path / "source/run.pvd", names)
    imported(source, tmp_path / "a.ciel", tmp_path)
    os.utime(tmp_path / "source" / name.format(step=2), (0, 0))
    assert run("import", tmp_path / "a.ciel", "--step", "1", cache=tmp_path).returncode == 0
    changed = run("import", tmp_path / "a.ciel", "--step", "2", cache=tmp_path)
    assert changed.returncode == 1 and "since it was imported" in changed.stderr


def test_a_file_that_was_missing_at_the_import_is_read_when_it_is_there(source, tmp_path):
    (source.parent / "2.vts").rename(tmp_path / "2.vts")
    imported(source, tmp_path / "a.ciel", tmp_path)
    missing = run("import", tmp_path / "a.ciel", "--step", "2", cache=tmp_path)
    assert missing.returncode == 1 and "does not exist" in missing.stderr
    (tmp_path / "2.vts").rename(source.parent / "2.vts")
    assert run("import", tmp_path / "a.ciel", "--step", "2", cache=tmp_path).returncode == 0


def test_a_dataset_of_the_first_format_of_late_steps_is_read_on(source, tmp_path):
    """Without `files` and `mesh`, the time of the source counts and the mesh is matched again."""
    imported(source, tmp_path / "a.ciel", tmp_path)
    attributes = tmp_path / "a.ciel/.zattrs"
    document = json.loads(attributes.read_text())
    for member in ("files", "mesh"):
        del document["ciel"]["late"][member]
    attributes.write_text(json.dumps(document))
    assert run("import", tmp_path / "a.ciel", "--step", "2", cache=tmp_path).returncode == 0
    os.utime(source, (source.stat().st_mtime + 5,) * 2)
    changed = run("import", tmp_path / "a.ciel", "--step", "3", cache=tmp_path)
    assert changed.returncode == 1 and "since it was imported" in changed.stderr


@pytest.mark.parametrize("arguments", [["--step", "x"], ["--step", "-1"], ["--step", "1", "-o", "b.ciel"], ["--all", "--force"],
                                       ["--all", "-a", "f"], ["--step", "1", "--no-weld"], ["--all", "--weld"], ["--all", "--list"],
                                       ["--all", "--plot3d", "big"]])
def test_wrong_use_is_told(source, tmp_path, arguments):
    imported(source, tmp_path / "a.ciel", tmp_path)
    assert run("import", tmp_path / "a.ciel", *arguments, cache=tmp_path).returncode == 2
    assert run("import", source, "-o", tmp_path / "b.ciel", "--step", "1", cache=tmp_path).returncode == 2
    unknown = run("import", tmp_path / "a.ciel", "--step", "99", cache=tmp_path)
    assert unknown.returncode == 1 and "there is no step 99" in unknown.stderr
    rewritten = run("import", tmp_path / "a.ciel", "-o", tmp_path / "c.ciel", cache=tmp_path)
    assert rewritten.returncode == 1 and "have not been read from their source" in rewritten.stderr


def test_a_full_disk_leaves_the_step_late(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    full = subprocess.run(["bash", "-c", 'ulimit -f 1; trap "" XFSZ; exec "$0" "$@"', os.environ.get("CIEL_BINARY", "build/ciel"),
                           "import", tmp_path / "a.ciel", "--step", "2"], capture_output=True, text=True,
                          env={**os.environ, "XDG_CACHE_HOME": str(tmp_path)})
    assert full.returncode != 0
    assert run("info", tmp_path / "a.ciel", cache=tmp_path).returncode == 0
    assert run("import", tmp_path / "a.ciel", "--step", "2", cache=tmp_path).returncode == 0
    assert Dataset(tmp_path / "a.ciel").array("f")[2].max() == pytest.approx(5.5)


def test_two_that_need_the_same_step_read_it_once_each_and_agree(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    ends = []
    both = [threading.Thread(target=lambda: ends.append(run("import", tmp_path / "a.ciel", "--all", cache=tmp_path).returncode))
            for _ in range(2)]
    for one in both:
        one.start()
    for one in both:
        one.join()
    assert ends == [0, 0]
    assert written(tmp_path / "a.ciel") == list(range(STEPS))
    assert run("info", tmp_path / "a.ciel", cache=tmp_path).returncode == 0


def test_extract_reads_the_step_that_it_needs(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    imported(source, tmp_path / "b.ciel", tmp_path, *WHOLE)
    for name in "ab":
        done = run("extract", tmp_path / f"{name}.ciel", "--iso", "f=4", "--time", "3", "-o", tmp_path / f"{name}.ply", cache=tmp_path)
        assert done.returncode == 0, done.stderr
    assert (tmp_path / "a.ply").read_bytes() == (tmp_path / "b.ply").read_bytes()
    assert written(tmp_path / "a.ciel") == [0, 3, 5]


def test_a_late_step_is_read_only_if_its_values_are_needed(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    picture = ["render", tmp_path / "a.ciel", "--time", "3", "--size", "64x64", "-o", tmp_path / "a.png"]
    assert run(*picture, "--slice", "x=0.5", cache=tmp_path).returncode == 0
    assert run("extract", tmp_path / "a.ciel", "--time", "3", "--slice", "x=0.5", "-o", tmp_path / "a.ply", cache=tmp_path).returncode == 0
    assert written(tmp_path / "a.ciel") == [0, 5], "a slice of one color needs no value"
    colored = ["extract", tmp_path / "a.ciel", "--time", "2", "--slice", "x=0.5", "--color", "f", "-o", tmp_path / "a.vtp"]
    assert run(*colored, cache=tmp_path).returncode == 0
    assert written(tmp_path / "a.ciel") == [0, 2, 5]
    assert run(*picture, "--slice", "x=0.5", "--color", "f", cache=tmp_path).returncode == 0
    assert written(tmp_path / "a.ciel") == [0, 2, 3, 5]


def scene_at(time: float) -> dict:
    return {"dataset": "a", "time": time, "layers": {"iso": {"type": "iso", "array": "f", "values": [4]}}}


def answer_of(server, method: str, **params) -> dict:
    return requests.post(server.base + "/rpc", timeout=PATIENCE, headers={"Authorization": f"Bearer {server.token}"},
                         json={"jsonrpc": "2.0", "id": 1, "method": method, "params": params}).json()


def serve(dataset, tmp_path):
    return Server(dataset, "--data-dir", tmp_path / "cache")


def test_a_picture_waits_for_its_step_and_the_next_ones_are_read_ahead(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    imported(source, tmp_path / "b.ciel", tmp_path, *WHOLE)
    with serve(tmp_path / "a.ciel", tmp_path) as server, Server(tmp_path / "b.ciel") as whole:
        size = {"width": 200, "height": 150}
        picture = server.call("picture.render", scene=scene_at(1), **size)["data"]
        assert picture == whole.call("picture.render", scene={**scene_at(1), "dataset": "b"}, **size)["data"]
        until(lambda: written(tmp_path / "a.ciel") == [0, 1, 2, 3, 5])
        there = [0.5, 0.5, 0.5]
        probed = server.call("probe.point", scene=scene_at(4), position=there)
        assert probed == whole.call("probe.point", scene={**scene_at(4), "dataset": "b"}, position=there)
        histogram = server.call("dataset.histogram", dataset="a", array="f", time=4, bins=16)
        assert histogram == whole.call("dataset.histogram", dataset="b", array="f", time=4, bins=16)


def test_late_steps_have_the_limits_of_the_server(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    with Server(tmp_path / "a.ciel", "--data-dir", tmp_path / "cache", "--limit-import-memory-bytes", "8M") as server:
        answer = answer_of(server, "picture.render", scene=scene_at(2), width=64, height=48)
        assert "raise the limit with --limit-import-memory-bytes" in str(answer), answer


def test_the_description_counts_the_steps_that_have_not_been_read(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    with serve(tmp_path / "a.ciel", tmp_path) as server:
        described = server.call("dataset.describe", dataset="a")
        assert described["unread_steps"] == STEPS - 2
        ranges = {array["name"]: array["range"] for array in described["arrays"]}
        for time in range(STEPS):
            server.call("picture.render", scene=scene_at(time), width=64, height=48)
        until(lambda: "unread_steps" not in server.call("dataset.describe", dataset="a"))
        assert {array["name"]: array["range"] for array in server.call("dataset.describe", dataset="a")["arrays"]} == ranges


def test_a_view_is_drawn_when_its_step_has_been_read(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)

    async def watch(server):
        async with client(server) as caller:
            session = (await caller.call("session.open", scene=scene_at(0)))["session"]
            await caller.call("view.open", session=session, width=160, height=120, stream="geometry")
            await caller.frame(1)
            revision = (await caller.call("scene.patch", session=session, patch={"time": 2}))["revision"]
            while (frame := await caller.frame(revision)).triangles == 0:
                pass
            return frame.time

    with serve(tmp_path / "a.ciel", tmp_path) as server:
        assert asyncio.run(watch(server)) == 2


def test_a_step_that_cannot_be_read_is_told_and_the_server_goes_on(source, tmp_path):
    imported(source, tmp_path / "a.ciel", tmp_path)
    shutil.move(source, tmp_path / "elsewhere")
    with serve(tmp_path / "a.ciel", tmp_path) as server:
        answer = answer_of(server, "picture.render", scene=scene_at(1), width=64, height=48)
        assert "result" in answer, answer
        assert any("cannot be read from its source" in remark for remark in answer["result"]["remarks"])
        assert str(tmp_path) not in json.dumps(answer), "clients do not learn paths of the server"
        assert "result" in answer_of(server, "picture.render", scene=scene_at(5), width=64, height=48)


def test_a_dataset_that_cannot_be_written_to_is_completed_elsewhere(source, tmp_path):
    if os.getuid() != 0:
        pytest.skip("needs root to serve as another user")
    imported(source, tmp_path / "a.ciel", tmp_path)
    for path in [tmp_path, *tmp_path.rglob("*")]:
        path.chmod(0o755 if path.is_dir() else 0o644)
    for parent in tmp_path.parents:
        if parent != pathlib.Path("/tmp") and parent != pathlib.Path("/"):
            parent.chmod(0o755)
    cache = tmp_path / "cache"
    cache.mkdir()
    os.chown(cache, 65534, 65534)
    with Server(tmp_path / "a.ciel", "--data-dir", cache, user=65534) as server:
        answer = answer_of(server, "picture.render", scene=scene_at(2), width=64, height=48)
        assert "result" in answer and answer["result"]["remarks"] == [], answer
    assert written(tmp_path / "a.ciel") == [0, 5]
    assert list((cache / "late").rglob("f/2.0"))
