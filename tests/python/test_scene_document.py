"""One scene with a clip, a volume, an iso-surface and a slice, by command line and by JSON-RPC. Compared with the analytic color
of each pixel's ray. The box is [-1, 1]^3, r the distance from its center; the view is parallel along y."""

import base64
import copy
import json
import shutil

import box_dataset
import numpy as np
import pytest
import requests
import vtk
from program import ciel
from serve_process import PATIENCE, Server
from vtk.util.numpy_support import vtk_to_numpy

SIZE, VIEW = 240, 3.0  # pixels and scene units along both sides of the picture
SLICE_Y, BALL = 0.5, 0.6  # y of the slice, and the iso-value of r
LEFT = 0.5  # share of the light that one unit of fog lets through
SCENE = {
    "dataset": "box", "background": "#003000",
    "camera": {"position": [0, -8, 0], "target": [0, 0, 0], "up": [0, 0, 1], "parallel": True, "parallel_height": VIEW},
    "annotations": {"legend": False, "triad": False}, "lighting": {"on": False},
    "layers": {
        "clip": {"type": "clip", "axis": "x", "value": 0.25},
        "slice": {"type": "slice", "axis": "y", "value": SLICE_Y, "color": {"solid": "#ff0000"}},
        "iso": {"type": "iso", "array": "r", "values": [BALL], "color": {"solid": "#0000ff"}},
        "fog": {"type": "volume", "array": "x", "shaded": False, "unit_length": 1,
                "color": {"points": [{"at": 0, "color": "#000000"}, {"at": 1, "color": "#000000"}]},
                "opacity_points": [[0, 1 - LEFT]]},
    },
}


def without(*layers):
    scene = copy.deepcopy(SCENE)
    for layer in layers:
        del scene["layers"][layer]
    return scene


def pixels_of(reader):
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)[::-1].astype(int)


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return box_dataset.write_box(tmp_path_factory.mktemp("box") / "box.ciel", 24)


@pytest.fixture(scope="module")
def by_command_line(box, tmp_path_factory):
    folder = tmp_path_factory.mktemp("pictures")

    def draw(scene):
        (folder / "scene.json").write_text(json.dumps(scene))
        result = ciel("render", box, "--scene", folder / "scene.json", "--size", f"{SIZE}x{SIZE}", "-o", folder / "p.png")
        assert result.returncode == 0, result.stderr
        reader = vtk.vtkPNGReader()
        reader.SetFileName(str(folder / "p.png"))
        return pixels_of(reader)

    return draw


@pytest.fixture(scope="module")
def server(box):
    with Server(box) as running:
        yield running


def png_of(answer):
    data = base64.b64decode(answer["data"])
    buffer = np.frombuffer(data, dtype=np.uint8).copy()
    reader = vtk.vtkPNGReader()
    reader.SetMemoryBuffer(buffer)
    reader.SetMemoryBufferLength(len(buffer))
    return pixels_of(reader)


def rays():
    """x and z of each pixel's ray."""
    at = ((np.arange(SIZE) + 0.5) / SIZE - 0.5) * VIEW
    return np.meshgrid(at, -at)


def expected(x, z, clip=0.25):
    """Expected color of each ray: that of the first surface, dimmed by the fog in front of it."""
    hit = np.hypot(x, z) < BALL
    ball = -np.sqrt(np.maximum(BALL**2 - x**2 - z**2, 0))
    left = LEFT ** np.where(hit, ball + 1, SLICE_Y + 1)
    inside = (np.abs(x) < 1) & (np.abs(z) < 1) & (x < clip)
    color = np.zeros((*x.shape, 3))
    color[..., 1] = np.where(inside, 0, 0x30)
    color[..., 0] = np.where(inside & ~hit, 255 * left, 0)
    color[..., 2] = np.where(inside & hit, 255 * left, 0)
    return color


