"""Malformed inputs give one line that names the file and the defect, exit code 1, and no files beside the target."""

import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import zipfile

import numpy as np
import pytest
import vtk
from import_support import Dataset, run_import
from openfoam_files import write_case
from program import CIEL
from test_import_plot3d import write_pair
from vtk_files import CUBE, CUBE_FACES, add_array, image, mixed, structured, unstructured, with_fields, write

GOOD = vtk.vtkXMLUnstructuredGridWriter


def vtu(folder, data=None, mode=0):
    return write(GOOD(), folder / "a.vtu", data or with_fields(mixed()), SetDataMode=mode)


def edit(file, pattern, replacement):
    text = file.read_text()
    changed = re.sub(pattern, replacement, text, count=1, flags=re.S)
    assert changed != text, f"{pattern} is not in {file}"
    file.write_text(changed)
    return file


def array_of(name):
    return r'(<DataArray[^>]*Name="' + name + r'"[^>]*>\s*)[-\d]+'


def cut(file, share=0.5):
    data = file.read_bytes()
    file.write_bytes(data[: int(len(data) * share)])
    return file


def text(folder, name, content):
    (folder / name).write_text(content)
    return folder / name


def binary(folder, name, content):
    (folder / name).write_bytes(content)
    return folder / name


def folder(parent, name, document):
    (parent / name).mkdir()
    (parent / name / document).write_text("{}")
    return parent / name


def open_box(folder):
    faces = CUBE_FACES[:-1]  # without the sixth face
    return write(GOOD(), folder / "a.vtu", unstructured([(vtk.VTK_POLYHEDRON, faces)], CUBE))


def with_nan(folder):
    points = [list(p) for p in CUBE]
    points[3][1] = float("nan")
    return write(GOOD(), folder / "a.vtu", unstructured([(vtk.VTK_HEXAHEDRON, list(range(8)))], points), SetDataMode=2)


def zipped(folder):
    with zipfile.ZipFile(folder / "a.vtu", "w") as archive:
        archive.writestr("a.txt", "nothing")
    return folder / "a.vtu"


def directory(folder):
    (folder / "empty").mkdir()
    return folder / "empty"


def pvd(folder, *files):
    rows = "".join(f'<DataSet timestep="{t}" file="{f}"/>' for t, f in enumerate(files))
    return text(folder, "a.pvd", f'<VTKFile type="Collection"><Collection>{rows}</Collection></VTKFile>')


def legacy(folder, body):
    return text(folder, "a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n" + body)


def surface_only(folder):
    return write(GOOD(), folder / "a.vtu", unstructured([(vtk.VTK_QUAD, [0, 1, 2, 3])], CUBE))


def short_array(folder):
    grid = with_fields(mixed())
    add_array(grid.GetPointData(), "short", [1.0, 2.0])
    return write(GOOD(), folder / "a.vtu", grid, SetDataMode=0)


def huge_dimensions(folder):
    return binary(folder, "a.xyz", struct.pack(">3i", 2**31 - 1, 2**31 - 1, 2**31 - 1) + bytes(1000))


def numbers(tag, value):
    """Pattern and replacement that set an attribute of a VTK XML file to a wrong value."""
    return rf'{tag}="[^"]*"', f'{tag}="{value}"'


def edit_bytes(file, pattern, replacement):
    """Like edit(), for files that contain binary data."""
    data = file.read_bytes()
    changed = re.sub(pattern.encode(), replacement.encode(), data, count=1)
    assert changed != data, f"{pattern} is not in {file}"
    file.write_bytes(changed)
    return file


def binary_legacy(folder, body):
    return binary(folder, "a.vtk", b"# vtk DataFile Version 3.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\n" + body)


def ensight(folder, nodes):
    text(folder, "a.geo", f"a\nb\nnode id assign\nelement id assign\npart\n1\nc\ncoordinates\n{nodes}\n0.0\n0.0\n")
    return text(folder, "a.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\n")


HUGE = 5_000_000_000

