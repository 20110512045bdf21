"""ciel extract and ciel render: files read by VTK, pictures measured."""

import json
import os
import resource
import shutil

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from box_dataset import write_box
from program import ciel


def works(*arguments, cwd=None):
    result = ciel(*arguments, cwd=cwd)
    assert result.returncode == 0, result.stderr
    return result.stdout


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return write_box(tmp_path_factory.mktemp("box") / "box.ciel", 24)


def read(path):
    reader = {".vtp": vtk.vtkXMLPolyDataReader, ".ply": vtk.vtkPLYReader, ".stl": vtk.vtkSTLReader}[path.suffix.lower()]()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def area(surface):
    triangles, mass = vtk.vtkTriangleFilter(), vtk.vtkMassProperties()
    triangles.SetInputData(surface)
    mass.SetInputConnection(triangles.GetOutputPort())
    return mass.GetSurfaceArea()


@pytest.mark.parametrize("extension", [".ply", ".stl", ".vtp"])
@pytest.mark.parametrize("triangles", [False, True])
def test_iso_surface_is_the_sphere(box, tmp_path, extension, triangles):
    path = tmp_path / f"sphere{extension}"
    works("extract", box, "--iso", "r=0.75", "-o", path, *(["--triangles"] if triangles else []))
    surface = read(path)
    assert area(surface) == pytest.approx(4 * np.pi * 0.75**2, rel=0.01)
    corners = {surface.GetCell(i).GetNumberOfPoints() for i in range(surface.GetNumberOfCells())}
    assert corners == {3} if triangles or extension == ".stl" else max(corners) > 3
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.Update()
    assert edges.GetOutput().GetNumberOfCells() == 0, "an open or non-manifold edge"


def test_values_and_normals_of_the_field(box, tmp_path):
    works("extract", box, "--iso", "r=0.5", "--color", "x", "--color", "r", "-o", tmp_path / "s.vtp")
    surface = read(tmp_path / "s.vtp")
    points = vtk_to_numpy(surface.GetPoints().GetData())
    assert np.allclose(vtk_to_numpy(surface.GetPointData().GetArray("x")), points[:, 0], atol=1e-6)
    assert np.allclose(vtk_to_numpy(surface.GetPointData().GetArray("r")), 0.5, atol=1e-6)
    normals = vtk_to_numpy(surface.GetPointData().GetNormals())
    outwards = points / np.linalg.norm(points, axis=1)[:, None]
    assert (normals * outwards).sum(axis=1).min() > 0.99


def test_several_values_slices_and_planes_join(box, tmp_path):
    works("extract", box, "--iso", "r=0.3,0.6", "--slice", "x=0.1", "--plane", "0,0,0,0,1,1", "-o", tmp_path / "s.vtp")
    surface = read(tmp_path / "s.vtp")
    exact = 4 * np.pi * (0.3**2 + 0.6**2) + 4 + 4 * np.sqrt(2)
    assert area(surface) == pytest.approx(exact, rel=0.01)


def test_time_chooses_the_nearest_step(box, tmp_path):
    works("extract", box, "--iso", "r=0.5", "--time", 0.6, "-o", tmp_path / "s.vtp")
    bounds = read(tmp_path / "s.vtp").GetBounds()
    assert (bounds[0] + bounds[1]) / 2 == pytest.approx(0.15, abs=0.01)


FAR = (500_000.25, 4_000_000.25, 100.0)


@pytest.fixture(scope="module")
def far_box(box, tmp_path_factory):
    """The box dataset with large coordinates, as from a survey."""
    far = shutil.copytree(box, tmp_path_factory.mktemp("far") / "far.ciel")
    attributes = far / "meshes/0/.zattrs"
    mesh = json.loads(attributes.read_text())
    mesh["ciel"]["origin"] = FAR
    mesh["ciel"]["bounds"] = [c + d for c in FAR for d in (-1, 1)]
    attributes.write_text(json.dumps(mesh))
    return far


