"""The functions of the kernel's Python package: options, values of cells, several levels, sweeps, clips; its stubs."""

import ast
import re

from conftest import ROOT, run
from test_python import check

BOX = """
points, types, offsets, connectivity = box(24)
mesh = cm.Mesh.from_cells(points, types, offsets, connectivity)
values = np.linalg.norm(points - 12.1, axis=1)
centers = points[connectivity.reshape(-1, 8)].mean(axis=1)
def same(a, b):
    return all(np.array_equal(getattr(a, name), getattr(b, name)) for name in
               ("points", "normals", "polygon_offset", "polygon_vertex", "polygon_cell", "edges", "weights"))
"""


def test_options_go_with_every_cut(python):
    check(
        python,
        BOX
        + """
whole = cm.contour(mesh, values, 8)
assert mesh.block_count > 3
for threads in (1, 2, 5):
    assert same(cm.contour(mesh, values, 8, threads=threads), whole)
    assert same(cm.Contour(mesh, values, threads=threads).at(8), whole)
parts = [cm.contour(mesh, values, 8, blocks=[b]) for b in range(mesh.block_count)]
assert sum(map(len, parts)) == len(whole) and all(len(part) for part in parts)
for b, part in enumerate(parts):
    assert part.chunks.tolist() == [[b, 0, len(part)]]
plane = (12, 12, 12), (1, 2, 3)
cut = cm.slice(mesh, *plane)
assert same(cm.slice(mesh, *plane, algorithm="naive", threads=2), cut)
assert cm.slice(mesh, *plane, normals=None).normals.shape == (0, 3) != cut.normals.shape
assert sum(len(cm.slice(mesh, *plane, blocks=np.array([b]))) for b in range(mesh.block_count)) == len(cut)
try:
    cm.slice(mesh, *plane, blocks=[999])
except cm.Error as error:
    assert "block" in str(error), error
else:
    raise AssertionError("a block that is not there")
""",
    )


def test_several_levels_and_values_of_cells(python):
    check(
        python,
        BOX
        + """
levels = [3, 9.5, 6]
found = cm.contour(mesh, values, levels=levels)
assert len(found) == 3 and all(same(a, cm.contour(mesh, values, level)) for a, level in zip(found, levels))
assert cm.contour(mesh, values, levels=np.array([])) == []
inside = cm.contour(mesh, centers[:, 0], 8.25, of_cells=True)
assert np.allclose(inside.points[:, 0], 8.25, atol=1e-4)
assert same(inside, cm.contour(mesh, centers[:, 0], levels=[8.25], of_cells=True)[0])
slider = cm.Contour(mesh, centers[:, 0], of_cells=True)
assert same(slider.at(8.25), inside)
slider.set(centers[:, 1], of_cells=True)
assert np.allclose(slider.at(8.25).points[:, 1], 8.25, atol=1e-4)
slider.set(values)
assert same(slider.at(6), found[2])
table = cm.interpolate(inside, mesh, centers.astype(np.float32), of_cells=True)
assert table.shape == (len(inside.points), 3) and table.dtype == np.float32
assert np.allclose(table[:, 0], 8.25, atol=1e-4)
assert np.array_equal(cm.interpolate(inside, mesh, centers[:, 0].astype(np.float32), of_cells=True), table[:, 0])
for call in (lambda: cm.contour(mesh, values, 3, of_cells=True),
             lambda: cm.interpolate(inside, mesh, values, of_cells=True)):
    try:
        call()
    except cm.Error as error:
        assert "one number per cell" in str(error), error
    else:
        raise AssertionError("values of points as those of cells")
""",
    )


def test_sweeps_give_the_parts_of_each_surface(python):
    check(
        python,
        BOX
        + """
import threading
levels = [4, 9]
def parts_of(**options):
    cells, inside, most, lock = [[], []], 0, 0, threading.Lock()
    def keep(i, surface):
        nonlocal inside, most
        with lock:
            inside += 1
            most = max(most, inside)
        assert surface.chunks.shape == (1, 3) and surface.normals.shape == (0, 3)
        assert np.allclose(cm.interpolate(surface, mesh, values), levels[i])
        cells[i].extend(surface.polygon_cell.tolist())
        with lock:
            inside -= 1
    cm.sweep(mesh, values, levels, keep, **options)
    return [sorted(each) for each in cells], most
wanted = [sorted(cm.contour(mesh, values, level).polygon_cell.tolist()) for level in levels]
assert parts_of()[0] == wanted
for threads in (1, 2):
    cells, most = parts_of(threads=threads, algorithm="propagation")
    assert cells == wanted and most <= threads
def refuse(i, surface):
    raise LookupError("enough")
for threads in (1, 3):
    try:
        cm.sweep(mesh, values, levels, refuse, threads=threads)
    except LookupError as error:
        assert str(error) == "enough"
    else:
        raise AssertionError("the callback's error")
found = []
cm.sweep(mesh, centers[:, 0], [8.25], lambda i, surface: found.append(surface.points[:, 0]), of_cells=True)
assert np.allclose(np.concatenate(found), 8.25, atol=1e-4)
""",
    )


