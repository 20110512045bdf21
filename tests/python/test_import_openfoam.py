"""OpenFOAM cases written as text: polyhedra, patches and the values at walls."""

import itertools
import re

import numpy as np
import pytest
from import_support import imported, run_import

N = 4  # cells along each side of the unit cube


def header(kind, name):
    return f"FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {kind};\n    object {name};\n}}\n"


def listing(rows):
    return f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)\n"


def mesh():
    """Faces as (owner, neighbour or patch, loop). One inner face is split in two, which makes two polyhedra."""
    point = lambda i, j, k: i + (N + 1) * (j + (N + 1) * k)
    cell = lambda i, j, k: i + N * (j + N * k)
    inner, outer = [], {"inlet": [], "outlet": [], "walls": []}
    for i, j, k in itertools.product(range(N), range(N), range(N)):
        here = (i, j, k)
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for side in (0, 1):
                at = list(here)
                at[axis] += side
                loop = []
                for du, dv in [(0, 0), (1, 0), (1, 1), (0, 1)]:
                    corner = list(at)
                    corner[u] += du
                    corner[v] += dv
                    loop.append(point(*corner))
                if side == 0:
                    loop.reverse()
                other = list(here)
                other[axis] += 1 if side else -1
                if 0 <= other[axis] < N:
                    if side:
                        inner.append((cell(*here), cell(*other), loop))
                else:
                    patch = ("inlet", "outlet")[side] if axis == 0 else "walls"
                    outer[patch].append((cell(*here), loop))
    owner, neighbour, loop = inner.pop(N)
    inner += [(owner, neighbour, [loop[0], loop[1], loop[2]]), (owner, neighbour, [loop[0], loop[2], loop[3]])]
    inner.sort(key=lambda face: face[:2])
    return inner, outer


def field(kind, name, dimensions, internal, patches):
    rows = "".join(f"    {p} {{ {entry} }}\n" for p, entry in patches.items())
    text = lambda v: "(" + " ".join(map(repr, map(float, v))) + ")" if np.ndim(v) else repr(float(v))
    values = listing([text(v) for v in internal])
    of = "vector" if kind == "volVectorField" else "scalar"
    return (
        header(kind, name)
        + f"dimensions {dimensions};\ninternalField nonuniform List<{of}>\n{values};\nboundaryField\n{{\n{rows}}}\n"
    )


def write_case(case):
    inner, outer = mesh()
    poly = case / "constant/polyMesh"
    poly.mkdir(parents=True)
    (case / "system").mkdir()
    (case / "system/controlDict").write_text(header("dictionary", "controlDict") + "startTime 0;\nendTime 2;\ndeltaT 1;\nwriteInterval 1;\n")
    points = [(i / N, j / N, k / N) for k in range(N + 1) for j in range(N + 1) for i in range(N + 1)]
    (poly / "points").write_text(header("vectorField", "points") + listing([f"({x} {y} {z})" for x, y, z in points]))
    loops = [loop for *_, loop in inner] + [loop for faces in outer.values() for _, loop in faces]
    (poly / "faces").write_text(header("faceList", "faces") + listing([f"{len(f)}({' '.join(map(str, f))})" for f in loops]))
    owners = [o for o, *_ in inner] + [o for faces in outer.values() for o, _ in faces]
    (poly / "owner").write_text(header("labelList", "owner") + listing([str(o) for o in owners]))
    (poly / "neighbour").write_text(header("labelList", "neighbour") + listing([str(n) for _, n, _ in inner]))
    start, rows = len(inner), []
    for name, faces in outer.items():
        kind = "wall" if name == "walls" else "patch"
        rows.append(f"{name} {{ type {kind}; nFaces {len(faces)}; startFace {start}; }}")
        start += len(faces)
    (poly / "boundary").write_text(header("polyBoundaryMesh", "boundary") + listing(rows))
    centres = np.array([((i + 0.5) / N, (j + 0.5) / N, (k + 0.5) / N) for k in range(N) for j in range(N) for i in range(N)])
    for time in (1, 2):
        folder = case / str(time)
        folder.mkdir()
        speed = np.zeros((N**3, 3))
        speed[:, 0] = time * centres[:, 1] * (1 - centres[:, 1])
        (folder / "U").write_text(
            field("volVectorField", "U", "[0 1 -1 0 0 0 0]", speed, {
                "inlet": "type fixedValue; value uniform (5 0 0);",
                "outlet": "type zeroGradient;",
                "walls": "type noSlip;",
            }))
        (folder / "p").write_text(
            field("volScalarField", "p", "[1 -1 -2 0 0 0 0]", time + centres[:, 0], {
                "inlet": "type zeroGradient;", "outlet": "type fixedValue; value uniform 7;", "walls": "type zeroGradient;",
            }))
    (case / "a.foam").touch()
    return case


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
    dataset = imported(tmp_path, write_case(tmp_path / "case"))  # the directory itself
    groups = {name: dataset.points_of(faces) for name, faces in dataset.groups().items()}
    for step in (0, 1):
        u, p = dataset.values("U", step), dataset.values("p", step)
        assert np.all(u[groups["walls"]] == 0)  # where the inlet meets the wall, too
        only_inlet = np.setdiff1d(groups["inlet"], groups["walls"])
        np.testing.assert_array_equal(u[only_inlet], np.tile(np.float32([5, 0, 0]), (len(only_inlet), 1)))
        only_outlet = np.setdiff1d(groups["outlet"], groups["walls"])
        np.testing.assert_array_equal(p[only_outlet], 7)
        # Inside: linear, so exact.
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


def test_damaged_cases_end_in_a_sentence(tmp_path):
    for name, damage in [
        ("cut", lambda c: (c / "constant/polyMesh/faces").write_text((c / "constant/polyMesh/faces").read_text()[:900])),
        ("no points", lambda c: (c / "constant/polyMesh/points").unlink()),
        ("beyond", lambda c: (c / "constant/polyMesh/faces").write_text(
            re.sub(r"\n4\(\d+", "\n4(999999", (c / "constant/polyMesh/faces").read_text(), count=1))),
        ("short field", lambda c: (c / "1/p").write_text((c / "1/p").read_text().replace("64\n(", "9999\n("))),
    ]:
        case = write_case(tmp_path / name)
        damage(case)
        done = run_import(case, "-o", tmp_path / "out.ciel")
        assert done.returncode == 1, name
        assert len(done.stderr.strip().splitlines()) == 1 and done.stderr.startswith("ciel: "), done.stderr
        assert not list(tmp_path.glob("*.ciel*")) and not list(tmp_path.glob(".*"))