def test_stl_far_from_the_origin_has_the_area_of_ply_and_says_where_it_is(far_box, tmp_path):
    """float32 values near 4,000,000 are 0.25 apart, too coarse for a sphere of radius 0.75."""
    works("extract", far_box, "--iso", "r=0.75", "-o", tmp_path / "s.ply")
    said = works("extract", far_box, "--iso", "r=0.75", "-o", tmp_path / "s.stl")
    ply, stl = read(tmp_path / "s.ply"), read(tmp_path / "s.stl")
    assert area(stl) == pytest.approx(4 * np.pi * 0.75**2, rel=0.01)
    assert "relative to the origin 500000 4000000 100" in said
    assert (tmp_path / "s.stl").read_bytes()[:80].rstrip(b"\0") == b"CIEL surface, origin 500000 4000000 100"
    assert np.allclose(np.reshape(stl.GetBounds(), (3, 2)).mean(axis=1), [0.25, 0.25, 0], atol=0.02)
    assert ply.GetNumberOfPoints() > 0


def test_surfaces_of_a_dataset_are_relative_to_one_origin(far_box, tmp_path):
    for name, options in {"iso": ["--iso", "r=0.75"], "slice": ["--slice", f"x={FAR[0]}"]}.items():
        works("extract", far_box, *options, "-o", tmp_path / f"{name}.stl")
        works("extract", far_box, *options, "--origin", "-o", tmp_path / f"{name}.ply")
        works("extract", far_box, *options, "--origin", "-o", tmp_path / f"{name}.vtp")
        assert b"\ncomment origin 500000 4000000 100\n" in (tmp_path / f"{name}.ply").read_bytes()[:400]
        vtp = read(tmp_path / f"{name}.vtp")
        assert vtk_to_numpy(vtp.GetFieldData().GetArray("origin")).ravel().tolist() == [500000, 4000000, 100]
        bounds = [read(tmp_path / f"{name}{extension}").GetBounds() for extension in (".stl", ".ply", ".vtp")]
        assert np.allclose(bounds[0], bounds[1], atol=1e-5) and np.allclose(bounds[0], bounds[2], atol=1e-5)
        assert np.allclose(np.reshape(bounds[0], (3, 2)).mean(axis=1), [0.25, 0.25, 0], atol=0.02)


def test_info_prints_bounds_with_all_digits(far_box):
    said = works("info", far_box)
    assert "[499999.25, 500001.25]" in said and "[3999999.25, 4000001.25]" in said


def test_a_dataset_near_the_origin_is_not_moved(box, tmp_path):
    said = works("extract", box, "--iso", "r=0.75", "-o", tmp_path / "s.stl")
    assert "relative" not in said and (tmp_path / "s.stl").read_bytes()[:80].rstrip(b"\0") == b"CIEL surface"
    said = works("extract", box, "--iso", "r=0.75", "--origin", "-o", tmp_path / "s.vtp")
    assert "relative to the origin 0 0 0" in said


@pytest.mark.parametrize("extension", [".ply", ".stl", ".vtp"])
def test_an_empty_surface_is_a_file_and_a_sentence_with_the_range(box, tmp_path, extension):
    path = tmp_path / f"s{extension}"
    result = ciel("extract", box, "--iso", "r=99", "--slice", "z=7", "--time", 0, "-o", path)
    assert result.returncode == 0, result.stderr
    assert result.stderr.startswith("ciel: the surface is empty: at time 0 r lies between 0 and 1.73205, x lies between -1 and 1, ")
    assert result.stderr.count("\n") == 1
    assert read(path).GetNumberOfCells() == 0
    help_text = " ".join(works("extract", "--help").split())
    assert "empty surface" in help_text and "the exit code is 0" in help_text


def pixels(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)[::-1].astype(int)


def test_picture_shows_the_colored_sphere(box, tmp_path):
    """The sphere is colored by x and seen along z: violet at the left, green in the middle, yellow at the right."""
    works("render", box, "--iso", "r=0.75", "--color", "x", "--range", "-0.75,0.75", "--camera", "0,0,6,0,0,0", "--size", "320x200",
          "-o", "p.png", cwd=tmp_path)
    picture = pixels(tmp_path / "p.png")
    assert picture.shape == (200, 320, 3)
    left, middle, right = picture[100, [122, 160, 202]]
    assert left[2] > left[1], "viridis begins with violet"
    assert middle[1] > 90 and middle[1] > middle[0], "and is green in the middle of its range"
    assert right[0] > right[2] and right[1] > 1.5 * right[2], "and ends with yellow"
    assert picture[2, 2].max() < 60
    assert 0.1 < (picture.max(axis=2) > 70).mean() < 0.5


