"""LS-DYNA: a d3plot database written word by word after its manual (LS-DYNA Database Binary Output Files)."""

import numpy as np
import pytest
from import_support import imported
from vtk_files import hexahedra, linear

N = 2
END_OF_FILE = -999999.0
TIMES = (0.0, 0.5, 1.0)

# Indices of the control words.
NDIM, NUMNP, ICODE, NGLBV, IT, IU, IV = 15, 16, 17, 18, 19, 20, 21
NEL8, NUMMAT8, NV3D, MAXINT = 23, 24, 27, 36


def control_words(nodes, solids, parts, kind, deletion):
    words = np.zeros(64, dtype=kind)
    title = "a cube".ljust(10 * words.itemsize).encode()
    words.view("u1")[: len(title)] = np.frombuffer(title, dtype="u1")
    whole = words.view(f"{kind[0]}i{words.itemsize}")
    whole[11] = 1  # file type d3plot
    words[14] = 971.0
    for place, value in {NDIM: 4, NUMNP: nodes, ICODE: 6, NGLBV: 6 + 7 * parts, IT: 1, IU: 1, IV: 1,
                         NEL8: solids, NUMMAT8: parts, NV3D: 7, MAXINT: -10003 if deletion else 3}.items():
        whole[place] = value
    return words


def moved(points, time):
    return points * [1 + time, 1, 1]


def solids():
    """A cube of hexahedra (part 1). On its top: a pyramid, a wedge and a tetrahedron with repeated nodes (part 2)."""
    points, cells = hexahedra(N)
    first = len(points)
    points = np.vstack([points, [(0.25, 0.25, 1.5), (0.5, 0.25, 1.5), (1, 0.25, 1.5), (0.25, 0.75, 1.5)]])
    at = lambda x, y: int(np.flatnonzero(np.all(np.isclose(points, (x, y, 1)), axis=1))[0])
    corner, middle = at(0, 0), at(0.5, 0.5)
    rows = [*cells, [corner, at(0.5, 0), middle, at(0, 0.5)] + 4 * [first]]
    rows.append([at(0.5, 0), middle, at(1, 0.5), at(1, 0), first + 1, first + 1, first + 2, first + 2])
    rows.append([middle, at(0, 0.5), first] + 5 * [first + 3])
    return points, np.array(rows), np.array(len(cells) * [1] + 3 * [2])


def alive(time, cells):
    """Returns 1, or 0 for deleted elements: the first four per unit of time."""
    return (np.arange(cells) >= 4 * time).astype(float)


def states(points, rows, deletion):
    for time in TIMES:
        solid = np.zeros((len(rows), 7))  # six stresses and the effective plastic strain
        solid[:, 0] = linear(points[rows].mean(axis=1)) + time
        solid[:, 6] = time
        here = moved(points, time)
        state = [[time], np.zeros(6 + 7 * 2), here, linear(points) + time, here - points, solid]
        yield state + [alive(time, len(rows))] if deletion else state


def write_d3plot(folder, kind, states_per_file, deletion=False):
    points, rows, parts = solids()
    whole = f"{kind[0]}i{kind[-1]}"
    files = [[control_words(len(points), len(rows), 2, kind, deletion), points, np.column_stack([rows + 1, parts]).astype(whole)]]
    for i, state in enumerate(states(points, rows, deletion)):
        if i and i % states_per_file == 0:
            files.append([])
        files[-1] += state
    for i, words in enumerate(files):
        words = [np.asarray(w) if np.asarray(w).dtype == whole else np.asarray(w, dtype=kind) for w in [*words, [END_OF_FILE]]]
        (folder / f"d3plot{i or '':0>{2 if i else 0}}").write_bytes(b"".join(w.tobytes() for w in words))
    return folder / "d3plot"


@pytest.mark.parametrize("states_per_file", [3, 1], ids=["one file", "a family"])
@pytest.mark.parametrize("kind", ["<f4", ">f4", "<f8"])
def test_parts_fields_and_moving_nodes(tmp_path, kind, states_per_file):
    dataset = imported(tmp_path, write_d3plot(tmp_path, kind, states_per_file), "--weld")
    points, rows, parts = solids()
    assert dataset.cells() == {"hexahedron": N**3 + 1, "pyramid": 1, "tetrahedron": 1}
    assert dataset.counts()["components"] == 1 and dataset.counts()["vertices"] == len(points)
    assert dataset.times == list(TIMES)
    assert {name: len(ids) for name, ids in dataset.groups().items()} == {"Part1": N**3, "Part2": 3}
    assert dataset.volume() == pytest.approx(1 + 1 / 24 + 1 / 16 + 1 / 48)
    for step, time in enumerate(TIMES):
        at = dataset.steps[step]
        assert at.get("mesh", 0) == 0 and at.get("coordinates", 0) == step
        here = dataset.positions(coordinates=step)
        np.testing.assert_allclose(dataset.values("Temperature", step), linear(here / [1 + time, 1, 1]) + time, atol=1e-5)
        np.testing.assert_allclose(dataset.values("Velocity", step), here - here / [1 + time, 1, 1], atol=1e-6)
        np.testing.assert_allclose(dataset.values("cell:EffPlastStrn", step), time)
        original = dataset.mesh()["original_cell"][:]
        np.testing.assert_allclose(
            dataset.values("cell:Stress", step)[:, 0], linear(points[rows].mean(axis=1))[original] + time, atol=1e-5)
    assert here[:, 0].max() == pytest.approx(2)


def test_deleted_elements_are_gone_from_their_time_on(tmp_path):
    dataset = imported(tmp_path, write_d3plot(tmp_path, "<f4", 3, deletion=True), "--weld")
    total = N**3 + 3
    assert [dataset.counts(step.get("mesh", 0))["cells"] for step in dataset.steps] == [total, total - 2, total - 4]
    for step, time in enumerate(TIMES):
        position = dataset.positions(dataset.steps[step].get("mesh", 0))
        np.testing.assert_allclose(dataset.values("Temperature", step), linear(position / [1 + time, 1, 1]) + time, atol=1e-5)
