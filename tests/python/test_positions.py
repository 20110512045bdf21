"""Positions keep the precision of the imported file: in the dataset, in files, probes and pictures."""

import base64
import io
import json

import numpy as np
import pytest
import vtk
from PIL import Image
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from import_support import ciel_info, imported
from program import ciel
from serve_process import Server
from vtk_files import linear

SURVEY = np.array([500000.0, 4500000.0, -2500.0])
THINNEST, LAYERS = 2e-6, 40
PLAIN = {"background": "#000000", "lighting": {"on": False},
         "annotations": {"legend": False, "triad": False, "axes": False, "dataset": False, "time": False}}


def box(axes):
    """An unstructured grid of hexahedra between these coordinates, with the points in the type of the arrays."""
    shape = [len(axis) for axis in axes]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    ids = np.arange(len(points)).reshape(shape)
    corner = [ids[i:shape[0] - 1 + i, j:shape[1] - 1 + j, k:shape[2] - 1 + k].ravel()
              for i, j, k in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
    cells = np.stack(corner, axis=1)
    grid = vtk.vtkUnstructuredGrid()
    grid.Allocate(len(cells))
    for cell in cells:
        grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, cell.tolist())
    return with_points(grid, points)


def with_points(grid, points):
    held = vtk.vtkPoints()
    held.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=1))
    grid.SetPoints(held)
    return grid