def away_from_outlines(x, z, clip=0.25):
    """True for pixels away from outlines. The iso-surface of 24 cells differs from the sphere by some thousandths."""
    near = 2.5 * VIEW / SIZE
    return ((np.abs(np.hypot(x, z) - BALL) > near) & (np.abs(np.abs(x) - 1) > near) & (np.abs(np.abs(z) - 1) > near)
            & (np.abs(x - clip) > near))


def test_every_pixel_is_what_its_ray_meets(by_command_line):
    picture = by_command_line(SCENE)
    x, z = rays()
    counted = away_from_outlines(x, z)
    off = np.abs(picture - expected(x, z)).max(axis=2)
    assert counted.mean() > 0.85
    assert off[counted].max() <= 4
    assert off[counted].mean() < 1


def test_beyond_the_clip_is_background_and_before_it_the_unclipped_picture(by_command_line):
    clipped, whole = by_command_line(SCENE), by_command_line(without("clip"))
    x, z = rays()
    near = 2.5 * VIEW / SIZE
    assert (clipped[x > 0.25 + near] == [0, 0x30, 0]).all()
    kept = x < 0.25 - near
    assert np.abs(clipped - whole)[kept].max() <= 1
    beyond = (x > 0.25 + near) & (x < 1 - near) & (np.abs(z) < 1 - near)
    assert (whole[beyond] != [0, 0x30, 0]).any(axis=1).all()


def test_the_other_side_is_the_rest(by_command_line):
    scene = copy.deepcopy(SCENE)
    scene["layers"]["clip"]["invert"] = True
    other, whole = by_command_line(scene), by_command_line(without("clip"))
    x, _ = rays()
    near = 2.5 * VIEW / SIZE
    assert (other[x < 0.25 - near] == [0, 0x30, 0]).all()
    assert np.abs(other - whole)[x > 0.25 + near].max() <= 1


def test_each_layer_is_in_the_picture(by_command_line):
    whole = by_command_line(SCENE)
    x, z = rays()
    inside = away_from_outlines(x, z) & (expected(x, z)[..., 1] == 0)
    ball = inside & (np.hypot(x, z) < BALL)
    assert np.abs(whole - by_command_line(without("iso")))[ball].max(axis=1).min() > 50
    assert np.abs(whole - by_command_line(without("slice")))[inside & ~ball].max(axis=1).min() > 50
    assert np.abs(whole - by_command_line(without("fog")))[inside].max(axis=1).min() > 50


def test_json_rpc_gives_the_same_picture(by_command_line, server):
    picture = png_of(server.call("picture.render", scene=SCENE, width=SIZE, height=SIZE))
    assert (picture == by_command_line(SCENE)).all()


def test_a_session_patched_to_the_scene_gives_the_same_picture(by_command_line, server):
    session = server.call("session.open", scene={"dataset": "box"})["session"]
    patch = copy.deepcopy(SCENE)
    current = server.call("scene.get", session=session)["scene"]
    patch["layers"].update({layer: None for layer in current.get("layers", {}) if layer not in patch["layers"]})
    server.call("scene.patch", session=session, patch=patch)
    picture = png_of(server.call("picture.render", session=session, width=SIZE, height=SIZE))
    assert (picture == by_command_line(SCENE)).all()
    server.call("scene.patch", session=session, patch={"layers": {"clip": None}})
    unclipped = png_of(server.call("picture.render", session=session, width=SIZE, height=SIZE))
    assert (unclipped == by_command_line(without("clip"))).all()


