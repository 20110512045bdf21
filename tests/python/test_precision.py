"""Values keep the precision of the imported file: in the dataset, on surfaces, in probes, histograms and colors."""

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
from vtk_files import centers_of, image, points_of

FAR, REACH = 101325.0, 0.01
EMPTY = {"dataset": "out", "layers": {}}
N = 9


def pressure(points):
    return FAR + REACH * np.sin(7 * points[:, 0] + 3 * points[:, 1])


def add(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    attributes.AddArray(array)


@pytest.fixture(scope="module")
def source():
    """A box whose values of each type differ by less than float32 can tell."""
    data = image(N)
    points, centers = points_of(data), centers_of(data)
    add(data.GetPointData(), "p", pressure(points))
    add(data.GetPointData(), "near", pressure(points) - FAR)
    add(data.GetPointData(), "small", pressure(points).astype("f4"))
    add(data.GetPointData(), "U", np.stack([pressure(points), 1 / (3 + points[:, 0]), points[:, 1]], axis=1))
    add(data.GetCellData(), "q", pressure(centers))
    add(data.GetCellData(), "id", 2**24 + np.arange(len(centers), dtype="i4"))
    add(data.GetCellData(), "short", np.arange(len(centers), dtype="i2"))
    return data


@pytest.fixture(scope="module")
def dataset(source, tmp_path_factory):
    folder = tmp_path_factory.mktemp("precision")
    writer = vtk.vtkXMLImageDataWriter()
    writer.SetFileName(str(folder / "a.vti"))
    writer.SetInputData(source)
    writer.Write()
    return imported(folder, folder / "a.vti")


@pytest.fixture(scope="module")
def server(dataset):
    with Server(dataset.path) as running:
        yield running


def of_points(source, name):
    return vtk_to_numpy(source.GetPointData().GetArray(name))


def of_cells(source, name):
    return vtk_to_numpy(source.GetCellData().GetArray(name))


def test_a_dataset_has_the_files_numbers_in_the_files_type(source, dataset):
    vertices = dataset.mesh()["original_vertex"][:]
    cells = dataset.mesh()["original_cell"][:]
    for name in ("p", "small", "U"):
        stored = dataset.values(name)
        assert stored.dtype == of_points(source, name).dtype, name
        np.testing.assert_array_equal(stored, of_points(source, name)[vertices])
    for name, kind in (("q", "f8"), ("id", "f8"), ("short", "f4")):
        stored = dataset.values(f"cell:{name}")
        assert stored.dtype == np.dtype(kind), name
        np.testing.assert_array_equal(stored, of_cells(source, name)[cells])
    assert len(np.unique(dataset.values("cell:id"))) == len(cells)
    assert dataset.values("q").dtype == np.float64, "made from cells"
    assert "32-bit" not in dataset.notes


def test_info_says_types_and_a_range_with_two_ends(dataset):
    text = ciel_info(dataset.path)
    assert "original int32, stored as float64" in text.replace(" from a.vti", "")
    assert "[101324.99, 101325.01]" in text
    arrays = {array["name"]: array for array in json.loads(ciel_info(dataset.path, "--json"))["arrays"]}
    assert [arrays[name]["stored"] for name in ("p", "small", "cell:id", "cell:short")] == [
        "float64", "float32", "float64", "float32"]


def test_probes_answer_the_files_numbers_bit_for_bit(source, dataset, server):
    points, centers = points_of(source), centers_of(source)
    for vertex in (0, 17, 300, N**3 - 1):
        answer = server.call("probe.point", scene=EMPTY, position=list(points[vertex]))
        assert answer["vertex"] == vertex
        assert answer["values"]["p"] == of_points(source, "p")[vertex]
        assert answer["values"]["U:y"] == of_points(source, "U")[vertex, 1]
    for cell in (0, 5, 200, (N - 1) ** 3 - 1):
        values = server.call("probe.point", scene=EMPTY, position=list(centers[cell]))["values"]
        assert values["cell:q"] == of_cells(source, "q")[cell]
        assert values["cell:id"] == of_cells(source, "id")[cell]


def test_a_probe_at_a_corner_of_tetrahedra_answers_the_files_number(tmp_path):
    random = np.random.default_rng(1)
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(random.random((40, 3)), deep=1))
    corners = vtk.vtkPolyData()
    corners.SetPoints(points)
    mesh = vtk.vtkDelaunay3D()
    mesh.SetInputData(corners)
    mesh.Update()
    grid = mesh.GetOutput()
    add(grid.GetPointData(), "p", FAR + random.random(40))
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(tmp_path / "a.vtu"))
    writer.SetInputData(grid)
    writer.Write()
    with Server(imported(tmp_path, tmp_path / "a.vtu").path) as running:
        for vertex, position in enumerate(points_of(grid).tolist()):
            answer = running.call("probe.point", scene=EMPTY, position=position)
            assert answer["values"]["p"] == of_points(grid, "p")[vertex]