def with_array(grid, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    grid.GetPointData().AddArray(array)
    return grid


def points_of(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())


def write(path, grid):
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.Write()
    return path


def read_surface(path):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def stored(dataset, mesh=0, coordinates=0):
    return dataset.mesh(mesh)["positions"][coordinates]


def in_order(points):
    return points[np.lexsort(points.T)]


@pytest.mark.parametrize("axis, kept", [
    (np.linspace(0, 1, 4), "f8"), (np.linspace(0, 1, 4).astype("f4"), "f4"), (np.linspace(0, 1, 5), "f4"),
    (np.linspace(0, 1, 4) + 4.5e6, "f8"), (np.array([-1e60, 0, 1e60]), "f8"), (np.array([0, 1e-60, 1]), "f8"),
])
def test_a_dataset_has_the_files_points_in_the_files_type(axis, kept, tmp_path):
    """Doubles that are all exact floats are stored as floats, without a loss."""
    source = box([axis, axis, axis])
    dataset = imported(tmp_path, write(tmp_path / "a.vtu", source))
    assert stored(dataset).dtype == np.dtype(kept)
    np.testing.assert_array_equal(stored(dataset), points_of(source)[dataset.mesh()["original_vertex"][:]])
    assert dataset.mesh().attrs["ciel"]["origin"] == [0, 0, 0]
    assert "32-bit" not in dataset.notes
    assert json.loads(ciel_info(dataset.path, "--json"))["mesh"]["positions"] == {"f4": "float32", "f8": "float64"}[kept]


def test_points_far_from_each_other_stay_different(tmp_path):
    """A cube of 0.1 and its copy 10,000 km away, where float32 values are one metre apart."""
    side = np.array([0, 0.1])
    source = box([np.concatenate([side, side + 1e7]), side, side])
    dataset = imported(tmp_path, write(tmp_path / "a.vtu", source))
    assert len(np.unique(stored(dataset), axis=0)) == 16
    assert dataset.volume() == pytest.approx(1e7 * 0.01 + 0.001, rel=1e-12)


def test_a_surface_has_the_corners_of_its_file_bit_for_bit(tmp_path):
    axis = np.linspace(0, 1, 6) ** 1.3 + 4.5e6
    source = box([axis, axis, axis])
    dataset = imported(tmp_path, write(tmp_path / "a.vtu", source))
    with Server(dataset.path) as server:
        scene = {"dataset": "out", "layers": {"a": {"type": "surface"}}}
        answer = server.call("surface.export", scene=scene, layer="a", format="vtp")
        (tmp_path / "s.vtp").write_bytes(base64.b64decode(answer["data"]))
        found = points_of(read_surface(tmp_path / "s.vtp"))
        sides = np.any((points_of(source) == axis[0]) | (points_of(source) == axis[-1]), axis=1)
        np.testing.assert_array_equal(in_order(found), in_order(points_of(source)[sides]))
        # A clip plane between two corners: the new corners are on it.
        scene["layers"]["c"] = {"type": "clip", "axis": "x", "value": 4.5e6 + 0.4321}
        answer = server.call("surface.export", scene=scene, layer="a", format="vtp")
        (tmp_path / "c.vtp").write_bytes(base64.b64decode(answer["data"]))
        cut = points_of(read_surface(tmp_path / "c.vtp"))
        assert cut[:, 0].max() == pytest.approx(4.5e6 + 0.4321, abs=2e-9)
        for vertex in (0, 100, 215):
            place = points_of(source)[vertex]
            assert server.call("probe.point", scene={"dataset": "out", "layers": {}}, position=list(place))["vertex"] == vertex


def test_a_mesh_in_survey_coordinates_gives_the_surfaces_of_the_same_mesh_at_zero(tmp_path):
    """Coordinates are multiples of 2^-20, so adding the whole numbers of SURVEY is exact."""
    axis = np.round(np.linspace(0, 1, 9) ** 1.2 * 2**20) / 2**20
    near = box([axis, axis, axis])
    field = np.sin(5 * points_of(near)).sum(axis=1) + linear(points_of(near))
    surfaces = []
    for name, shift in (("near", np.zeros(3)), ("far", SURVEY)):
        folder = tmp_path / name
        folder.mkdir()
        moved = with_array(with_points(near, points_of(near) + (shift if name == "far" else 0)), "f", field)
        dataset = imported(folder, write(folder / "a.vtu", moved))
        place = ",".join(repr(float(x)) for x in shift + np.array([0.25, 0, 0]))
        for kind in (("--iso", "f=1.7"), ("--slice", f"x={float(shift[0]) + 0.3!r}"), ("--plane", f"{place},1,0,0")):
            done = ciel("extract", dataset.path, *kind, "-o", folder / "s.vtp")
            assert done.returncode == 0, done.stderr
            surfaces.append(read_surface(folder / "s.vtp"))
    for here, there in zip(surfaces[:3], surfaces[3:]):
        assert here.GetNumberOfPolys() == there.GetNumberOfPolys() > 20
        np.testing.assert_array_equal(vtk_to_numpy(here.GetPolys().GetConnectivityArray()),
                                      vtk_to_numpy(there.GetPolys().GetConnectivityArray()))
        wanted = points_of(here) + SURVEY
        assert np.abs(points_of(there) - wanted).max(axis=0) == pytest.approx([0, 0, 0], abs=1e-9)
        assert (np.abs(points_of(there) - wanted) <= np.spacing(np.abs(wanted))).all()


def heights():
    growth = (100 / THINNEST) ** (1 / (LAYERS - 1))
    return np.concatenate([[0], THINNEST * growth ** np.arange(LAYERS)])


def boundary_layer(layers):
    """The lowest `layers` of all layers. Their height grows from 2e-6 at the wall z = 0 to a far field at z = 100."""
    grid = box([np.linspace(30, 31, 3), np.linspace(-50, 50, 3), heights()[:layers + 1]])
    level = np.searchsorted(heights(), points_of(grid)[:, 2])
    return with_array(with_array(grid, "layer", level.astype(float)), "height", points_of(grid)[:, 2])


@pytest.fixture(scope="module")
def walls(tmp_path_factory):
    """Two datasets: the boundary layer with its far field, and its 12 lowest layers alone."""
    made = {}
    for name, layers in (("whole", LAYERS), ("low", 12)):
        folder = tmp_path_factory.mktemp(name)
        made[name] = imported(folder, write(folder / "a.vtu", boundary_layer(layers)))
    return made


def test_a_boundary_layer_keeps_its_heights(walls, tmp_path):
    for layer in range(12):
        path = tmp_path / f"{layer}.vtp"
        done = ciel("extract", walls["whole"].path, "--iso", f"layer={layer + 0.5}", "--color", "height", "-o", path)
        assert done.returncode == 0, done.stderr
        surface = read_surface(path)
        middle = heights()[layer:layer + 2].mean()
        assert surface.GetNumberOfPolys() == 4
        assert np.abs(points_of(surface)[:, 2] - middle).max() <= 1e-3 * THINNEST
        np.testing.assert_allclose(vtk_to_numpy(surface.GetPointData().GetArray("height")), middle, rtol=1e-6)
        sliced = ciel("extract", walls["whole"].path, "--slice", f"z={float(middle)!r}", "-o", path)
        assert sliced.returncode == 0, sliced.stderr
        surface = read_surface(path)
        assert surface.GetNumberOfPolys() == 4
        assert np.abs(points_of(surface)[:, 2] - middle).max() <= 1e-3 * THINNEST


def test_a_probe_finds_the_cell_of_a_boundary_layer(walls):
    with Server(walls["whole"].path) as server:
        for layer in (0, 1, 5, 20):
            place = [30.2, 10, heights()[layer:layer + 2].mean()]
            answer = server.call("probe.point", scene={"dataset": "out", "layers": {}}, position=place)
            assert answer["values"]["layer"] == pytest.approx(layer + 0.5, abs=1e-6), layer


def picture(server, layer, camera):
    scene = {"dataset": "out", "layers": {"a": layer}, "camera": camera, **PLAIN}
    answer = server.call("picture.render", scene=scene, width=300, height=300)
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(answer["data"]))).convert("RGB")).astype(int)