@pytest.mark.parametrize("outside", [("below", "above"), ("above",), ("below",), ()], ids=lambda names: "and".join(names) or "none")
def test_a_volume_has_the_colors_of_values_outside_the_range(by_command_line, outside):
    """The fog is colored by x, which is constant along a ray. Each third of the box has one color; the opacity is uniform."""
    scene = copy.deepcopy(SCENE)
    scene["layers"] = {"fog": {**SCENE["layers"]["fog"], "slices": 50, "color": {
        "points": [{"at": 0, "color": "#00ff00"}, {"at": 1, "color": "#00ffff"}], "steps": 2, "range": [-0.4, 0.4],
        **{name: "#ff0000" for name in outside}}}}
    picture = by_command_line(scene)
    x, z = rays()
    inside = (np.abs(x) < 0.95) & (np.abs(z) < 0.95)
    fog = 255 * (1 - LEFT**2)
    ground = 0x30 * LEFT**2
    for name, place in (("below", x < -0.45), ("above", x > 0.45)):
        end = (0, fog + ground, fog if name == "above" else 0)
        color = (fog, ground, 0) if name in outside else end
        assert np.abs(picture[inside & place] - color).max() <= 2, name
    assert np.abs(picture[inside & (x > -0.35) & (x < -0.05)] - (0, fog + ground, 0)).max() <= 2
    assert np.abs(picture[inside & (x > 0.05) & (x < 0.35)] - (0, fog + ground, fog)).max() <= 2


@pytest.mark.parametrize("normal", [(0, -1, 0), (0.3, 1, 0.2), (-0.3, -1, -0.2)], ids=str)
def test_of_a_cap_and_a_slice_in_one_place_the_last_is_seen(by_command_line, normal):
    """The slice's origin is another point of the clip plane, and its normal may be reversed. Both must be cut identically."""
    clip = {"type": "clip", "origin": [0, 0.13, 0], "normal": [-component for component in normal]}
    along = np.cross(normal, (0.2, 0.1, 0.7))
    of_slice = {"type": "slice", "order": 5, "origin": list(np.array([0, 0.13, 0]) + along),
                "normal": [3 * component for component in normal], "color": {"solid": "#ff0000"}}
    solid = {"type": "surface", "color": {"solid": "#0000ff"}}
    shown = {}
    for value in (1, -1):
        slices = {**of_slice, "normal": [value * component for component in of_slice["normal"]]}
        shown[value] = by_command_line({**SCENE, "camera": {**SCENE["camera"], "position": [0, -8 * normal[1] / abs(normal[1]), 0]},
                                        "layers": {"solid": solid, "clip": clip, "slice": slices}})
    assert (shown[1] == shown[-1]).all()
    inside = (np.abs(rays()[0]) < 0.9) & (np.abs(rays()[1]) < 0.9)
    assert (shown[1][inside] == (255, 0, 0)).all()


def test_a_picture_says_what_it_does_not_show(box, server, tmp_path):
    """17 nested shells give 34 layers along a ray through their middle. The value 99 is outside of r."""
    shells = {"type": "iso", "array": "r", "values": list(np.linspace(0.1, 0.9, 17)), "opacity": 0.05}
    outside = {"type": "iso", "array": "r", "values": [99]}
    scene = {**SCENE, "layers": {"shells": shells, "outside": outside}}
    remarks = server.call("picture.render", scene=scene, width=SIZE, height=SIZE)["remarks"]
    assert len(remarks) == 2
    assert remarks[0].startswith("layer outside shows nothing. ")
    assert "more than 32 transparent surfaces" in remarks[1]
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    told = ciel("render", box, "--scene", tmp_path / "scene.json", "--size", f"{SIZE}x{SIZE}", "-o", tmp_path / "p.png")
    assert told.stderr.splitlines() == [f"ciel: {remark}" for remark in remarks]
    scene["layers"] = {"shells": {**shells, "values": shells["values"][:16]}}
    assert server.call("picture.render", scene=scene, width=SIZE, height=SIZE)["remarks"] == []