# Name, function that makes the input, text of the error.
MALFORMED = [
    ("missing", lambda f: f / "not there.vtu", "no such file"),
    ("that cannot be examined", lambda f: f / ("n" * 300 + ".vtu"), "cannot be examined: File name too long"),
    ("empty", lambda f: text(f, "a.vtu", ""), "is empty"),
    ("a directory", directory, "is a directory"),
    ("a zip", zipped, "content of another format"),
    ("text called vtu", lambda f: text(f, "a.vtu", "hello\n"), "content of another format"),
    ("unknown format", lambda f: text(f, "a.doc", "hello, world\n"), "has an unknown format"),
    ("binary garbage", lambda f: binary(f, "a.vtk", bytes(range(256)) * 64), "content of another format"),
    ("garbage without extension", lambda f: binary(f, "a", np.random.default_rng(1).bytes(5000)), "has an unknown format"),
    ("truncated vtu", lambda f: cut(vtu(f)), ""),
    ("truncated appended vtu", lambda f: cut(vtu(f, mode=2), 0.8), ""),
    ("vtu of surfaces", lambda f: surface_only(f), "surface"),
    ("vtu with no cells", lambda f: vtu(f, unstructured([], CUBE)), "no cells"),
    ("polydata", lambda f: text(f, "a.vtu", '<VTKFile type="PolyData"></VTKFile>'), "no volume mesh"),
    ("connectivity out of range", lambda f: edit(vtu(f), array_of("connectivity"), r"\g<1>4711"), "uses point 4711"),
    ("negative connectivity", lambda f: edit(vtu(f), array_of("connectivity"), r"\g<1>-3"), "uses point -3"),
    ("offsets not rising", lambda f: edit(vtu(f), array_of("offsets"), r"\g<1>900"), ""),
    ("face list out of range", lambda f: edit(vtu(f), array_of("faces"), r"\g<1>800"), ""),
    ("wrong number of points", lambda f: edit(vtu(f), r'NumberOfPoints="16"', 'NumberOfPoints="1600"'), ""),
    ("wrong number of cells", lambda f: edit(vtu(f), r'NumberOfCells="5"', 'NumberOfCells="500000"'), ""),
    ("NaN coordinates", with_nan, "not a finite number"),
    ("open cell", open_box, "none of its 1 cells"),
    ("legacy without cells", lambda f: legacy(f, "POINTS 1 float\n0 0 0\n"), "no cells"),
    ("legacy out of range", lambda f: legacy(f, "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 9\nCELL_TYPES 1\n10\n"), "uses point 9"),
    ("legacy cut in the points", lambda f: legacy(f, "POINTS 400 float\n0 0 0 1 0 0\n"), ""),
    ("legacy with too few nodes", lambda f: legacy(f, "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n"), "cell type is 4"),
    ("legacy with more cells than bytes", lambda f: legacy(f, f"POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 {HUGE}\n4 0 1 2 3\n"), f'declares "cells 1 {HUGE}"'),
    ("legacy with more points than bytes", lambda f: legacy(f, f"POINTS {HUGE} float\n0 0 0\n"), f'declares "points {HUGE} float"'),
    ("legacy with a negative count", lambda f: legacy(f, "POINTS -4 float\n0 0 0\n"), "a negative number"),
    ("binary legacy with more cell types than bytes", lambda f: binary_legacy(f, b"POINTS 1 float\n" + bytes(12) + f"\nCELL_TYPES {HUGE}\n".encode()), f'declares "cell_types {HUGE}"'),
    ("legacy field longer than the file", lambda f: legacy(f, f"FIELD FieldData 1\na 3 {HUGE} float\n1 2 3\n"), f'declares "a 3 {HUGE} float"'),
    ("a series naming such a file", lambda f: (legacy(f, f"POINTS {HUGE} float\n0 0 0\n"), text(f, "a.vtk.series", '{"file-series-version": "1.0", "files": [{"name": "a.vtk"}]}'))[-1], "declares"),
    ("structured points of impossible size", lambda f: text(f, "a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 100000 100000 100000\nORIGIN 0 0 0\nSPACING 1 1 1\n"), ""),
    ("appended vtu with far too many cells", lambda f: edit_bytes(vtu(f, mode=2), *numbers("NumberOfCells", HUGE)), ""),
    ("appended vtu with far too many points", lambda f: edit_bytes(vtu(f, mode=2), *numbers("NumberOfPoints", HUGE)), ""),
    ("vtu with far too many points", lambda f: edit(vtu(f), *numbers("NumberOfPoints", HUGE)), ""),
    ("vtu with far too many cells", lambda f: edit(vtu(f), *numbers("NumberOfCells", HUGE)), ""),
    ("vti of impossible size", lambda f: text(f, "a.vti", '<VTKFile type="ImageData"><ImageData WholeExtent="0 100000 0 100000 0 100000" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 100000 0 100000 0 100000"/></ImageData></VTKFile>'), ""),
    ("EnSight with far too many nodes", lambda f: ensight(f, 2_000_000_000), ""),
    ("Fluent with far too many nodes", lambda f: text(f, "a.cas", "(2 3)\n(10 (0 1 7fffffff 0))\n(10 (1 1 7fffffff 1 3)(\n0 0 0\n))\n(12 (0 1 7fffffff 0))\n(12 (1 1 7fffffff 1 4))\n(13 (0 1 7fffffff 0))\n"), ""),
    ("Tecplot with far too many nodes", lambda f: text(f, "a.tec", f'VARIABLES = "X", "Y", "Z"\nZONE N={HUGE}, E=1, F=FEPOINT, ET=BRICK\n0 0 0\n'), ""),
    ("pvd not XML", lambda f: text(f, "a.pvd", '<VTKFile type="Collection"><Coll'), "not well-formed"),
    ("pvd naming nothing", lambda f: pvd(f), "names no files"),
    ("pvd naming a missing file", lambda f: pvd(f, "gone.vtu"), "does not exist"),
    ("pvd naming itself", lambda f: pvd(f, "a.pvd"), "itself an index file"),
    ("pvd whose steps are all damaged", lambda f: (cut(vtu(f)), pvd(f, "a.vtu", "gone.vtu"))[-1], "a.vtu"),
    ("pvd with a bad time", lambda f: (vtu(f), edit(pvd(f, "a.vtu"), 'timestep="0"', 'timestep="soon"'))[-1], "not a finite number"),
    ("series not JSON", lambda f: text(f, "a.series", '{"file-series-version": "1.0", "files": ['), "not well-formed JSON"),
    ("series without files", lambda f: text(f, "a.series", '{"file-series-version": "1.0", "files": {}}'), "file series"),
    ("series nested deeply", lambda f: text(f, "a.series", '{"file-series-version": "1.0", "files": ' + "[" * 100000), ""),
    ("series naming itself", lambda f: text(f, "a.series", '{"file-series-version": "1.0", "files": [{"name": "a.series"}]}'), "itself an index file"),
    ("pvtu naming a missing piece", lambda f: text(f, "a.pvtu", '<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid GhostLevel="0"><PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints><Piece Source="gone.vtu"/></PUnstructuredGrid></VTKFile>'), ""),
    ("vtm naming itself many times", lambda f: text(f, "a.vtm", '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>' + "".join(f'<DataSet index="{i}" file="a.vtm"/>' for i in range(40)) + "</vtkMultiBlockDataSet></VTKFile>"), ""),
    ("vtm naming a missing block", lambda f: text(f, "a.vtm", '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet><DataSet index="0" file="gone.vtu"/></vtkMultiBlockDataSet></VTKFile>'), ""),
    ("vts whose extent is a lie", lambda f: edit(write(vtk.vtkXMLStructuredGridWriter(), f / "a.vts", structured(), SetDataMode=0), r'WholeExtent="0 3 0 3 0 3"', 'WholeExtent="0 900 0 900 0 900"'), ""),
    ("PLOT3D cut short", lambda f: cut(write_pair(f)[0], 0.9), ""),
    ("PLOT3D of impossible size", huge_dimensions, ""),
    ("PLOT3D solution of another grid", lambda f: (write_pair(f)[0], text(f, "b.q", "2 2 2 " + "1.0 " * 44)), "does not belong"),
    ("HDF5 signature and nothing else", lambda f: binary(f, "a.hdf", b"\x89HDF\r\n\x1a\n" + bytes(100)), ""),
    ("CGNS signature and nothing else", lambda f: binary(f, "a.cgns", b"\x89HDF\r\n\x1a\n" + bytes(100)), ""),
    ("Exodus signature and nothing else", lambda f: binary(f, "a.ex2", b"CDF\x01" + bytes(50)), ""),
    ("EnSight without geometry", lambda f: text(f, "a.case", "FORMAT\ntype: ensight gold\nVARIABLE\n"), "has no section GEOMETRY"),
    ("an ADIOS2 folder", lambda f: folder(f, "a.bp", "md.0"), "is an ADIOS2"),
    ("an ADIOS2 file", lambda f: binary(f, "a.bp", b"ADIOS-BP v2"), "is an ADIOS2"),
    ("a Zarr folder", lambda f: folder(f, "a.zarr", ".zgroup"), "is a Zarr folder of another program"),
    ("convex point sets", lambda f: vtu(f, unstructured([(vtk.VTK_CONVEX_POINT_SET, list(range(8)))], CUBE)), "only convex point sets"),
    ("EnSight naming a missing model", lambda f: text(f, "a.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: gone.geo\n"), ""),
    ("LS-DYNA garbage", lambda f: binary(f, "d3plot", bytes(range(256)) * 8), ""),
    ("Fluent garbage", lambda f: text(f, "a.cas", "(10 (1 1 ffffffff 1 3)(\n"), ""),
    ("CONVERGE garbage", lambda f: binary(f, "a.h5", b"\x89HDF\r\n\x1a\n" + bytes(64)), ""),
    ("Tecplot cut short", lambda f: text(f, "a.tec", 'VARIABLES = "X", "Y", "Z"\nZONE N=8, E=1, F=FEPOINT, ET=BRICK\n0 0 0\n'), ""),
    ("foam file without a case", lambda f: text(f, "a.foam", ""), "content of another format"),
]


