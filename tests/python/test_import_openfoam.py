"""OpenFOAM cases: polyhedra, patches, values at walls, zones, decomposed cases."""

import re

import numpy as np
import pytest
from import_support import ciel_info, imported, run_import
from openfoam_files import (
    CENTERS,
    N,
    header,
    mesh,
    write_case,
    write_cell_zones,
    write_decomposed,
    write_face_zones,
    write_regions,
)


def test_polyhedra_patches_units_and_times(tmp_path):
    dataset = imported(tmp_path, write_case(tmp_path / "case") / "a.foam")
    assert dataset.counts()["cells"] == N**3 and dataset.input["vertices"] == (N + 1) ** 3
    assert dataset.cells() == {"hexahedron": N**3 - 2, "polyhedron": 2}
    assert dataset.counts()["faces"] == 3 * N * N * (N + 1) + 1
    assert dataset.times == [1, 2] and dataset.volume() == pytest.approx(1)
    assert {name: len(f) for name, f in dataset.groups().items()} == {"inlet": 16, "outlet": 16, "walls": 64}
    assert dataset.units("U") == "m/s" and dataset.units("cell:U") == "m/s" and dataset.units("p") == "Pa"
    assert dataset.facts["length_units"] == "m"


def test_points_on_patches_take_the_patches_values(tmp_path):
    dataset = imported(tmp_path, write_case(tmp_path / "case"))  # imports by the path of the case directory
    groups = {name: dataset.points_of(faces) for name, faces in dataset.groups().items()}
    for step in (0, 1):
        u, p = dataset.values("U", step), dataset.values("p", step)
        assert np.all(u[groups["walls"]] == 0)  # also where the inlet meets the wall
        only_inlet = np.setdiff1d(groups["inlet"], groups["walls"])
        np.testing.assert_array_equal(u[only_inlet], np.tile(np.float32([5, 0, 0]), (len(only_inlet), 1)))
        only_outlet = np.setdiff1d(groups["outlet"], groups["walls"])
        np.testing.assert_array_equal(p[only_outlet], 7)
        # Inside, the field is linear, so interpolation is exact.
        inside = np.setdiff1d(np.arange(len(p)), np.concatenate(list(groups.values())))
        np.testing.assert_allclose(p[inside], step + 1 + dataset.positions()[inside, 0], atol=1e-5)


def test_control_dict_names_the_case_too(tmp_path):
    case = write_case(tmp_path / "case")
    assert imported(tmp_path, case / "system/controlDict").counts()["cells"] == N**3


def test_an_array_that_a_time_lacks_is_not_written_there(tmp_path):
    case = write_case(tmp_path / "case")
    (case / "2/p").unlink()
    dataset = imported(tmp_path, case)
    assert "p" in dataset.steps[0]["arrays"] and "p" not in dataset.steps[1]["arrays"]


def test_an_array_is_looked_for_at_all_times_before_reading(tmp_path):
    case = write_case(tmp_path / "case")
    (case / "1/p").unlink()
    (case / "2/phi").write_text(header("surfaceScalarField", "phi"))
    assert imported(tmp_path, case, "--array", "p").array_names() == ["cell:p", "p", "patch:p"]
    done = run_import(case, "-o", tmp_path / "out.ciel", "--force", "--array", "T")
    assert done.returncode == 1 and 'no array "T"; there are: U, cell:U, cell:p, p' in done.stderr
    assert "%" not in done.stdout, "nothing was read"


def test_damaged_cases_end_in_a_sentence(tmp_path):
    for name, damage in [
        ("cut", lambda c: (c / "constant/polyMesh/faces").write_text((c / "constant/polyMesh/faces").read_text()[:900])),
        ("no points", lambda c: (c / "constant/polyMesh/points").unlink()),
        ("beyond", lambda c: (c / "constant/polyMesh/faces").write_text(
            re.sub(r"\n4\(\d+", "\n4(999999", (c / "constant/polyMesh/faces").read_text(), count=1))),
    ]:
        case = write_case(tmp_path / name)
        damage(case)
        done = run_import(case, "-o", tmp_path / "out.ciel")
        assert done.returncode == 1, name
        assert len(done.stderr.strip().splitlines()) == 1 and done.stderr.startswith("ciel: "), done.stderr
        assert not list(tmp_path.glob("*.ciel*")) and not list(tmp_path.glob(".*"))


def test_a_field_that_is_cut_short_costs_itself(tmp_path):
    case = write_case(tmp_path / "case")
    (case / "1/p").write_text((case / "1/p").read_text().replace("64\n(", "9999\n("))
    dataset = imported(tmp_path, case, code=3)
    assert dataset.times == [1, 2] and "p" not in dataset.steps[0]["arrays"] and "p" in dataset.steps[1]["arrays"]
    assert "The field p at time 1 could not be read and has no values: " in dataset.notes
    assert "1/p: has a list of 9999 items; the number must be between 0 and 64," in dataset.notes