def test_what_was_not_written_at_a_time_is_left_out_and_said(box, tmp_path):
    """At time 9 there is no x. The surface colored by x is gray, the iso-surface of x is missing, the one of r is there."""
    copy = shutil.copytree(box, tmp_path / "box.ciel")
    np.save(tmp_path / "r.npy", np.linspace(0, 1, 25**3, dtype="f4"))
    assert ciel("append", copy, "--time", 9, "--array", f"r={tmp_path}/r.npy").returncode == 0
    by_r = {"type": "iso", "array": "r", "values": [0.5], "color": {"array": "r"}}
    half = {"type": "surface", "opacity": 0.5, "color": {"array": "x"}}
    iso = {"type": "iso", "array": "x", "values": [0]}
    grey = {**half, "color": {}}

    def drawn(**layers):
        (tmp_path / "scene.json").write_text(json.dumps({**SCENE, "time": 9, "layers": layers}))
        arguments = ("--size", f"{SIZE}x{SIZE}", "-o", tmp_path / "p.png")
        result = ciel("render", copy, "--scene", tmp_path / "scene.json", *arguments)
        assert result.returncode == 0, result.stderr
        return (tmp_path / "p.png").read_bytes(), result.stderr.splitlines()

    missing = "'x' has no values at time 9; it has values at 0, 0.5, 1, 1.5"
    picture, told = drawn(a=by_r, b=half, c=iso)
    assert told == [f"ciel: layer b has no colors: {missing}", f"ciel: layer c is not shown: {missing}"]
    assert (picture, []) == drawn(a=by_r, b=grey)
    picture, told = drawn(c=iso)
    assert told == [f"ciel: layer c is not shown: {missing}"] and (picture, []) == drawn()
    refused = ciel("extract", copy, "--iso", "x=0", "--time", 9, "-o", tmp_path / "x.vtp")
    assert refused.returncode == 1 and missing in refused.stderr and not (tmp_path / "x.vtp").exists()


def contoured(**contours):
    """The middle plane across y, white with contour lines of r. The view is along y."""
    values = {"array": "r", "values": [0.3, 0.8], "width": 5, **contours}
    layer = {"type": "slice", "axis": "y", "value": 0, "color": {"solid": "#ffffff"}, "contours": values}
    return {**SCENE, "layers": {"s": layer}}


def radii_of(picture, color):
    """Smallest and largest distance from the center of the pixels with exactly this color, or None for few pixels."""
    x, z = rays()
    found = np.hypot(x, z)[(picture == color).all(axis=2)]
    return (found.min(), found.max()) if len(found) > 20 else None


def test_contour_lines_have_one_color_or_those_of_their_values(by_command_line, server):
    ends = {"points": [{"at": 0, "color": "#ff0000"}, {"at": 1, "color": "#0000ff"}], "range": [0.3, 0.8]}
    near = 4 * VIEW / SIZE
    plain = by_command_line(contoured(color="#008800"))
    assert radii_of(plain, (0, 0x88, 0)) == pytest.approx((0.3, 0.8), abs=near)
    scene = contoured(color="#008800", coloring=ends)
    colored = by_command_line(scene)
    assert radii_of(colored, (0, 0x88, 0)) is None
    assert radii_of(colored, (255, 0, 0)) == pytest.approx((0.3, 0.3), abs=near)
    assert radii_of(colored, (0, 0, 255)) == pytest.approx((0.8, 0.8), abs=near)
    assert (png_of(server.call("picture.render", scene=scene, width=SIZE, height=SIZE)) == colored).all()


def test_contour_lines_change_their_colors_in_a_session(by_command_line, server):
    scene = contoured()
    session = server.call("session.open", scene=scene)["session"]
    grey = {"map": "grayscale", "reverse": True}
    for coloring in (grey, None, {**grey, "range": [0, 4]}):
        server.call("scene.patch", session=session, patch={"layers": {"s": {"contours": {"coloring": coloring}}}})
        picture = png_of(server.call("picture.render", session=session, width=SIZE, height=SIZE))
        wanted = contoured(coloring=coloring) if coloring else contoured()
        assert (picture == by_command_line(wanted)).all()