# VTK 9.3 reads beyond the end of the array, with unpredictable results. VTK 9.1 does not.
BY_LUCK = ["face list out of range"] if vtk.vtkVersion().GetVTKMinorVersion() >= 2 else []


@pytest.mark.parametrize("name, make, words", MALFORMED, ids=[row[0] for row in MALFORMED])
def test_one_clear_error(tmp_path, name, make, words):
    source = tmp_path / "source"
    source.mkdir()
    target = tmp_path / "target"
    target.mkdir()
    made = make(source)
    inputs = made if isinstance(made, tuple) else (made,)
    done = run_import(*inputs, "-o", target / "out.ciel", "--memory-limit", "8", "--time-limit", "60")
    assert done.returncode == 1, done.stdout + done.stderr  # a process killed by a signal has a negative code
    (line,) = done.stderr.splitlines()
    assert line.startswith("ciel: ") and str(source) in line, line
    assert words in line, line
    assert not any(target.iterdir())
    # Listing may not notice the damage.
    listed = run_import(*inputs, "--list", "--memory-limit", "8", "--time-limit", "60")
    if listed.returncode != 0:
        (line,) = listed.stderr.splitlines()
        assert listed.returncode == 1 and line.startswith("ciel: ") and str(source) in line, line
        assert words in line and (name in BY_LUCK or ("crashed" in line) == ("crashed" in done.stderr)), line