def test_the_default_view_takes_colors_and_a_background(box, tmp_path):
    shown = {}
    for name, options in {"plain": [], "map": ["--map", "grayscale"], "array": ["--color", "r"], "range": ["--color", "r", "--range", "0,0.1"]}.items():
        works("render", box, *options, "--size", "160x100", "-o", tmp_path / f"{name}.png")
        shown[name] = pixels(tmp_path / f"{name}.png")
    for name in ("map", "array"):
        assert np.abs(shown[name] - shown["plain"]).mean() > 0.5, name
    assert np.abs(shown["range"] - shown["array"]).mean() > 0.5
    works("render", box, "--background", "#ff0000", "--size", "160x100", "-o", tmp_path / "red.png")
    assert tuple(pixels(tmp_path / "red.png")[2, 2]) == (255, 0, 0)


def test_slices_have_the_colors_that_the_options_ask_for(box, tmp_path):
    """Colors the box's middle plane by r. Its corners and its center are outside the color range."""
    common = ["--slice", "y=0", "--color", "r", "--range", "0.3,0.8", "--below-color", "#ff0000", "--above-color", "#0000ff", "--size", "200x160"]
    shown = {}
    for name, options in {"smooth": [], "reverse": ["--reverse"], "steps": ["--steps", "3", "--map", "grayscale"], "log": ["--log"],
                          "points": ["--color-points", "0=#00ff00,1=#00ff00"]}.items():
        works("render", box, *common, *options, "-o", tmp_path / f"{name}.png")
        shown[name] = [tuple(color) for color in pixels(tmp_path / f"{name}.png").reshape(-1, 3)]
        assert shown[name].count((255, 0, 0)) > 100 and shown[name].count((0, 0, 255)) > 100, name
    assert shown["points"].count((0, 255, 0)) > 500
    for grey in ((0, 0, 0), (128, 128, 128), (255, 255, 255)):
        assert shown["steps"].count(grey) > 100, grey
    assert shown["smooth"] != shown["reverse"] != shown["log"] != shown["smooth"]


def test_options_about_looks_are_the_document_s(box, tmp_path):
    camera = {"position": [3, -5, 2], "target": [0, 0, 0], "up": [0, 1, 0]}
    line = {"type": "outline", "color": {"solid": "#808890"}}
    layers = {
        "iso": {"type": "iso", "array": "r", "values": [0.5], "opacity": 0.4, "smooth": False, "color": {"array": "r"}, "order": 0},
        "volume": {"type": "volume", "array": "x", "opacity": 0.4, "slices": 7, "order": 1},
    }
    (tmp_path / "scene.json").write_text(json.dumps({"camera": camera, "layers": layers | {"outline": line}}))
    size = ["--size", "160x120"]
    works("render", box, "--scene", tmp_path / "scene.json", *size, "-o", tmp_path / "document.png")
    options = {"--camera": "3,-5,2,0,0,0,0,1,0", "--opacity": "0.4", "--volume-slices": "7", "--flat": None}
    everything = [word for name, value in options.items() for word in (name, value) if word]
    works("render", box, "--iso", "r=0.5", "--volume", "x", *everything, *size, "-o", tmp_path / "options.png")
    assert np.array_equal(pixels(tmp_path / "options.png"), pixels(tmp_path / "document.png"))
    for left_out in options:
        others = [word for name, value in options.items() if name != left_out for word in (name, value) if word]
        works("render", box, "--iso", "r=0.5", "--volume", "x", *others, *size, "-o", tmp_path / "other.png")
        assert not np.array_equal(pixels(tmp_path / "other.png"), pixels(tmp_path / "document.png")), left_out