@pytest.mark.parametrize("layer", [
    {"type": "slice", "axis": "y", "value": 20.0, "color": {"array": "layer", "range": [0, 12], "steps": 12}},
    {"type": "surface", "color": {"array": "layer", "range": [0, 12], "steps": 12}},
])
def test_a_picture_of_a_boundary_layer_is_that_of_its_lowest_cells_alone(walls, layer):
    """The camera sees only the lowest 2e-5 of a mesh that is 100 high."""
    seen = heights()[6] * 1.2
    front = 20.0 if layer["type"] == "slice" else -50.0
    camera = {"position": [30.4, front - 1, seen / 2], "target": [30.4, front, seen / 2], "up": [0, 0, 1],
              "parallel": True, "parallel_height": seen}
    pictures = []
    for name in ("whole", "low"):
        with Server(walls[name].path) as server:
            pictures.append(picture(server, layer, camera))
    whole, low = pictures
    assert len(np.unique(low.reshape(-1, 3), axis=0)) >= 6, "the layers are seen"
    assert (np.abs(whole - low).max(axis=2) > 8).mean() < 0.01


def test_a_mesh_that_moves_off_the_floats_keeps_all_its_points(tmp_path):
    """The points of the first two steps are exact floats. Later ones are not, so they are stored with a second mesh."""
    grid = box([np.linspace(0, 1, 5)] * 3)
    first = points_of(grid).copy()
    moved = [first, first + 0.25, first * 1.1, first * 1.2]
    for step, points in enumerate(moved):
        write(tmp_path / f"a_{step}.vtu", with_points(grid, points))
    files = "".join(f'<DataSet timestep="{step}" file="a_{step}.vtu"/>' for step in range(len(moved)))
    (tmp_path / "a.pvd").write_text(f'<VTKFile type="Collection"><Collection>{files}</Collection></VTKFile>')
    dataset = imported(tmp_path, tmp_path / "a.pvd")
    assert len(dataset.steps) == len(moved)
    for step, points in zip(dataset.steps, moved):
        mesh = step.get("mesh", 0)
        np.testing.assert_array_equal(stored(dataset, mesh, step.get("coordinates", 0)),
                                      points[dataset.mesh(mesh)["original_vertex"][:]])
    assert [step.get("mesh", 0) for step in dataset.steps] == [0, 0, 1, 1]