def test_the_good_neighbours_of_the_table_are_imported(tmp_path):
    """The undamaged inputs of the table are imported, so the damage causes the refusals."""
    for inputs in [(vtu(tmp_path),), (pvd(tmp_path, "a.vtu"),), write_pair(tmp_path)]:
        assert run_import(*inputs, "-o", tmp_path / "out.ciel", "--force").returncode == 0


def test_usage_errors_are_code_2(tmp_path):
    file = vtu(tmp_path)
    for arguments in [(file, "-o", ""), (file, "-o", "a.ciel", "--memory-limit", "nan"), (file, "-o", "a.ciel", "--time-limit", "-1")]:
        done = run_import(*arguments)
        assert done.returncode == 2 and len(done.stderr.splitlines()) == 1 and len(done.stderr) < 120, done.stderr
    for arguments in [(), (file,), (file, "-o", "name"), (file, "-o", "a.ciel", "--weld", "--no-weld"), (file, "--nonsense")]:
        assert run_import(*arguments).returncode == 2, arguments


def test_an_existing_dataset_is_not_touched_without_force(tmp_path):
    file = vtu(tmp_path)
    target = tmp_path / "out.ciel"
    assert run_import(file, "-o", target).returncode == 0
    before = (target / ".zattrs").read_bytes()
    done = run_import(file, "-o", target)
    assert done.returncode == 1 and "exists already" in done.stderr
    assert (target / ".zattrs").read_bytes() == before
    # A failing import with --force keeps the old dataset.
    assert run_import(cut(file), "-o", target, "--force").returncode == 1
    assert (target / ".zattrs").read_bytes() == before
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.vtu", "out.ciel"]


