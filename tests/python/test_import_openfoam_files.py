"""Variants of OpenFOAM files, and the data that one bad file costs."""

import os
import pathlib
import re
import shutil
import tarfile

import numpy as np
import pytest
from import_support import imported, run_import
from openfoam_files import N, header, write_case, write_decomposed
from openfoam_rewriting import as_binary, compressed, copied, moved

UTM = (5e6, 4e5, 100)
DATA = pathlib.Path(os.environ.get("CIEL_DATA") or "/nowhere")
HALVES = [int(c % N >= N // 2) for c in range(N**3)]


def test_a_case_far_from_the_origin_loses_nothing(tmp_path):
    """At these coordinates float32 values are half a meter apart. The cells are a quarter of a meter wide."""
    dataset = imported(tmp_path, moved(write_case(tmp_path / "case"), UTM))
    assert dataset.volume() == pytest.approx(1, rel=1e-6)
    assert {name: len(faces) for name, faces in dataset.groups().items()} == {"inlet": 16, "outlet": 16, "walls": 64}
    walls = dataset.points_of(dataset.groups()["walls"])
    assert np.all(dataset.values("U")[walls] == 0)
    assert "negative" not in dataset.notes and "inwards" not in dataset.notes


@pytest.mark.skipif(not (DATA / "motorBike.tar.xz").is_file(), reason="CIEL_DATA does not name the folder with the real datasets")
def test_the_motorbike_far_from_the_origin(tmp_path):
    with tarfile.open(DATA / "motorBike.tar.xz") as files:
        files.extractall(tmp_path)
    here = tmp_path / "motorBike"
    there = moved(copied(here, tmp_path / "far"), UTM)
    a, b = imported(tmp_path / "motorBike", here), imported(tmp_path / "far", there)
    assert len(b.groups()) == 72 and b.counts() == a.counts() and b.volume() == pytest.approx(a.volume(), rel=1e-5)
    for name, faces in a.groups().items():
        np.testing.assert_array_equal(b.groups()[name], faces)
        of_wall = a.points_of(faces)
        for array in ("U", "p", "k"):
            np.testing.assert_allclose(b.values(array, 2)[of_wall], a.values(array, 2)[of_wall], rtol=1e-4, atol=1e-3)


@pytest.mark.parametrize(("label", "scalar"), [(32, 64), (64, 64), (32, 32)])
@pytest.mark.parametrize("pack", (False, True))
def test_binary_and_compressed_files_are_the_same(tmp_path, label, scalar, pack):
    text = imported(tmp_path, write_case(tmp_path / "text"))
    case = as_binary(write_case(tmp_path / "case"), label, scalar)
    other = imported(tmp_path / "case", compressed(case) if pack else case)
    assert other.counts() == text.counts() and other.times == text.times and other.units("U") == "m/s"
    for name in ("U", "p", "cell:U", "cell:p"):
        for step in (0, 1):
            np.testing.assert_allclose(other.values(name, step), text.values(name, step), rtol=1e-6)


def test_points_that_move_are_read_at_their_times(tmp_path):
    case = write_case(tmp_path / "case")
    (case / "2/polyMesh").mkdir()
    shutil.copy(case / "constant/polyMesh/points", case / "2/polyMesh/points")
    moved(case / "2", (0, 0, 0.125))
    dataset = imported(tmp_path, case)
    assert dataset.steps[1]["mesh"] == dataset.steps[0]["mesh"] == 0 and dataset.steps[1]["coordinates"] == 1
    first, second = dataset.positions(0, 0), dataset.positions(0, 1)
    np.testing.assert_allclose(second - first, np.tile([0, 0, 0.125], (len(first), 1)), atol=1e-6)


def test_nan_and_inf_in_text_are_values(tmp_path):
    case = write_case(tmp_path / "case")
    text = (case / "1/p").read_text().splitlines()
    begin = text.index("(") + 1
    text[begin], text[begin + 1] = "nan", "-inf"
    (case / "1/p").write_text("\n".join(text))
    dataset = imported(tmp_path, case)
    original = dataset.mesh()["original_cell"][:]
    cells = dataset.values("cell:p")
    assert np.isnan(cells[original == 0]).all() and np.isneginf(cells[original == 1]).all()
    assert np.isfinite(cells[original > 1]).all()


def test_macros_includes_and_patterns(tmp_path):
    case = write_case(tmp_path / "case")
    (case / "1/speeds").write_text("fast 5;\nslow (1 0 0);\n")
    (case / "1/U").write_text(
        header("volVectorField", "U") + '#include "speeds"\n#includeEtc "caseDicts/setConstraintTypes"\n'
        "dimensions [0 1 -1 0 0 0 0];\ninternalField uniform $slow;\n"
        'boundaryField\n{\n    inlet { type fixedValue; value uniform ($fast 0 0); }\n    "(out|in)let" { type calculated; value $internalField; }\n'
        "    solid { type noSlip; }\n}\n")
    boundary = case / "constant/polyMesh/boundary"
    boundary.write_text(boundary.read_text().replace("type wall;", "type wall; inGroups 1(solid);"))
    dataset = imported(tmp_path, case)
    at = {name: dataset.points_of(faces) for name, faces in dataset.groups().items()}
    u = dataset.values("U")
    assert np.all(u[at["walls"]] == 0)
    assert np.all(u[np.setdiff1d(at["inlet"], at["walls"])] == [5, 0, 0])
    assert np.all(u[np.setdiff1d(at["outlet"], at["walls"])] == [1, 0, 0])


@pytest.mark.parametrize(("line", "says"), [
    ("internalField uniform $nowhere;", "$nowhere is used before it is defined"),
    ("internalField #calc \"1 + 1\";", "#calc cannot be evaluated outside OpenFOAM"),
    ('#include "gone"\ninternalField uniform 1;', "includes gone, which does not exist"),
    ('#include "p"\ninternalField uniform 1;', "#include directives are nested too deep"),
    ("internalField uniform (1 2);", "has a uniform value with 2 numbers instead of 1,"),
    ("", "has no internalField"),
])
def test_what_cannot_be_evaluated_costs_the_field(tmp_path, line, says):
    case = write_case(tmp_path / "case")
    (case / "1/p").write_text(header("volScalarField", "p") + line + "\nboundaryField { }\n")
    dataset = imported(tmp_path, case, code=3)
    assert says in dataset.notes and "U" in dataset.steps[0]["arrays"] and "p" not in dataset.steps[0]["arrays"]


def test_other_components_at_one_time_cost_that_time(tmp_path):
    """The first time has other components than all later ones, so only the first time is left out."""
    case = write_case(tmp_path / "case")
    shutil.copytree(case / "2", case / "3")
    shutil.copy(case / "1/U", case / "1/p")
    dataset = imported(tmp_path, case, code=3)
    assert dataset.times == [1, 2, 3] and "p" not in dataset.steps[0]["arrays"] and "p" in dataset.steps[1]["arrays"]
    assert "has 3 components, but other times or processors have 1" in dataset.notes


def decomposed(tmp_path):
    write_decomposed(tmp_path / "case", HALVES, {})
    return tmp_path / "case"


def test_a_missing_processor_is_told(tmp_path):
    case = decomposed(tmp_path)
    shutil.rmtree(case / "processor1")
    dataset = imported(tmp_path, case, code=3)
    assert dataset.counts()["cells"] == N**3 / 2
    assert dataset.notes.count("The directory processor1 is missing: its part of the mesh was left out.") == 1
    shutil.rmtree(case / "processor0")
    done = run_import(case, "-o", tmp_path / "none.ciel")
    assert done.returncode == 1 and not (tmp_path / "none.ciel").exists()


def test_every_missing_processor_is_told(tmp_path):
    """A missing processor is reported even when no present processor is its neighbor."""
    write_decomposed(tmp_path / "case", [(0, 1, 3, 4)[c % N] for c in range(N**3)], {})
    for number in (1, 2, 3):
        shutil.rmtree(tmp_path / f"case/processor{number}")
    dataset = imported(tmp_path, tmp_path / "case", code=3)
    for number in (1, 2, 3):
        assert dataset.notes.count(f"The directory processor{number} is missing") == 1


def test_a_processor_without_the_first_is_told(tmp_path):
    case = decomposed(tmp_path)
    shutil.rmtree(case / "processor0")
    dataset = imported(tmp_path, case, code=3)
    assert dataset.counts()["cells"] == N**3 / 2 and "The directory processor0 is missing" in dataset.notes


def test_a_time_that_one_processor_lacks_is_told(tmp_path):
    case = decomposed(tmp_path)
    shutil.rmtree(case / "processor1/2")
    dataset = imported(tmp_path, case, code=3)
    assert dataset.times == [1, 2] and dataset.counts()["cells"] == N**3
    assert "There is no directory of processor1 at time 2: its cells have no values at that time." in dataset.notes
    assert np.isnan(dataset.values("cell:p", 1)).sum() == N**3 / 2 and np.isfinite(dataset.values("cell:p", 0)).all()


def test_a_field_file_that_one_processor_lacks_is_told(tmp_path):
    case = decomposed(tmp_path)
    (case / "processor1/2/p").unlink()
    (case / "processor0/1/p").write_text("")
    dataset = imported(tmp_path, case, code=3)
    assert "processor1/2/p: is missing" in dataset.notes and "processor0/1/p: " in dataset.notes
    for step in (0, 1):
        assert np.isnan(dataset.values("cell:p", step)).sum() == N**3 / 2 and np.isfinite(dataset.values("U", step)).all()


def test_a_mesh_that_one_processor_cannot_give_is_told(tmp_path):
    case = decomposed(tmp_path)
    (case / "processor1/constant/polyMesh/owner").write_text(header("labelList", "owner") + "3\n(0 0 0)\n")
    dataset = imported(tmp_path, case, code=3)
    assert dataset.counts()["cells"] == N**3 / 2
    assert "The part of processor1 could not be read and was left out: " in dataset.notes and "has 3 owners for" in dataset.notes


def test_processors_are_joined_by_their_patches(tmp_path):
    """Processors are joined by their patches, although the coordinates have different digits."""
    case = moved(decomposed(tmp_path), (0, 0, 0))
    moved(case / "processor1", (1e-6, 0, 0))
    dataset = imported(tmp_path, case)
    assert dataset.counts()["components"] == 1 and "joined along 16 faces" in dataset.notes
    moved(case / "processor1", (0.2, 0, 0))
    dataset = imported(tmp_path, case, "--force")
    assert dataset.counts()["components"] == 2 and "16 faces of no patch have no counterpart" in dataset.notes


def test_a_truncated_compressed_file_costs_itself(tmp_path):
    case = compressed(write_case(tmp_path / "case"))
    packed = case / "1/p.gz"
    packed.write_bytes(packed.read_bytes()[:-40])
    dataset = imported(tmp_path, case, code=3)
    assert "1/p.gz: is damaged: its compressed data ends too early or is wrong" in dataset.notes
    assert "p" in dataset.steps[1]["arrays"]


@pytest.mark.parametrize(("file", "damage", "says"), [
    ("points", lambda text: text[:400], "ends too early"),
    ("faces", lambda text: re.sub(r"\n4\(", "\n7(", text, count=1), "has no whole number where a whole number is needed"),
    ("owner", lambda text: text.replace("\n(\n0\n", "\n(\n-7\n"), "contains cell -7"),
    ("owner", lambda text: text.replace("\n(\n0\n", "\n(\n99999\n"), "contains more cells than the mesh has faces"),
    ("boundary", lambda text: text.replace("nFaces 64", "nFaces 640"), "patch walls has faces that are not on the boundary"),
    ("neighbour", lambda text: text.replace("FoamFile", "FoamFil"), "has no whole number where a whole number is needed"),
])
def test_a_damaged_mesh_is_a_sentence(tmp_path, file, damage, says):
    case = write_case(tmp_path / "case")
    path = case / "constant/polyMesh" / file
    path.write_text(damage(path.read_text()))
    done = run_import(case, "-o", tmp_path / "out.ciel")
    assert done.returncode == 1 and len(done.stderr.strip().splitlines()) == 1
    assert says in done.stderr and f"polyMesh/{file}: " in done.stderr and not (tmp_path / "out.ciel").exists()


def test_fields_within_cells_alone_are_read(tmp_path):
    """volScalarField::Internal has no boundary values. A symmetric tensor keeps the order of its components."""
    case = write_case(tmp_path / "case")
    rows = "\n".join(f"({i} 1 2 3 4 5)" for i in range(N**3))
    (case / "1/G").write_text(header("volScalarField::Internal", "G") + "dimensions [0 2 -3 0 0 0 0];\nvalue uniform 3;\n")
    (case / "1/R").write_text(
        header("volSymmTensorField", "R") + f"dimensions [0 2 -2 0 0 0 0];\ninternalField nonuniform List<symmTensor>\n{N**3}\n(\n{rows}\n);\n"
        "boundaryField { }\n")
    dataset = imported(tmp_path, case)
    assert np.all(dataset.values("cell:G") == 3) and dataset.units("G") == "m^2/s^3"
    tensor = dataset.values("cell:R")
    np.testing.assert_array_equal(tensor[:, 0], dataset.mesh()["original_cell"][:])
    assert np.all(tensor[:, 1:] == [1, 2, 3, 4, 5])
