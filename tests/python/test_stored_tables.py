"""The ranges beside the chunks, and the table of steps, read by another program."""

import json
import os

import box_dataset
import numpy
import pytest
import vtk
import zarr
from program import ciel
from stored_blocks import cells_of, read_blocks
from stored_tables import read_ranges, read_steps, stretches_of
from vtk.util.numpy_support import numpy_to_vtk
from vtk_files import all_types, points_of, structured, with_fields, write

STEPS = 66
MISSING = numpy.array([0x7FF819C3C0000000], "<u8").view("<f8")[0]
SYMMETRIC = ("XX", "XY", "XZ", "YY", "YZ", "ZZ")


def run(*arguments, **environment):
    done = ciel(*arguments, env={**os.environ, **environment})
    assert done.returncode == 0, done.stderr


def fields(points):
    """Returns arrays with and without a magnitude, and with values that are not finite."""
    random = numpy.random.default_rng(7)
    beside_the_cubes = points[:, 0] < 0
    holes = numpy.where(beside_the_cubes, points[:, 1], numpy.nan)
    holes[numpy.flatnonzero(beside_the_cubes)[:3]] = [numpy.inf, -numpy.inf, MISSING]
    return {
        "real": points[:, 0].astype("f4"), "double": random.random(len(points)), "holes": holes,
        "pair": points[:, :2] + 0.1, "vector": (points / 7).astype("f4"), "plain": random.random((len(points), 4)).astype("f4"),
        "tensor": random.random((len(points), 6)), "constant": numpy.full(len(points), 2.5, "f4"), "none": numpy.full(len(points), numpy.nan),
    }


@pytest.fixture(scope="module")
def ranged(tmp_path_factory):
    folder = tmp_path_factory.mktemp("ranges")
    grid = with_fields(all_types())
    for name, values in fields(points_of(grid)).items():
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        for i, component in enumerate(SYMMETRIC if name == "tensor" else ()):
            array.SetComponentName(i, component)
        grid.GetPointData().AddArray(array)
    run("import", write(vtk.vtkXMLUnstructuredGridWriter(), folder / "a.vtu", grid), "-o", folder / "a.ciel")
    numpy.save(folder / "double.npy", numpy.where(points_of(grid)[:, 0] > 6, MISSING, 1e30 / 3 * points_of(grid)[:, 1]))
    run("append", folder / "a.ciel", "--time", 9, "--array", f"double={folder}/double.npy")
    return folder / "a.ciel"


def scalars_of(values, facts):
    """Returns the magnitude, if the array has one, and the components."""
    if values.ndim == 1:
        return [values]
    names = facts.get("component_names") or []
    weights = [2 if len(names) == 6 and name[0] != name[1] else 1 for name in names] or 1
    magnitude = numpy.sqrt((weights * values.astype("f8") ** 2).sum(axis=1)).astype(values.dtype)
    return [magnitude] * (values.shape[1] in (2, 3) or bool(names)) + list(values.T)


def check_limits(ranges, scalars, blocks):
    fits = True
    for lower, upper, without, values in zip(ranges["lower"], ranges["upper"], ranges["without"], scalars, strict=True):
        for b, block in enumerate(blocks):
            of_block = values[block.vertices]
            finite = of_block[numpy.isfinite(of_block)]
            assert without[b] == len(of_block) - len(finite)
            assert (lower[b], upper[b]) == (finite.min(), finite.max()) if len(finite) else lower[b] > upper[b]
            fits &= all(float(numpy.float32(limit)) == limit for limit in (lower[b], upper[b]))
    assert ranges["type"] == ("<f4" if fits else "<f8")


def check_histograms(histograms, scalars):
    for (lowest, highest, others, counts), values in zip(histograms, scalars, strict=True):
        finite = values[numpy.isfinite(values)].astype("f8")
        assert others == len(values) - len(finite) and sum(counts) == len(finite)
        if not len(finite) or finite.min() == finite.max():
            assert counts[0] == len(finite) and lowest == highest == (finite[0] if len(finite) else 0)
        else:
            assert (lowest, highest) == (finite.min(), finite.max())
            places = ((finite - lowest) / (highest - lowest) * 256).astype("i8")
            assert counts == numpy.bincount(numpy.minimum(places, 255), minlength=256).tolist()


def test_the_ranges_are_those_of_the_values(ranged):
    mesh = zarr.open_group(str(ranged), mode="r")["meshes/0"]
    _, _, blocks = read_blocks(ranged / "meshes/0/blocks")
    assert len(blocks) > 1
    types = {}
    for name, array in mesh["arrays"].arrays():
        facts = array.attrs["ciel"]
        for file in (ranged / "meshes/0/arrays" / name / "ranges").iterdir():
            ranges, scalars = read_ranges(file), scalars_of(array[int(file.name)], facts)
            check_limits(ranges, scalars, blocks if facts["association"] == "point" else [])
            check_histograms(ranges["histograms"], scalars)
            types[name, int(file.name)] = ranges["type"]
    assert types["double", 1] == "<f8" and types["real", 0] == types["vector", 0] == types["cell%3Ac", 0] == "<f4"
    ranges = read_ranges(ranged / "meshes/0/positions/ranges/0")
    check_limits(ranges, mesh["positions"][0].T, blocks)
    assert not ranges["histograms"]