def boxes(bad, good):
    """`good` cubes, and `bad` ones without one face. Each has its own points."""
    points, cells = [], []
    for i in range(good + bad):
        faces = CUBE_FACES if i < good else CUBE_FACES[:-1]
        cells.append((vtk.VTK_POLYHEDRON, [[n + 8 * i for n in face] for face in faces]))
        points += [(x + 2 * i, y, z) for x, y, z in CUBE]
    return unstructured(cells, points)


def test_cells_that_cannot_be_used_are_named_and_counted(tmp_path):
    file = vtu(tmp_path, boxes(bad=2, good=10))
    done = run_import(file, "-o", tmp_path / "a.ciel")
    assert done.returncode == 3 and "2 of 12 cells were left out" in done.stderr
    assert "2 cells were left out: not closed (first ids: 10, 11)" in done.stdout
    assert run_import(file, "-o", tmp_path / "b.ciel", "--allow-bad").returncode == 0
    few = vtu(tmp_path, boxes(bad=1, good=1200))
    done = run_import(few, "-o", tmp_path / "c.ciel")
    assert done.returncode == 0 and "1 cell was left out" in done.stdout


def a_gone_file(folder):
    (folder / "b.vtu").unlink()


def half_a_file(folder):
    cut(folder / "b.vtu")


def a_mesh_without_closed_cells(folder):
    write(GOOD(), folder / "b.vtu", boxes(bad=1, good=0))


@pytest.mark.parametrize("place", [0, 1, 2])
@pytest.mark.parametrize("damage", [a_gone_file, half_a_file, a_mesh_without_closed_cells])
def test_a_bad_step_costs_that_step(tmp_path, damage, place):
    vtu(tmp_path)
    shutil.copy(tmp_path / "a.vtu", tmp_path / "b.vtu")
    damage(tmp_path)
    names = ["a.vtu", "a.vtu"]
    names.insert(place, "b.vtu")
    file = pvd(tmp_path, *names)
    done = run_import(file, "-o", tmp_path / "out.ciel")
    assert done.returncode == 3, done.stdout + done.stderr
    (line,) = done.stderr.splitlines()
    sentence = f"The step at time {place} could not be read and was left out: "
    assert str(file) in line and sentence in line and "--allow-bad accepts the loss" in line
    dataset = Dataset(tmp_path / "out.ciel")
    assert dataset.times == [time for time in (0, 1, 2) if time != place] and sentence in dataset.notes
    assert run_import(file, "-o", tmp_path / "out.ciel", "--force", "--allow-bad").returncode == 0


def pipe(path):
    path.unlink(missing_ok=True)
    os.mkfifo(path)
    return path