def test_an_iso_surface_lies_where_the_doubles_have_the_value(dataset, tmp_path):
    value = FAR + 0.4 * REACH
    path = tmp_path / "s.vtp"
    done = ciel("extract", dataset.path, "--iso", f"p={value!r}", "--color", "p", "--color", "U:y", "--color", "small",
                "-o", path)
    assert done.returncode == 0, done.stderr
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    surface = reader.GetOutput()
    assert surface.GetNumberOfPoints() > 100
    arrays = {name: vtk_to_numpy(surface.GetPointData().GetArray(name)) for name in ("p", "U:y", "small")}
    assert [arrays[name].dtype for name in arrays] == ["f8", "f8", "f4"]
    np.testing.assert_allclose(arrays["p"], value, rtol=0, atol=1e-9)
    points = vtk_to_numpy(surface.GetPoints().GetData())
    np.testing.assert_allclose(pressure(points), value, rtol=0, atol=0.1 * REACH)


def test_a_histogram_has_more_bins_than_floats_have_values(server):
    whole = server.call("dataset.histogram", dataset="out", array="p", bins=50)
    rounded = server.call("dataset.histogram", dataset="out", array="small", bins=50)
    assert sum(count > 0 for count in whole["counts"]) > 40
    assert sum(count > 0 for count in rounded["counts"]) <= 4


def picture(server, layer):
    """The colors of a picture of the one layer, without annotations."""
    scene = {"dataset": "out", "layers": {"a": layer}, "background": "#000000", "lighting": {"on": False},
             "annotations": {"legend": False, "triad": False, "axes": False, "dataset": False, "time": False}}
    answer = server.call("picture.render", scene=scene, width=300, height=300)
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(answer["data"]))).convert("RGB"))


@pytest.mark.parametrize("layer", [
    {"type": "slice", "axis": "z", "value": 0.45},
    {"type": "surface"},
    {"type": "volume", "array": "{}"},
])
def test_colors_are_those_of_the_same_values_around_zero(server, layer):
    def of(array):
        shown = {key: value.format(array) if isinstance(value, str) else value for key, value in layer.items()}
        return {**shown, "color": {"array": array} if layer["type"] != "volume" else {}}

    near, doubles, floats = (picture(server, of(array)).astype(int) for array in ("near", "p", "small"))
    assert (near.max(axis=2) > 0).mean() > 0.1 and len(np.unique(near.reshape(-1, 3), axis=0)) > 50
    assert np.abs(doubles - near).max() <= 4
    assert np.abs(floats - near).max() > 30, "the test can see what is lost"


def test_a_threshold_tells_integers_apart(server):
    scene = {"dataset": "out", "layers": {"a": {
        "type": "surface", "threshold": {"array": "cell:id", "range": [2**24 + 1, 2**24 + 1]}}}}
    answer = server.call("surface.export", scene=scene, layer="a", format="ply")
    assert answer["polygons"] == 6, "the faces of one cell"


def test_integers_that_no_float_holds_are_told(tmp_path):
    data = image(3)
    add(data.GetCellData(), "id", 2**60 + np.arange(8, dtype="i8"))
    writer = vtk.vtkXMLImageDataWriter()
    writer.SetFileName(str(tmp_path / "a.vti"))
    writer.SetInputData(data)
    writer.Write()
    notes = imported(tmp_path, tmp_path / "a.vti").notes
    assert "7 of 8 values of \"cell:id\" are integers beyond 9,007,199,254,740,992 that a 64-bit float" in notes


@pytest.mark.parametrize("kind", ["i4", "u4"])
def test_the_largest_integer_that_a_double_holds_is_no_loss(tmp_path, kind):
    data = image(3)
    add(data.GetCellData(), "id", np.full(8, np.iinfo(kind).max, dtype=kind))
    writer = vtk.vtkXMLImageDataWriter()
    writer.SetFileName(str(tmp_path / "a.vti"))
    writer.SetInputData(data)
    writer.Write()
    assert "integers beyond" not in imported(tmp_path, tmp_path / "a.vti").notes