def test_the_perspective_is_as_strong_as_asked_for(box, tmp_path):
    """Seen from the front, the ratio of the widths of the box's front and back faces is that of their distances to the eye."""
    look = ["--surface", "--camera", "0,-5,0,0,0,0", "--annotations", "none", "--size", "200x200"]

    def width(*options):
        works("render", box, *look, *options, "-o", tmp_path / "p.png")
        row = pixels(tmp_path / "p.png")[100]
        return int((np.abs(row - row[1]).max(axis=1) > 20).sum())

    for degrees in (30, 50, 80):
        wanted = 200 * 2 / (2 * 4 * np.tan(np.radians(degrees) / 2))
        assert abs(width("--field-of-view", str(degrees)) - wanted) <= 4, degrees  # the outline adds to the width
    assert abs(width("--parallel", "--field-of-view", "50") - 200 * 2 / (2 * 5 * np.tan(np.radians(25)))) <= 4


def test_all_is_seen_at_any_field_of_view(box, tmp_path):
    common = ["render", box, "--surface", "--background", "#000000", "--annotations", "none", "--size", "160x160"]
    seen = []
    for options in ([], ["--field-of-view", "5"], ["--field-of-view", "110"], ["--parallel"]):
        works(*common, *options, "-o", tmp_path / "p.png")
        shown = pixels(tmp_path / "p.png").max(axis=2) > 20
        assert shown.mean() > 0.2, options
        assert not (shown[0].any() or shown[-1].any() or shown[:, 0].any() or shown[:, -1].any()), options
        seen.append(shown)
    assert (seen[1] != seen[3]).mean() < 0.05 < (seen[2] != seen[3]).mean(), "5 degrees are nearly parallel, 110 are not"


def test_default_view_scene_file_and_every_back_end_agree(box, tmp_path):
    works("render", box, "-o", tmp_path / "default.png", "--size", "160x100")
    assert (pixels(tmp_path / "default.png").max(axis=2) > 70).mean() > 0.02
    scene = {"dataset": "box", "background": "#000000", "layers": {"s": {"type": "slice", "axis": "y", "value": 0}}}
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    pictures = []
    for name in ("auto", "egl-device", "egl-surfaceless", "osmesa"):
        path = tmp_path / f"{name}.png"
        result = ciel("render", box, "--scene", tmp_path / "scene.json", "--gl", name, "--size", "160x100", "-o", path)
        if result.returncode == 0:
            pictures.append(pixels(path))
        else:
            assert name in result.stderr and name != "auto"
    assert len(pictures) > 1, "auto's back end has a name"
    for other in pictures[1:]:
        assert np.abs(other - pictures[0]).mean() < 0.5


def test_layers_by_options_change_the_picture_each_in_its_way(box, tmp_path):
    """Each option changes the picture. A scene with the same layers gives the same picture."""
    shown = {}
    options = {
        "surface": ["--surface"],
        "edges": ["--surface", "--edges"],
        "clip": ["--surface", "--clip", "x=0"],
        "other side": ["--surface", "--clip=-x=0"],
        "threshold": ["--surface", "--threshold", "x=-1,0"],
        "feature edges": ["--feature-edges", "30"],
        "points": ["--points", "all"],
        "slice": ["--slice", "z=0", "--color", "x"],
        "contours": ["--slice", "z=0", "--color", "x", "--contours", "r"],
        "some contours": ["--slice", "z=0", "--color", "x", "--contours", "r=0.5,0.75"],
    }
    for name, arguments in options.items():
        works("render", box, *arguments, "--size", "320x200", "-o", tmp_path / "p.png")
        shown[name] = pixels(tmp_path / "p.png")
    names = list(shown)
    for i, a in enumerate(names):
        for b in names[:i]:
            assert np.abs(shown[a] - shown[b]).mean() > 0.1, (a, b)
    scene = {
        "dataset": "box",
        "time": 0,
        "layers": {
            "clip1": {"type": "clip", "axis": "x", "value": 0},
            "outline": {"type": "outline", "color": {"solid": "#808890"}},
            "surface": {"type": "surface"},
        },
    }
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    works("render", box, "--scene", tmp_path / "scene.json", "--size", "320x200", "-o", tmp_path / "p.png")
    assert np.abs(pixels(tmp_path / "p.png") - shown["clip"]).mean() < 0.01
    lit = {name: (picture.max(axis=2) > 70).mean() for name, picture in shown.items()}
    assert lit["clip"] < 0.8 * lit["surface"]