def pvtu_naming_a_pipe(folder):
    pipe(folder / "p.vtu")
    pieces = '<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints><Piece Source="p.vtu"/>'
    return text(folder, "a.pvtu", f'<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid GhostLevel="0">{pieces}</PUnstructuredGrid></VTKFile>')


def vtm_naming_a_pvtu(folder):
    pvtu_naming_a_pipe(folder)
    return text(folder, "a.vtm", '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
                '<DataSet index="0" file="a.pvtu"/></vtkMultiBlockDataSet></VTKFile>')


def case_with(name):
    def make(folder):
        case = write_case(folder / "case")
        pipe(case / name)
        return case

    return make


def plot3d_with_a_pipe(folder):
    grid, solution = write_pair(folder)
    return grid, pipe(solution)


def fluent_with_a_pipe(folder):
    pipe(folder / "a.dat")
    return text(folder, "a.cas", "(2 3)\n")


def ensight_with_a_pipe(name):
    def make(folder):
        pipe(folder / name)
        return text(folder, "a.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\nVARIABLE\nscalar per node: 1 p p****\n")

    return make


def lsdyna_with_a_pipe(folder):
    pipe(folder / "d3plot01")
    return text(folder, "d3plot", "x" * 4096)


@pytest.mark.parametrize("make", [
    lambda f: pipe(f / "a.vtu"), lambda f: (pipe(f / "p.vtu"), pvd(f, "p.vtu"))[1], pvtu_naming_a_pipe, vtm_naming_a_pvtu,
    case_with("constant/polyMesh/points"), case_with("1/p"), case_with("2/U"), case_with("system/controlDict"),
    plot3d_with_a_pipe, fluent_with_a_pipe, ensight_with_a_pipe("a.geo"), ensight_with_a_pipe("p0002"), lsdyna_with_a_pipe,
], ids=["itself", "pvd", "pvtu", "vtm", "points", "first step", "last step", "controlDict", "PLOT3D", "Fluent", "EnSight", "EnSight step",
        "LS-DYNA"])
def test_a_pipe_is_refused_and_not_waited_for(tmp_path, make):
    made = make(tmp_path)
    inputs = made if isinstance(made, tuple) else (made,)
    done = run_import(*inputs, "-o", tmp_path / "out.ciel", "--time-limit", "20")
    (line,) = done.stderr.splitlines()
    assert done.returncode == 1 and "is not a regular file but a pipe, a socket or a device" in line, line


MEMORY_WORDS = "GB was reached; raise the limit with --memory-limit"


def test_limits_end_in_a_sentence(tmp_path):
    file = write(vtk.vtkXMLImageDataWriter(), tmp_path / "a.vti", big_image())
    for option, words in [
        (("--memory-limit", "0.05"), MEMORY_WORDS),  # too little even for the reader's libraries
        (("--memory-limit", "0.2"), MEMORY_WORDS),
        (("--memory-limit", "0.3"), MEMORY_WORDS),
        (("--memory-limit", "0.36"), MEMORY_WORDS),
        (("--time-limit", "0.01"), "--time-limit"),
        (("--stall-limit", "0.001"), "--stall-limit"),
    ]:
        done = run_import(file, "-o", tmp_path / "a.ciel", *option)
        assert done.returncode == 1 and words in done.stderr, (option, done.stderr)
        assert len(done.stderr.splitlines()) == 1
        assert sorted(p.name for p in tmp_path.iterdir()) == ["a.vti"]


def test_limits_of_zero_are_none_and_the_defaults_are_told(tmp_path):
    file = vtu(tmp_path)
    none = ("--memory-limit", "0", "--time-limit", "0", "--stall-limit", "0")
    assert run_import(file, "-o", tmp_path / "a.ciel", *none).returncode == 0
    told = run_import("--help").stdout
    for option in none[::2]:
        assert option in told
    assert "four fifths" in told and "1800" in told and "no limit" in told