def test_contour_lines_by_options(box, tmp_path):
    common = [box, "--slice", "y=0", "--contours", "r=0.2,1.2", "--annotations", "none", "--size", "200x200"]
    pictures = []
    for name, options in {"plain": [], "turbo": ["--contour-map", "turbo"]}.items():
        result = ciel("render", *common, *options, "-o", tmp_path / f"{name}.png")
        assert result.returncode == 0, result.stderr
        reader = vtk.vtkPNGReader()
        reader.SetFileName(str(tmp_path / f"{name}.png"))
        pictures.append(pixels_of(reader))
    assert (pictures[0] != pictures[1]).any(axis=2).sum() > 100
    lacking = ciel("render", box, "--slice", "y=0", "--contour-map", "turbo", "-o", tmp_path / "p.png")
    assert lacking.returncode == 2 and "give --contours" in lacking.stderr


@pytest.mark.parametrize(("coloring", "path", "words"), [
    ({"array": "x"}, "/layers/s/contours/coloring/array", "have the colors of its values, not of x"),
    ({"map": "nothing"}, "/layers/s/contours/coloring/map", "there is no color map nothing"),
    ({"log": True, "range": [-1, 1]}, "/layers/s/contours/coloring/range", "add symmetric, or leave out log"),
])
def test_colors_of_contour_lines_that_make_no_sense_are_refused(server, coloring, path, words):
    answer = requests.post(server.base + "/rpc", timeout=PATIENCE, json={
        "jsonrpc": "2.0", "id": 1, "method": "picture.render", "params": {"scene": contoured(coloring=coloring)}})
    error = answer.json()["error"]
    assert words in json.dumps(error) and path in json.dumps(error)


@pytest.mark.parametrize("flags, reason", [
    (["--surface", "--threshold", "x=5,6"], "layer surface shows nothing. The threshold from 5 to 6 keeps no cell: x goes from −1 to 1"),
    (["--surface", "--clip", "x=-5"], "layer surface shows nothing. The clip planes cut away the whole layer."),
    (["--slice", "x=3"], "layer slice1 shows nothing. The plane does not cut the data."),
    (["--iso", "r=99"], "layer iso1 shows nothing. 99 is outside the range: r goes from"),
    (["--slice", "x=0", "--opacity", "0"], "layer slice1 shows nothing. The opacity is 0."),
])
def test_what_shows_nothing_is_said_on_stderr(box, tmp_path, flags, reason):
    result = ciel("render", box, *flags, "--size", "64x64", "-o", tmp_path / "p.png")
    assert result.returncode == 0 and reason in result.stderr, result.stderr
    shown = ciel("render", box, "--surface", "--size", "64x64", "-o", tmp_path / "p.png")
    assert "shows nothing" not in shown.stderr


def test_a_picture_without_a_camera_frames_what_clips_and_thresholds_leave(box, tmp_path):
    """A clipped corner fills as much of the picture as the whole box."""
    def covered(*flags):
        path = tmp_path / "p.png"
        result = ciel("render", box, "--surface", *flags, "--background", "#003000", "--annotations", "none",
                      "--size", "200x200", "-o", path)
        assert result.returncode == 0, result.stderr
        reader = vtk.vtkPNGReader()
        reader.SetFileName(str(path))
        return np.mean(np.any(pixels_of(reader) != (0, 48, 0), axis=2))

    whole = covered()
    corner = covered("--clip", "x=-0.5", "--clip", "y=-0.5", "--clip", "z=-0.5")
    assert abs(corner / whole - 1) < 0.1, "a cube, from the same side"
    assert covered("--threshold", "x=0.5,1") > 0.3 * whole
    far = covered("--clip", "x=-0.5", "--clip", "y=-0.5", "--clip", "z=-0.5", "--camera", "3,-5,2.6,0,0,0")
    assert far < 0.3 * corner, "a camera that is given is taken"