def test_points_that_are_too_many_are_thinned_and_it_is_said(box, tmp_path):
    scene = {"dataset": "box", "layers": {"p": {"type": "points", "of": "all", "most": 1000}}}
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    result = ciel("render", box, "--scene", tmp_path / "scene.json", "--size", "160x100", "-o", tmp_path / "p.png")
    assert result.returncode == 0
    assert result.stderr.startswith("ciel: layer p shows one in ") and "raise" in result.stderr


REFUSED = [
    ("no layers", ["extract", "-o", "s.ply"], "nothing to extract", 2),
    ("unknown format", ["extract", "--iso", "r=1", "-o", "s.obj"], ".ply, .stl or .vtp", 2),
    ("unknown array", ["extract", "--iso", "q=1", "-o", "s.ply"], "q", 1),
    ("no value", ["extract", "--iso", "r", "-o", "s.ply"], "ARRAY=VALUE", 2),
    ("not a number", ["extract", "--iso", "r=1,two", "-o", "s.ply"], "not a finite number", 2),
    ("infinite", ["extract", "--iso", "r=inf", "-o", "s.ply"], "not a finite number", 2),
    ("comma at the end", ["extract", "--iso", "r=1,", "-o", "s.ply"], "not a finite number", 2),
    ("unknown axis", ["extract", "--slice", "w=1", "-o", "s.ply"], "x=VALUE", 2),
    ("short plane", ["extract", "--plane", "0,0,0,1", "-o", "s.ply"], "six numbers", 2),
    ("no normal", ["extract", "--plane", "0,0,0,0,0,0", "-o", "s.ply"], "normal", 2),
    ("unknown color", ["extract", "--iso", "r=0.5", "--color", "q", "-o", "s.ply"], "q", 1),
    ("no folder", ["extract", "--iso", "r=0.5", "-o", "nowhere/s.ply"], "nowhere/s.ply: cannot be written: there is no folder", 1),
    ("a folder", ["extract", "--iso", "r=0.5", "-o", "."], "-o .: '' is not a surface format", 2),
    ("no output", ["extract", "--iso", "r=0.5"], "--output", 2),
    ("unknown map", ["render", "--iso", "r=0.5", "--map", "jet", "-o", "p.png"], "viridis", 2),
    ("unknown back end", ["render", "--gl", "glx", "-o", "p.png"], "osmesa", 2),
    ("bad size", ["render", "--size", "12", "-o", "p.png"], "WIDTHxHEIGHT", 2),
    ("no pixels", ["render", "--size", "0x5", "-o", "p.png"], "WIDTHxHEIGHT", 2),
    ("size with words", ["render", "--size", "12x10px", "-o", "p.png"], "WIDTHxHEIGHT", 2),
    ("too wide", ["render", "--size", "999999x10", "-o", "p.png"], "--size 999999x10 is too large: a picture may be at most 8192 ", 2),
    ("too many pixels", ["render", "--size", "8000x8000", "-o", "p.png"], "a picture may have at most 33554432 pixels", 2),
    ("not a picture", ["render", "-o", "p.jpg"], ".png", 2),
    ("no scene file", ["render", "--scene", "none.json", "-o", "p.png"], "none.json", 1),
    ("bad scene file", ["render", "--scene", "bad.json", "-o", "p.png"], "bad.json is not JSON: parse error at line 1", 1),
    ("layer twice", ["render", "--scene", "twice.json", "-o", "p.png"], 'twice.json: "a" occurs twice in the same object', 1),
    ("scene of another dataset", ["render", "--scene", "other.json", "-o", "p.png"], 'of the dataset "post", not of "box"', 1),
    ("bad scene", ["render", "--scene", "wrong.json", "-o", "p.png"], "/layers", 1),
    ("scene file and edges", ["render", "--scene", "wrong.json", "--edges", "-o", "p.png"], "leave out", 2),
    ("edges of nothing", ["render", "--points", "all", "--edges", "-o", "p.png"], "give --iso, --slice or --surface", 2),
    ("contours of nothing", ["render", "--surface", "--contours", "r", "-o", "p.png"], "give --slice or --plane", 2),
    ("contours of no numbers", ["render", "--slice", "x=0", "--contours", "r=a", "-o", "p.png"], "not a finite number", 2),
    ("contours of an unknown array", ["render", "--slice", "x=0", "--contours", "q", "-o", "p.png"], "q", 1),
    ("threshold of nothing", ["render", "--iso", "r=0.5", "--threshold", "r=0,1", "-o", "p.png"], "give --surface", 2),
    ("short threshold", ["render", "--surface", "--threshold", "r=0", "-o", "p.png"], "ARRAY=MIN,MAX", 2),
    ("clip across nothing", ["render", "--surface", "--clip", "w=0", "-o", "p.png"], "x=VALUE", 2),
    ("clip nowhere", ["render", "--surface", "--clip", "x=", "-o", "p.png"], "--clip needs a number", 2),
    ("short clip plane", ["render", "--surface", "--clip", "0,0,0", "-o", "p.png"], "ox,oy,oz,nx,ny,nz", 2),
    ("seven clips", ["render", "--surface", *["--clip=x=0"] * 7, "-o", "p.png"], "at most 6 clip planes", 1),
    ("scene file and colors", ["render", "--scene", "wrong.json", "--color", "x", "-o", "p.png"], "leave out", 2),
    ("scene file and background", ["render", "--scene", "wrong.json", "--background", "light", "-o", "p.png"], "leave out", 2),
    ("bad range of the default view", ["render", "--range", "1", "-o", "p.png"], "range", 2),
    ("unknown map of the default view", ["render", "--map", "jet", "-o", "p.png"], "viridis", 2),
    ("log of zero", ["render", "--iso", "r=0.5", "--log", "--range", "0,1", "-o", "p.png"], "begins above zero", 1),
    ("one step", ["render", "--iso", "r=0.5", "--steps", "1", "-o", "p.png"], "at least 2", 1),
    ("points without colors", ["render", "--iso", "r=0.5", "--color-points", "0,1", "-o", "p.png"], "AT=#rrggbb", 2),
    ("points out of order", ["render", "--iso", "r=0.5", "--color-points", "1=#000000,0=#ffffff", "-o", "p.png"], "ascending", 1),
    ("a color by name", ["render", "--iso", "r=0.5", "--above-color", "red", "-o", "p.png"], "color/above", 1),
    ("opacity of nothing", ["render", "--clip", "x=0", "--scene", "wrong.json", "--opacity", "0.5", "-o", "p.png"], "leave out", 2),
    ("too opaque", ["render", "--iso", "r=0.5", "--opacity", "1.5", "-o", "p.png"], "opacity must be at most 1", 1),
    ("flat slice", ["render", "--slice", "y=0", "--flat", "-o", "p.png"], "give --iso", 2),
    ("slices of no volume", ["render", "--slice", "y=0", "--volume-slices", "9", "-o", "p.png"], "give --volume", 2),
    ("patches of an iso-surface", ["render", "--iso", "r=0.5", "--patches", "a", "-o", "p.png"], "give --surface", 2),
    ("unknown patch", ["render", "--surface", "--patches", "a,b", "-o", "p.png"], "no patch a", 1),
    ("short camera", ["render", "--camera", "0,0,9", "-o", "p.png"], "px,py,pz,tx,ty,tz", 2),
    ("camera at its target", ["render", "--camera", "0,0,9,0,0,9", "-o", "p.png"], "must differ", 1),
    ("no field of view", ["render", "--field-of-view", "0", "-o", "p.png"], "more than 0 and less than 180 degrees", 2),
    ("all around", ["render", "--field-of-view", "180", "-o", "p.png"], "more than 0 and less than 180 degrees", 2),
    ("field of view in words", ["render", "--field-of-view", "nan", "-o", "p.png"], "more than 0 and less than 180 degrees", 2),
    ("range of no array", ["render", "--slice", "y=0", "--range", "0,1", "-o", "p.png"], "give --color", 2),
    ("map of no array", ["render", "--surface", "--map", "vik", "-o", "p.png"], "give --color", 2),
    ("time of the default view", ["render", "--time", "nan", "-o", "p.png"], "--time must be a finite number", 2),
    ("bad range", ["render", "--iso", "r=0.5", "--range", "1", "-o", "p.png"], "range", 2),
    ("unknown annotation", ["render", "--annotations", "legends", "-o", "p.png"], "legends", 2),
    ("all and one", ["render", "--annotations", "all,time", "-o", "p.png"], "cannot be combined with other names", 2),
    ("occlusion of none", ["render", "--occlusion-radius", "0.2", "-o", "p.png"], "--ambient-occlusion", 2),
    ("light too strong", ["render", "--key-light", "9", "-o", "p.png"], "/lighting/key_light/strength", 1),
    ("text too small", ["render", "--text-scale", "0.01", "-o", "p.png"], "/annotations/scale", 1),
]