def test_the_ranges_have_the_checksums_of_their_chunk(ranged):
    identity = json.loads((ranged / ".zattrs").read_text())["ciel"]["id"]
    files = list(ranged.glob("meshes/0/**/ranges/*"))
    arrays = {file.parents[1].name for file in files}
    assert arrays >= {"positions", "original_vertex", "original_cell", "double", "cell%3Ac"}
    longest = 0
    for file in files:
        chunk = next(file.parents[1].glob(f"{file.name}*")).read_bytes()
        ranges = read_ranges(file)
        assert ranges["id"] == identity and f"xxh3:{ranges['checksum']:016x}" == box_dataset.checksum(chunk)
        assert ranges["stretches"] == stretches_of(chunk)
        longest = max(longest, len(ranges["stretches"]))
    assert longest > 2


def test_the_table_has_the_steps_that_the_marker_had(tmp_path):
    box = box_dataset.write_box(tmp_path / "box.ciel", n=3, steps=63)
    numpy.save(tmp_path / "w.npy", [numpy.nan, numpy.inf, MISSING, *range(24)])
    numpy.save(tmp_path / "u.npy", numpy.random.default_rng(3).random((27, 3)))
    arrays = [option for name in "wu" for option in ("--array", f"cell:{name}={tmp_path}/{name}.npy")]
    run("append", box, "--time", 40, *arrays)
    before = json.loads((box / "steps.json").read_text())
    assert before["ciel_steps"] == 1 and len(before["steps"]) == 64
    run("append", box, "--time", 41, *arrays)
    run("append", box, "--time", 42, *arrays)
    after = json.loads((box / "steps.json").read_text())
    assert after["ciel_steps"] == 2 and [step["time"] for step in after["steps"]] == [42]
    for step in before["steps"]:
        for array in step["arrays"].values():
            array |= {"invalid": array.get("invalid", 0), "missing": array.get("missing", 0), "extremes": array.get("extremes", [])}
    steps = read_steps(box)
    assert len(steps) == after["table"]["steps"] == 65 and steps[:64] == before["steps"]
    of_w = steps[64]["arrays"]["cell:w"]
    assert (of_w["chunk"], of_w["invalid"], of_w["missing"], of_w["range"]) == (64, 2, 1, [0, 23])
    assert len(steps[64]["arrays"]["cell:u"]["extremes"]) == 4, "of the magnitude and of the components"


def write_series(folder, grids):
    rows = ""
    for step, grid in enumerate(grids):
        write(vtk.vtkXMLStructuredGridWriter(), folder / f"{step}.vts", grid)
        rows += f'<DataSet timestep="{step / 4}" part="0" file="{step}.vts"/>'
    (folder / "run.pvd").write_text(f'<?xml version="1.0"?>\n<VTKFile type="Collection"><Collection>{rows}</Collection></VTKFile>')
    return folder / "run.pvd"


def extremes_of(values, centers):
    ends = [(scalar.argmin(), scalar.argmax()) for scalar in values]
    return [{name: {"cell": end, "place": pytest.approx(centers[end])} for name, end in zip(("lowest", "highest"), pair)} for pair in ends]


def test_the_table_has_the_facts_of_the_chunks(tmp_path):
    """The mesh moves at step 20, and another one replaces it at step 50."""
    grids = [with_fields(structured(*(((3,), (3, 0.4), (4,))[(step >= 20) + (step >= 50)])), shift=step / 8) for step in range(STEPS)]
    run("import", write_series(tmp_path, grids), "-o", tmp_path / "a.ciel", "--all")
    group = zarr.open_group(str(tmp_path / "a.ciel"), mode="r")
    cells = [[cell for block in read_blocks(tmp_path / f"a.ciel/meshes/{mesh}/blocks")[2] for cell in cells_of(block)] for mesh in (0, 1)]
    corners = [{cell: sorted(set(numpy.concatenate(faces))) for cell, _, faces in of_mesh} for of_mesh in cells]
    steps = read_steps(tmp_path / "a.ciel")
    assert [(step["time"], step["mesh"], step["coordinates"]) for step in steps] == \
        [(step / 4, int(step >= 50), int(20 <= step < 50)) for step in range(STEPS)]
    for number, step in enumerate(steps):
        mesh = group[f"meshes/{step['mesh']}"]
        positions = mesh["positions"][step["coordinates"]]
        centers = [positions[corners[step["mesh"]][cell]].mean(axis=0) for cell in sorted(corners[step["mesh"]])]
        assert step["arrays"].keys() == {"c", "cell:c", "f", "v"}
        for name, facts in step["arrays"].items():
            array = mesh[f"arrays/{name.replace(':', '%3A')}"]
            values = array[facts["chunk"]]
            scalars = scalars_of(values, array.attrs["ciel"])
            ranges = [[scalar.min(), scalar.max()] for scalar in scalars]
            assert facts == {
                "chunk": number - 50 * step["mesh"], "invalid": 0, "missing": 0, "checksum": box_dataset.checksum(values.tobytes()),
                "range": ranges[0], "component_ranges": ranges[-len(values.T) if values.ndim > 1 else 0 :],
                "extremes": extremes_of(scalars, centers) if name == "cell:c" else []}


def test_the_table_tells_the_late_arrays(tmp_path):
    run("import", write_series(tmp_path, [with_fields(structured(3), shift=step) for step in range(STEPS)]), "-o", tmp_path / "a.ciel")
    steps = read_steps(tmp_path / "a.ciel")
    late = {"invalid": 0, "missing": 0, "extremes": [], "lazy": True}
    for number, step in enumerate(steps[1:-1], 1):
        assert list(step["arrays"].values()) == 4 * [{"chunk": number, **late}]
    assert all("lazy" not in array and "range" in array for number in (0, -1) for array in steps[number]["arrays"].values())