def test_a_legend_shows_the_color_of_missing_values_where_some_are_shown(tmp_path):
    box = box_dataset.write_box(tmp_path / "box.ciel", 8, holes=True)
    looking_away = ["--camera", "0,-9,0,0,-20,0"]  # the camera looks away, so only the legend is colored

    def magenta(*flags):
        path = tmp_path / "p.png"
        result = ciel("render", box, *flags, *looking_away, "--nan-color", "#ff00ff", "--size", "400x300", "-o", path)
        assert result.returncode == 0, result.stderr
        reader = vtk.vtkPNGReader()
        reader.SetFileName(str(path))
        return np.count_nonzero(np.all(pixels_of(reader) == (255, 0, 255), axis=2))

    assert magenta("--slice", "x=0.5", "--color", "m") > 40
    assert magenta("--slice", "x=-0.5", "--color", "m") == 0, "all of these have a value"
    assert magenta("--slice", "x=0.5", "--color", "x") == 0
    assert magenta("--slice", "x=0.5", "--color", "x", "--above-color", "#ff00ff", "--range", "0,0.2") > 20


@pytest.mark.parametrize("flags, sentence", [
    (["--slice", "y=0", "--color", "x", "--map", "rainbow"], "--map rainbow is not a color map; choose one of viridis, inferno"),
    (["--slice", "y=0", "--contours", "x", "--contour-map", "jet"], "--contour-map jet is not a color map; choose one of"),
    (["--surface", "--volume-direction", "x"], "--volume-direction applies to volumes only; give --volume"),
    (["--surface", "--volume-unshaded"], "--volume-unshaded applies to volumes only; give --volume"),
    (["--volume", "x", "--volume-unit-length", "0"], "--volume-unit-length must be a length of more than 0"),
    (["--volume", "x", "--volume-unit-length", "nan"], "--volume-unit-length must be a length of more than 0"),
    (["--volume", "x", "--volume-direction", "up"], "--volume-direction"),
])
def test_wrong_usage_exits_with_2_and_says_what_there_is(box, tmp_path, flags, sentence):
    result = ciel("render", box, *flags, "-o", tmp_path / "p.png")
    assert result.returncode == 2 and sentence in result.stderr, result.stderr
    assert not (tmp_path / "p.png").exists()


def test_options_of_volumes_are_those_of_the_scene(box, tmp_path):
    """An unshaded volume of one color follows Beer-Lambert for every direction of slices: half of the light per unit length."""
    def middle(*flags):
        result = ciel("render", box, "--volume", "x=0:0.5", "--color-points", "0=#000000,1=#000000", "--volume-unshaded",
                      "--background", "#ffffff", "--annotations", "none", "--camera", "0,-9,0,0,0,0", "--parallel",
                      "--size", "64x64", *flags, "-o", tmp_path / "p.png")
        assert result.returncode == 0, result.stderr
        reader = vtk.vtkPNGReader()
        reader.SetFileName(str(tmp_path / "p.png"))
        return pixels_of(reader)[36, 36, 0] / 255  # beside the center, which the outline crosses

    for direction in ("auto", "x", "y", "z", "screen"):
        found = middle("--volume-unit-length", "2", "--volume-direction", direction)
        assert abs(found - 0.5) < 0.02, direction
    assert abs(middle("--volume-unit-length", "1") - 0.25) < 0.02


def test_null_in_a_scene_file_is_as_if_it_were_not_there(by_command_line):
    scene = copy.deepcopy(SCENE)
    plain = by_command_line(scene)
    scene["layers"]["gone"] = None
    scene["time"] = scene["layers"]["slice"]["opacity"] = scene["layers"]["slice"]["contours"] = None
    assert np.array_equal(by_command_line(scene), plain)


@pytest.mark.parametrize("ends", ["-1e308,1e308", "1e-42,3e-42", "5,5", "1000000000,1000000000.001", "-3.4e38,3.4e38"])
def test_any_range_is_drawn(box, tmp_path, ends):
    result = ciel("render", box, "--slice", "y=0", "--color", "x", f"--range={ends}", "--size", "64x64", "-o",
                  tmp_path / "p.png")
    assert result.returncode == 0, result.stderr