@pytest.mark.parametrize("arguments,message,code", [row[1:] for row in REFUSED], ids=[row[0] for row in REFUSED])
def test_refused_in_one_line_and_nothing_is_written(box, tmp_path, arguments, message, code):
    (tmp_path / "bad.json").write_text("{")
    (tmp_path / "twice.json").write_text('{"layers": {"a": {"type": "outline"}, "a": {"type": "surface"}}}')
    (tmp_path / "other.json").write_text('{"dataset": "post", "layers": {}}')
    (tmp_path / "wrong.json").write_text('{"dataset": "box", "layers": {"a": {"type": "fog"}}}')
    before = set(os.listdir(tmp_path))
    result = ciel(arguments[0], box, *arguments[1:], cwd=tmp_path)
    assert result.returncode == code, result.stderr
    assert message in result.stderr
    assert result.stderr.startswith("ciel: ") and result.stderr.count("\n") == 1, result.stderr
    assert set(os.listdir(tmp_path)) == before


def test_slices_on_the_sides_of_the_domain_are_there(box, tmp_path):
    sides = json.loads(works("info", box, "--json"))["bounds"]
    for axis in range(3):
        found = []
        for side in sides[2 * axis : 2 * axis + 2]:
            works("extract", box, "--slice", f"{'xyz'[axis]}={side!r}", "-o", tmp_path / "side.VTP")
            points = vtk_to_numpy(read(tmp_path / "side.VTP").GetPoints().GetData())
            assert np.allclose(points[:, axis], side, atol=1e-5)
            found.append(len(points))
        assert found[0] == found[1] > 0