ZONES = {"front": [c for c in range(N**3) if c % N < N // 2], "lid": list(range(N**3 - N * N, N**3))}


def zones_of(dataset):
    original = dataset.mesh()["original_cell"][:]
    names = {g["name"] for g in dataset.mesh().attrs["ciel"]["groups"] if g["of"] == "cells"}
    return {name: sorted(original[ids]) for name, ids in dataset.groups().items() if name in names}


def test_cell_zones_become_groups_of_cells(tmp_path):
    case = write_case(tmp_path / "case")
    write_cell_zones(case / "constant/polyMesh", ZONES)
    dataset = imported(tmp_path, case)
    assert zones_of(dataset) == ZONES
    assert dataset.counts()["cells"] == N**3 and dataset.input["cells"] == N**3
    assert set(dataset.groups()) == {"inlet", "outlet", "walls", "front", "lid"}


def test_face_zones_on_the_boundary_become_groups_and_leave_the_patches_their_values(tmp_path):
    case = write_case(tmp_path / "case")
    first = len(mesh()[0])  # in the list of boundary faces, those of the inlet come first
    write_face_zones(case / "constant/polyMesh", {"half": range(first, first + 8), "one": [first + 5], "inside": [0, 1, 2]})
    dataset = imported(tmp_path, case)
    groups = dataset.groups()
    assert {name: len(faces) for name, faces in groups.items()} == {"inlet": 16, "outlet": 16, "walls": 64, "half": 8, "one": 1}
    assert set(groups["half"]) < set(groups["inlet"])
    assert '3 faces of surface "inside" are not boundary faces' in dataset.notes
    only_inlet = np.setdiff1d(dataset.points_of(groups["inlet"]), dataset.points_of(groups["walls"]))
    np.testing.assert_array_equal(dataset.values("U")[only_inlet, 0], 5)


def in_order_of_place(dataset, name, step):
    """Point values, sorted by the points' positions."""
    position = np.round(dataset.positions() * N).astype(int)
    return dataset.values(name, step)[np.lexsort(position.T)]


def test_a_decomposed_case_is_the_whole_again(tmp_path):
    case = tmp_path / "case"
    processor = [(c % N >= N // 2) + 2 * (c // (N * N) >= N // 2) for c in range(N**3)]
    points = write_decomposed(case, processor, ZONES)
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
    dataset = imported(tmp_path / "a", case)
    whole = imported(tmp_path / "b", write_case(tmp_path / "whole"))
    assert dataset.input["vertices"] == points and dataset.input["cells"] == N**3
    assert dataset.counts() == whole.counts() and dataset.cells() == whole.cells()
    assert dataset.volume() == pytest.approx(1) and dataset.times == [1, 2]
    assert dataset.units("U") == "m/s" and "joined along 32 faces" in dataset.notes
    centers = np.concatenate([CENTERS[np.array(processor) == rank] for rank in range(4)])
    original = dataset.mesh()["original_cell"][:]
    for step in (0, 1):
        np.testing.assert_allclose(dataset.values("cell:p", step), step + 1 + centers[original, 0], atol=1e-6)
        for name in ("U", "p"):
            np.testing.assert_allclose(in_order_of_place(dataset, name, step), in_order_of_place(whole, name, step), atol=1e-6)
    groups = dataset.groups()
    assert {name: len(ids) for name, ids in groups.items()} == {
        "inlet": 16, "outlet": 16, "walls": 64, "front": len(ZONES["front"]), "lid": len(ZONES["lid"])
    }
    assert np.all(centers[original[groups["front"]], 0] < 0.5) and np.all(centers[original[groups["lid"]], 2] > 1 - 1 / N)


def test_baffles_of_a_decomposed_case_stay_open(tmp_path):
    """A wall inside the mesh, of faces between two processors. Both of its sides are patch faces, not processor faces."""
    write_decomposed(tmp_path / "case", [c % N >= N // 2 for c in range(N**3)], {}, baffle=(0, 1))
    dataset = imported(tmp_path, tmp_path / "case")
    assert "joined along 14 faces" in dataset.notes
    assert dataset.counts()["boundary_faces"] == 96 + 2 * 2
    assert len(dataset.groups()["walls"]) == 64 + 2 * 2


def test_pieces_that_were_not_welded_when_nothing_is_to_be(tmp_path):
    write_decomposed(tmp_path / "case", [c % N >= N // 2 for c in range(N**3)], {})
    dataset = imported(tmp_path, tmp_path / "case", "--no-weld")
    assert dataset.counts()["components"] == 2 and dataset.counts()["vertices"] == dataset.input["vertices"]


def test_regions_name_what_they_hold(tmp_path):
    case = write_regions(tmp_path / "case", {"air": 0, "metal": 1})
    dataset = imported(tmp_path, case)
    assert dataset.input["cells"] == 2 * N**3 and dataset.times == [1, 2] and dataset.volume() == pytest.approx(2)
    assert {name: len(ids) for name, ids in dataset.groups().items()} == {
        "air": N**3, "metal": N**3,
        "air/inlet": 16, "air/outlet": 16, "air/walls": 64, "metal/inlet": 16, "metal/outlet": 16, "metal/walls": 64,
        "air/core": 2, "metal/core": 2,
    }
    assert dataset.units("U") == "m/s"
    assert "  metal/outlet      16 faces" in ciel_info(dataset.path)


def test_pieces_are_read_where_they_have_the_results(tmp_path):
    """decomposePar keeps the whole mesh. A parallel solver writes its times into the processor folders only."""
    case = write_case(tmp_path / "case")
    processor = [c % N >= N // 2 for c in range(N**3)]
    write_decomposed(case, processor, {})
    assert "OpenFOAM case:" in imported(tmp_path, case).facts["source"]
    (case / "2").rename(tmp_path / "gone")
    dataset = imported(tmp_path, case, "--force")
    assert dataset.times == [1, 2] and dataset.counts()["cells"] == N**3 and dataset.counts()["components"] == 1
    assert "OpenFOAM case (decomposed):" in dataset.facts["source"]
    assert "The processor directories were read" in dataset.notes


def test_collated_pieces_are_refused_or_told(tmp_path):
    case = write_case(tmp_path / "case")
    (case / "processors4/7").mkdir(parents=True)
    dataset = imported(tmp_path, case)
    assert dataset.times == [1, 2] and "times in processors4 (collated files) were not read" in dataset.notes
    (case / "constant/polyMesh").rename(tmp_path / "gone")
    done = run_import(case, "-o", tmp_path / "b.ciel")
    assert done.returncode == 1 and "collated files (processors4)" in done.stderr