def test_who_is_killed_does_not_blame_the_file(tmp_path):
    """SIGKILL to the importer, as from the kernel when memory runs out."""
    file = write(vtk.vtkXMLImageDataWriter(), tmp_path / "a.vti", big_image())
    with subprocess.Popen([CIEL, "import", str(file), "-o", str(tmp_path / "a.ciel")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        process.stdout.readline()  # waits until the import has started
        children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        for child in children:
            os.kill(int(child), signal.SIGKILL)
        _, errors = process.communicate(timeout=60)
    assert children and process.returncode == 1
    (line,) = errors.splitlines()
    assert "killed from outside" in line and "memory" in line and "damaged" not in line
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.vti"]


@pytest.mark.parametrize(
    "output, words",
    [
        ("a.ciel", "out/a.ciel: exists already; --force replaces it"),
        ("photos.ciel", "out/photos.ciel: exists and is not a CIEL dataset"),
        ("file.ciel", "out/file.ciel: exists and is not a CIEL dataset"),
        ("nowhere/b.ciel", "out/nowhere/b.ciel: cannot be written: there is no folder"),
        ("file.ciel/b.ciel", "out/file.ciel/b.ciel: cannot be written: there is no folder"),
        ("/proc/b.ciel", "/proc/b.ciel: cannot be written: no file can be made in /proc"),
    ],
)
def test_an_output_that_cannot_be_written_is_refused_before_reading(tmp_path, output, words):
    out = tmp_path / "out"
    out.mkdir()
    assert run_import(vtu(tmp_path), "-o", out / "a.ciel").returncode == 0
    (out / "photos.ciel").mkdir()
    (out / "photos.ciel" / "dear.jpg").write_text("x")
    (out / "file.ciel").write_text("x")
    before = sorted(str(p) for p in tmp_path.rglob("*"))
    # The output path is checked first, so the damage is not reported.
    damaged = text(tmp_path, "damaged.vtu", "<VTKFile")
    force = () if output == "a.ciel" else ("--force",)
    done = run_import(damaged, "-o", out / output, *force)
    damaged.unlink()
    assert done.returncode == 1 and "%" not in done.stdout, done.stdout
    (line,) = done.stderr.splitlines()
    assert words in line and "damaged" not in line and line.startswith("ciel: /"), line
    assert sorted(str(p) for p in tmp_path.rglob("*")) == before


def test_an_unknown_array_is_told_before_reading(tmp_path):
    writer = vtk.vtkXMLImageDataWriter
    series = [write(writer(), tmp_path / f"{i}.vti", with_fields(image(origin=(i, 0, 0)))) for i in range(3)]
    index = pvd(tmp_path, *[file.name for file in series])
    legacy_file = write(vtk.vtkStructuredPointsWriter(), tmp_path / "a.vtk", with_fields(image()))
    for file in (series[0], index, legacy_file):
        done = run_import(file, "-o", tmp_path / "a.ciel", "--array", "f", "--array", "nope")
        assert done.returncode == 1 and 'no array "nope"; there are: c, cell:c, f, v' in done.stderr
        assert "building" not in done.stdout and "making" not in done.stdout
        if file is not legacy_file:  # the reader of legacy files lists nothing before it reads the whole file
            assert "%" not in done.stdout


def test_an_array_of_a_later_step_alone_may_be_asked_for(tmp_path):
    early, late = with_fields(image()), with_fields(image())
    add_array(late.GetPointData(), "late", np.arange(late.GetNumberOfPoints()))
    for suffix, writer in ((".vti", vtk.vtkXMLImageDataWriter), (".vtk", vtk.vtkStructuredPointsWriter)):
        for name, data in (("0", early), ("1", late)):
            write(writer(), tmp_path / (name + suffix), data)
        index = pvd(tmp_path, "0" + suffix, "1" + suffix)
        assert run_import(index, "-o", tmp_path / "a.ciel", "--array", "late", "--force").returncode == 0


def big_image():
    data = vtk.vtkImageData()
    data.SetDimensions(150, 150, 150)
    return data