def test_the_nearest_step_is_taken_but_told(box, tmp_path):
    for command, output in (("extract", "s.ply"), ("render", "p.png")):
        result = ciel(command, box, "--iso", "r=0.5", "--time", "1e9", "-o", output, cwd=tmp_path)
        assert result.returncode == 0 and "there is no step at time 1e+09; the nearest, " in result.stderr


def test_a_dataset_that_is_not_there(tmp_path):
    result = ciel("render", tmp_path / "none.ciel", "-o", tmp_path / "p.png")
    assert result.returncode == 1 and "none.ciel" in result.stderr and not (tmp_path / "p.png").exists()


def test_annotations_are_switched_one_by_one(box, tmp_path):
    shown = {}
    for names in ("none", "legend", "triad", "axes", "time", "dataset", "all"):
        works("render", box, "--iso", "r=0.75", "--color", "x", "--annotations", names, "--size", "640x360", "-o", tmp_path / f"{names}.png")
        shown[names] = pixels(tmp_path / f"{names}.png")
    works("render", box, "--iso", "r=0.75", "--color", "x", "--annotations", "none", "--title", "Grüße", "--size", "640x360", "-o", tmp_path / "title.png")
    shown["title"] = pixels(tmp_path / "title.png")
    written = {names: np.abs(picture - shown["none"]).max(axis=2) > 20 for names, picture in shown.items()}
    places = {"legend": np.s_[:, 500:], "triad": np.s_[260:, :100], "time": np.s_[:60, :300], "dataset": np.s_[:60, :300], "title": np.s_[:40, 100:540]}
    for names, place in places.items():
        assert written[names].sum() > 30, names
        assert written[names][place].sum() == written[names].sum(), f"{names} is written elsewhere too"
    assert written["axes"].sum() > 300
    assert written["all"].sum() > written["axes"].sum() + written["legend"].sum()


