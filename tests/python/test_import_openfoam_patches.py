"""Effects of OpenFOAM's patch types and boundary conditions on point values, and on the places where they are shown."""

import json

import numpy as np
from import_support import ciel_info, imported
from openfoam_block import Block, listed

EMPTY = {"bottom": "empty", "top": "empty"}


def stretched(points):
    """Stretches along x and y, so that a plain average of neighbors would be wrong."""
    return points**np.array([1.4, 0.7, 1]) * np.array([1, 1, 0.01])


def on(positions, axis, value):
    return np.abs(positions[:, axis] - value) < 1e-6


def patches_of(dataset):
    return {group["name"]: group for group in dataset.mesh().attrs["ciel"]["groups"]}


def test_a_layer_of_cells_is_interpolated_within_its_plane(tmp_path):
    block = Block((12, 10, 1), EMPTY, stretched)
    x = block.centers() @ [2, 3, 0]
    empty = {side: "type empty;" for side in EMPTY}
    case = block.write(tmp_path / "case", {"T": (x, {**empty, **{side: "type zeroGradient;" for side in ("left", "right", "front", "back")}})})
    dataset = imported(tmp_path, case)
    at, values = dataset.positions(), dataset.values("T")
    inside = ~(on(at, 0, 0) | on(at, 0, 1) | on(at, 1, 0) | on(at, 1, 1))
    np.testing.assert_allclose(values[inside], at[inside] @ [2, 3, 0], atol=2e-4)


def test_values_along_a_patch_are_exact_for_linear_ones(tmp_path):
    block = Block((6, 5, 4), place=lambda points: points ** np.array([1.4, 0.7, 1.2]))
    entries = {side: f"type fixedValue; {listed(block.face_centers(side) @ [1, 2, 3])}" for side in block.types}
    dataset = imported(tmp_path, block.write(tmp_path / "case", {"T": (block.centers() @ [1, 2, 3], entries)}))
    at, values = dataset.positions(), dataset.values("T")
    one_side = sum(on(at, axis, value).astype(int) for axis in range(3) for value in (0, 1)) == 1
    np.testing.assert_allclose(values[one_side], at[one_side] @ [1, 2, 3], atol=2e-5)


def test_vectors_lie_in_slip_walls_and_planes_of_symmetry(tmp_path):
    block = Block((4, 4, 4), {"front": "symmetryPlane", "right": "patch"})
    u = np.tile([1.0, 0.5, 0.25], (64, 1))
    entries = {
        "left": "type noSlip;", "right": "type zeroGradient;", "front": "type symmetryPlane;", "back": "type slip;",
        "bottom": "type slip;", "top": "type zeroGradient;",
    }
    dataset = imported(tmp_path, block.write(tmp_path / "case", {"U": (u, entries)}))
    at, values = dataset.positions(), dataset.values("U")
    left, right = on(at, 0, 0), on(at, 0, 1)
    planes, bottom = on(at, 1, 0) | on(at, 1, 1), on(at, 2, 0)
    assert np.all(values[left] == 0), "where a wall at rest meets a slip wall, the wall wins"
    alone = lambda where: values[where & ~left & ~right]
    assert np.all(np.abs(alone(planes)[:, 1]) < 1e-6) and np.all(np.abs(alone(bottom)[:, 2]) < 1e-6)
    np.testing.assert_allclose(alone(planes & ~bottom & ~on(at, 2, 1)), np.tile([1, 0, 0.25], (2 * 3 * 3, 1)), atol=1e-6)
    np.testing.assert_allclose(alone(planes & bottom), np.tile([1, 0, 0], (2 * 3, 1)), atol=1e-6)


def test_a_slip_wall_at_rest_is_no_wall(tmp_path):
    """One field that is zero at a slip wall must not make it a no-slip wall for other fields."""
    block = Block((4, 4, 4))
    u = np.where(block.centers()[:, 2:] > 0.5, [1.0, 0, 0], 0)
    entries = {side: "type slip;" for side in block.types}
    t = {side: "type zeroGradient;" for side in block.types} | {"left": "type fixedValue; value uniform 3;"}
    dataset = imported(tmp_path, block.write(tmp_path / "case", {"U": (u, entries), "T": (np.ones(64), t)}))
    at = dataset.positions()
    assert np.all(dataset.values("T")[on(at, 0, 0)] == 3), "also where it meets the bottom"


def test_types_and_conditions_are_stored_and_shown(tmp_path):
    block = Block((4, 4, 1), EMPTY)
    t = {"left": "type fixedValue; value uniform 1;", "right": "type zeroGradient;", "bottom": "type empty;", "top": "type empty;", "back": ""}
    dataset = imported(tmp_path, block.write(tmp_path / "case", {"T": (np.arange(16.0), t)}))
    patches = patches_of(dataset)
    assert patches["left"]["type"] == "wall" and patches["left"]["conditions"] == {"T": "fixedValue"}
    assert patches["top"]["type"] == "empty"
    text = ciel_info(dataset.path)
    assert "left              4 faces, wall: T fixedValue" in text and "16 faces, empty" in text
    told = {group["name"]: group for group in json.loads(ciel_info(dataset.path, "--json"))["groups"]}
    assert told["right"]["type"] == "wall" and told["right"]["conditions"] == {"T": "zeroGradient"}
    assert "The files of T name no boundary condition on front, back: the faces have the values of their cells." in dataset.notes


def test_a_wedge_is_no_wall_with_values(tmp_path):
    def sector(points):
        x, r, phi = points[:, 0] ** 1.4, 2 + points[:, 1] ** 0.7, np.radians(2.5) * (2 * points[:, 2] - 1)
        return np.column_stack([x, r * np.cos(phi), r * np.sin(phi)])

    block = Block((8, 8, 1), {"bottom": "wedge", "top": "wedge"}, sector)
    centers = block.centers()
    x = centers[:, 0] + 2 * np.hypot(centers[:, 1], centers[:, 2])
    entries = {side: "type zeroGradient;" for side in ("left", "right", "front", "back")} | {"bottom": "type wedge;", "top": "type wedge;"}
    dataset = imported(tmp_path, block.write(tmp_path / "case", {"T": (x, entries)}))
    at, values = dataset.positions(), dataset.values("T")
    r = np.hypot(at[:, 1], at[:, 2])
    inside = ~(on(at, 0, 0) | on(at, 0, 1)) & (r > 2.001) & (r < 2.999)
    np.testing.assert_allclose(values[inside], (at[:, 0] + 2 * r)[inside], atol=6e-3)