def test_clips_and_triangles(python):
    check(
        python,
        BOX
        + """
sphere = cm.contour(mesh, values, 8)
planes = [((0, 0, 10.25), (0, 0, 3)), ((13, 0, 0), (-1, 0, 0))]
part, heights = cm.clip(sphere, mesh, planes, points[:, 2])
assert heights.shape == (len(part.points),) and heights.dtype == np.float64
assert np.allclose(heights, part.points[:, 2], atol=1e-4)
assert abs(part.points[:, 2].min() - 10.25) < 1e-4 and abs(part.points[:, 0].max() - 13) < 1e-4
assert 0 < len(part) < len(sphere) and np.array_equal(cm.triangulate(part), part.triangles)
assert len(part.triangles) and part.triangles.shape[1] == 3
bare, none = cm.clip(sphere, mesh, planes)
assert none is None and np.array_equal(bare.points, part.points)
cut = cm.slice(mesh, (0, 0, 10.25), (0, 0, 1))
assert len(cm.clip(cut, mesh, [((0, 0, 10.26), (0, 0, 1))], slack=0.02)[0]) == len(cut)
for call, words in ((lambda: cm.interpolate(part, mesh, values), "before clipping"),
                    (lambda: cm.clip(part, mesh, planes, values), "before clipping"),
                    (lambda: cm.clip(sphere, mesh, [((0, 0, 0), (0, 0, 0))]), "not zero")):
    try:
        call()
    except cm.Error as error:
        assert words in str(error), error
    else:
        raise AssertionError(words)
""",
    )


def test_polyhedra_as_vtk_9_4_stores_them(python):
    """No supported system has VTK 9.4, so a grid with its two functions stands for one."""
    check(
        python,
        """
        import vtk
        from vtk.util.numpy_support import numpy_to_vtkIdTypeArray
        def lists(offsets, entries):
            out = vtk.vtkCellArray()
            out.SetData(*(numpy_to_vtkIdTypeArray(np.asarray(a, np.int64), deep=True) for a in (offsets, entries)))
            return out
        points, types, offsets, connectivity = box(6)
        at = vtk.vtkPoints()
        for point in points:
            at.InsertNextPoint(point)
        sides = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
        faces = connectivity.reshape(-1, 8)[:, sides].reshape(-1, 4)
        class Grid:
            polyhedra = True
            def GetPoints(self):
                return at
            def GetCells(self):
                return lists(offsets, connectivity)
            def GetCellTypesArray(self):
                return numpy_to_vtkIdTypeArray(np.full(len(types), 42 if self.polyhedra else 12, np.int64), deep=True)
            def GetPolyhedronFaces(self):
                return lists(4 * np.arange(len(faces) + 1), faces.ravel()) if self.polyhedra else None
            def GetPolyhedronFaceLocations(self):
                return lists(6 * np.arange(len(types) + 1), np.arange(len(faces))) if self.polyhedra else None
        values = np.linalg.norm(points - 3, axis=1)
        cubes = Grid()
        cubes.polyhedra = False
        found, wanted = (cm.contour(cm.from_vtk(grid), values, 2) for grid in (Grid(), cubes))
        assert cm.from_vtk(Grid()).report["bad_cells"] == {} and len(wanted) > 0
        assert np.array_equal(np.unique(found.polygon_cell), np.unique(wanted.polygon_cell))
        assert np.allclose(np.unique(found.points.round(4), axis=0), np.unique(wanted.points.round(4), axis=0))
        """,
    )


def stubbed():
    """Returns the parameters of each function and method in the stubs, one list per overload, and the properties."""
    tree = ast.parse((ROOT / "server/ciel/bindings/python/ciel_mesh/__init__.pyi").read_text())
    functions, properties = {}, set()

    def read(body, prefix):
        for each in body:
            if isinstance(each, ast.ClassDef):
                read(each.body, each.name + ".")
            elif isinstance(each, ast.FunctionDef):
                name = prefix + each.name
                if any(isinstance(mark, ast.Name) and mark.id == "property" for mark in each.decorator_list):
                    properties.add(name)
                    continue
                star = ["*"] if each.args.kwonlyargs else []
                given = [arg.arg for arg in each.args.args] + star + [arg.arg for arg in each.args.kwonlyargs]
                functions.setdefault(name, []).append([part for part in given if part != "self"])

    read(tree.body, "")
    return functions, properties


MODULE = r"""
import inspect, json
import ciel_mesh as cm
functions, properties = {}, []
def parameters(call):
    return [list(inspect.signature(call).parameters)] if inspect.isfunction(call) else call.__doc__
def read(of, names, prefix):
    for name in names:
        what = vars(of)[name]
        if isinstance(what, property):
            properties.append(prefix + name)
        elif inspect.isclass(what):
            public = [n for n in vars(what) if not n.startswith("_") or n in ("__init__", "__len__")]
            read(what, [] if what is cm.Error else public, name + ".")
        else:
            functions[prefix + name] = parameters(getattr(of, name))
read(cm, cm.__all__, "")
print(json.dumps([functions, properties]))
"""


def signatures(name, text):
    """Returns the parameter names in each signature of a docstring of pybind11."""
    found = []
    for inside in re.findall(rf"^(?:\d+\. )?{name}\((.*)\) -> ", text, re.MULTILINE):
        while "[" in inside:  # the arguments of types, which have commas of their own
            inside = re.sub(r"\[[^\[\]]*\]", "", inside)
        names = [part.split(":")[0].split("=")[0].strip() for part in inside.split(",")]
        if names != ["*args", "**kwargs"]:
            found.append([part for part in names if part not in ("self", "")])
    return found


def test_the_stubs_are_those_of_the_module(python):
    functions, properties = ast.literal_eval(run(python, "-c", MODULE))
    said = {}
    for name, what in functions.items():
        found = signatures(name.split(".")[-1], what) if isinstance(what, str) else what
        if found or not name.endswith("__init__"):  # only Contour can be constructed
            said[name] = found
    wanted, wanted_properties = stubbed()
    assert set(properties) == wanted_properties
    assert said == wanted