def test_lights_by_options_and_by_the_scene(box, tmp_path):
    """Two nested spheres, cut open. Occlusion darkens the space between them."""
    shown = {}
    options = {
        "default": [],
        "all at one": ["--headlight", "1", "--key-light", "1", "--ambient", "1"],
        "no headlight": ["--headlight", "0"],
        "no key light": ["--key-light", "0"],
        "dim": ["--ambient", "0"],
        "unlit": ["--unlit"],
        "occlusion": ["--ambient-occlusion", "--occlusion-radius", "0.2", "--occlusion-strength", "2"],
        "occlusion unlit": ["--unlit", "--ambient-occlusion"],
    }
    for name, arguments in options.items():
        works("render", box, "--iso", "r=0.5,0.75", "--clip", "x=0", "--annotations", "none", *arguments, "--size", "320x200", "-o", tmp_path / "p.png")
        shown[name] = pixels(tmp_path / "p.png")
    assert (shown["default"] == shown["all at one"]).all()
    assert (shown["unlit"] == shown["occlusion unlit"]).all()
    for name in ("no headlight", "no key light", "dim", "occlusion"):
        assert (shown[name] <= shown["default"] + 1).all() and (shown["default"] - shown[name]).max() > 25, name
    assert (shown["unlit"] - shown["default"]).max() > 25
    scene = {
        "dataset": "box",
        "time": 0,
        "annotations": {"legend": False, "triad": False},
        "lighting": {"ambient_occlusion": {"on": True, "radius": 0.2, "strength": 2}},
        "layers": {
            "outline": {"type": "outline", "color": {"solid": "#808890"}},
            "iso1": {"type": "iso", "array": "r", "values": [0.5, 0.75], "color": {"array": "r"}},
            "clip1": {"type": "clip", "axis": "x", "value": 0},
        },
    }
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    works("render", box, "--scene", tmp_path / "scene.json", "--size", "320x200", "-o", tmp_path / "p.png")
    assert np.abs(pixels(tmp_path / "p.png") - shown["occlusion"]).mean() < 0.01


def test_text_grows_with_its_scale(box, tmp_path):
    heights = []
    for scale in ("1", "2"):
        works("render", box, "--annotations", "none", "--title", "H", "--text-scale", scale, "--size", "640x360", "-o", tmp_path / "p.png")
        works("render", box, "--annotations", "none", "--size", "640x360", "-o", tmp_path / "plain.png")
        rows = np.flatnonzero((np.abs(pixels(tmp_path / "p.png") - pixels(tmp_path / "plain.png")).max(axis=2) > 100).any(axis=1))
        heights.append(rows.max() - rows.min() + 1)
    assert heights[1] == pytest.approx(2 * heights[0], abs=2)


def test_a_lack_of_memory_is_a_sentence(tmp_path):
    demo = tmp_path / "demo.ciel"
    assert ciel("demo", "--coarseness", 2, "-o", demo).returncode == 0
    levels = ",".join(f"{0.1 + 0.013 * i:.3f}" for i in range(64))
    said = []
    for megabytes in (110, 130, 150, 170):
        limit = (megabytes << 20, megabytes << 20)
        result = ciel("extract", demo, "--iso", f"tracer={levels}", "-o", tmp_path / "out.vtp",
                      preexec_fn=lambda limit=limit: resource.setrlimit(resource.RLIMIT_AS, limit))
        assert result.returncode in (0, 1) and "std::" not in result.stderr, (megabytes, result)
        said.append(result.stderr)
    assert any("does not have enough memory" in text for text in said), said
