"""The kernel's Python package, installed into a fresh virtual environment."""

import shutil
import textwrap

import pytest
from conftest import EXAMPLES, ROOT, fresh_python, pip_install, run

SETUP = """
import ciel_mesh as cm, numpy as np, gc
def box(n, order=np.int64, real=np.float64):
    at = np.arange(n + 1)
    z, y, x = np.meshgrid(at, at, at, indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1).astype(real)
    ids = np.arange((n + 1) ** 3).reshape(n + 1, n + 1, n + 1)
    low, high = ids[:-1, :, :], ids[1:, :, :]
    ring = lambda of: [of[:, :-1, :-1], of[:, :-1, 1:], of[:, 1:, 1:], of[:, 1:, :-1]]
    connectivity = np.stack([a.ravel() for a in ring(low) + ring(high)], axis=1).astype(order)
    return points, np.full(n**3, 12, np.uint8), (8 * np.arange(n**3 + 1)).astype(order), connectivity.ravel()
"""


def check(python, code):
    return run(python, "-c", SETUP + textwrap.dedent(code))


def test_a_sphere_has_its_area(python):
    check(
        python,
        """
        points, types, offsets, connectivity = box(40)
        mesh = cm.Mesh.from_cells(points, types, offsets, connectivity)
        values = np.linalg.norm(points - 20, axis=1)
        surface = cm.contour(mesh, values, 10)
        a, b, c = (surface.points[surface.triangles[:, i]] for i in range(3))
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
        assert abs(area / (4 * np.pi * 100) - 1) < 0.01, area
        assert np.abs(np.linalg.norm(surface.points - 20, axis=1) - 10).max() < 0.05
        outwards = (surface.normals * (surface.points - 20)).sum(axis=1)
        assert outwards.min() > 0
        assert np.allclose(cm.interpolate(surface, mesh, values), 10, atol=1e-5)
        assert cm.interpolate(surface, mesh, points).shape == surface.points.shape
        assert np.allclose(cm.interpolate(surface, mesh, points), surface.points, atol=1e-4)
        """,
    )


def test_types_and_strides_give_the_same(python):
    check(
        python,
        """
        values = np.linalg.norm(box(6)[0] - 3, axis=1)
        wanted = cm.contour(cm.Mesh.from_cells(*box(6)), values, 2)
        for order in (np.int32, np.uint32, np.int64, np.uint64):
            for real in (np.float32, np.float64):
                points, types, offsets, connectivity = box(6, order, real)
                apart = np.full((len(points), 5), np.nan, real)[:, ::-1]
                apart[:, 1:4] = points
                mesh = cm.Mesh.from_cells(apart[:, 1:4], types, offsets, np.repeat(connectivity, 3)[::3])
                surface = cm.contour(mesh, np.asfortranarray(np.stack([values, values], axis=1))[:, 1], 2)
                assert np.array_equal(surface.points, wanted.points)
                assert np.array_equal(surface.polygon_vertex, wanted.polygon_vertex)
        """,
    )


def test_doubles_and_integers_are_not_rounded_to_floats(python):
    check(
        python,
        """
        points, types, offsets, connectivity = box(6)
        mesh = cm.Mesh.from_cells(points, types, offsets, connectivity)
        pressure = 101325 + 0.001 * points[:, 0]
        surface = cm.contour(mesh, pressure, 101325.0025)
        assert np.abs(surface.points[:, 0] - 2.5).max() < 1e-6
        found = cm.interpolate(surface, mesh, pressure)
        assert found.dtype == np.float64 and np.abs(found - 101325.0025).max() < 1e-9
        ids = 2**24 + points[:, 0].astype(np.int64)
        assert np.abs(cm.contour(mesh, ids, 2**24 + 2.5).points[:, 0] - 2.5).max() < 1e-6
        assert cm.interpolate(surface, mesh, points.astype(np.float32)).dtype == np.float32
        """,
    )


def test_points_of_thin_cells_are_had_in_double_precision(python):
    check(
        python,
        """
        points, types, offsets, connectivity = box(6)
        points[:, 2] = np.where(points[:, 2] < 3, 2e-6 * points[:, 2], 100 * points[:, 2])  # cells at a wall, a far field
        mesh = cm.Mesh.from_cells(points, types, offsets, connectivity)
        cut = cm.slice(mesh, (0, 0, 3e-6), (0, 0, 1))
        heights = cm.interpolate(cut, mesh, points)[:, 2]
        assert len(cut) == 36 and np.abs(heights - 3e-6).max() < 2e-9
        assert np.abs(cut.points[:, 2] - 3e-6).max() > 2e-6  # floats from the middle of the mesh cannot tell
        """,
    )


def test_a_slider_goes_on_through_time_and_moves(python):
    check(
        python,
        """
        points, types, offsets, connectivity = box(10)
        mesh = cm.Mesh.from_cells(points, types, offsets, connectivity)
        slider = cm.Contour(mesh, points[:, 0], normals=None)
        for level in (2.5, 7.25):
            assert np.allclose(slider.at(level).points[:, 0], level)
        slider.set(points[:, 1])
        assert np.allclose(slider.at(3.5).points[:, 1], 3.5)
        slider.set(points[:, 1], mesh.moved(2 * points))
        assert np.allclose(slider.at(3.5).points[:, 1], 7)
        assert slider.at(3.5).normals.shape == (0, 3)
        assert len(slider.at(99)) == 0 and slider.at(99).points.shape == (0, 3)
        """,
    )


def test_threads_that_share_a_slider_take_turns(python):
    check(
        python,
        """
        from concurrent.futures import ThreadPoolExecutor
        points, types, offsets, connectivity = box(30)
        slider = cm.Contour(cm.Mesh.from_cells(points, types, offsets, connectivity), points[:, 0])
        def cut(i):
            level = 1.5 + i % 27
            return np.allclose(slider.at(level).points[:, 0], level)
        with ThreadPoolExecutor(8) as threads:
            assert all(threads.map(cut, range(200)))
        """,
    )


def test_results_own_their_arrays(python):
    check(
        python,
        """
        surface = cm.contour(cm.Mesh.from_cells(*box(10)), np.linalg.norm(box(10)[0] - 5, axis=1), 3)
        kept = surface.points, surface.triangles, surface.polygon_cell, surface.normals
        copies = [array.copy() for array in kept]
        del surface
        gc.collect()
        for array, copy in zip(kept, copies):
            assert np.array_equal(array, copy)
        """,
    )


def test_slices_thresholds_lines_and_gradients(python):
    check(
        python,
        """
        points, types, offsets, connectivity = box(10)
        mesh = cm.Mesh.from_cells(points, types, offsets, connectivity)
        cut = cm.slice(mesh, (0, 0, 4.5), (0, 0, 3))
        assert np.allclose(cut.points[:, 2], 4.5) and len(cut) == 100
        lines = cm.contour_lines(cut, cm.interpolate(cut, mesh, points[:, 0]), [2.5, 3.25])
        assert lines.shape == (20, 2, 3) and set(np.round(lines[:, :, 0].ravel(), 4)) == {2.5, 3.25}
        kept = cm.threshold(mesh, points[:, 0], (0, 2))
        assert len(kept) == 2 * 100 + 4 * 20
        of_cells = cm.threshold(mesh, np.arange(1000), (0, 99), of_cells=True)
        assert len(of_cells) == 2 * 100 + 4 * 10
        gradient = cm.gradients(mesh, points @ [1.0, -2.0, 0.5])
        assert np.allclose(gradient, [1, -2, 0.5], atol=1e-5)
        """,
    )


def test_reports_and_errors_are_sentences(python):
    check(
        python,
        """
        points, types, offsets, connectivity = box(2)
        connectivity[-1] = 999
        mesh = cm.Mesh.from_cells(points, types, offsets, connectivity)
        assert mesh.report["bad_cells"] == {"index out of range": (1, [7])}, mesh.report
        def refused(call, words, kind=cm.Error):
            try:
                call()
            except kind as error:
                assert words in str(error), error
            else:
                raise AssertionError(words)
        refused(lambda: cm.contour(mesh, np.zeros(3), 1), "one number per point")
        refused(lambda: cm.Mesh.from_cells(points[:, :2], types, offsets, connectivity), "three numbers")
        refused(lambda: cm.Mesh.from_cells(points.astype(np.float16), types, offsets, connectivity), "float16", TypeError)
        refused(lambda: cm.Mesh.from_cells(points.astype(">f8"), types, offsets, connectivity), ">f8", TypeError)
        refused(lambda: cm.contour(mesh, points[:, 0], 1, algorithm="magic"), "magic", ValueError)
        refused(lambda: cm.Mesh.from_cells(points, types, offsets[:-1], connectivity), "one entry more")
        refused(lambda: cm.slice(mesh, (0, 0, 0), (0, 0, 0)), "not zero")
        assert issubclass(cm.Error, ValueError)
        """,
    )


def test_other_threads_work_while_the_kernel_does(python):
    check(
        python,
        """
        import threading, time
        points, types, offsets, connectivity = box(60)
        ticks = []
        done = threading.Event()
        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)
        other = threading.Thread(target=tick)
        other.start()
        begin = time.monotonic()
        cm.Mesh.from_cells(points, types, offsets, connectivity)
        end = time.monotonic()
        done.set()
        other.join()
        assert sum(begin < at < end for at in ticks) > 3
        """,
    )


def test_vtk_takes_a_surface_without_a_copy(python):
    check(
        python,
        """
        import vtk
        from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
        surface = cm.contour(cm.Mesh.from_cells(*box(10)), np.linalg.norm(box(10)[0] - 5, axis=1), 3)
        address = surface.polygon_vertex.ctypes.data
        assert surface.polygon_vertex.ctypes.data == address and not surface.normals.flags.writeable
        polygons = vtk.vtkCellArray()
        polygons.SetData(numpy_to_vtk(surface.polygon_offset), numpy_to_vtk(surface.polygon_vertex))
        assert polygons.GetNumberOfCells() == len(surface)
        assert vtk_to_numpy(polygons.GetConnectivityArray()).ctypes.data == address
        """,
    )


def test_vtk_grids_of_every_cell_give_vtks_surface(python):
    check(
        python,
        """
        import vtk
        from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
        def area_of(points, triangles):
            a, b, c = (points[triangles[:, i]] for i in range(3))
            return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
        for kind in (vtk.VTK_TETRA, vtk.VTK_HEXAHEDRON, vtk.VTK_WEDGE, vtk.VTK_PYRAMID, vtk.VTK_VOXEL, vtk.VTK_POLYHEDRON,
                     vtk.VTK_QUADRATIC_TETRA):
            source = vtk.vtkCellTypeSource()
            source.SetCellType(vtk.VTK_HEXAHEDRON if kind in (vtk.VTK_POLYHEDRON, vtk.VTK_VOXEL) else kind)
            source.SetBlocksDimensions(8, 8, 8)
            source.Update()
            grid = source.GetOutput()
            if kind == vtk.VTK_POLYHEDRON:
                poly = vtk.vtkUnstructuredGrid()
                poly.SetPoints(grid.GetPoints())
                for i in range(grid.GetNumberOfCells()):
                    cell = grid.GetCell(i)
                    stream = vtk.vtkIdList()
                    stream.InsertNextId(cell.GetNumberOfFaces())
                    for f in range(cell.GetNumberOfFaces()):
                        ids = cell.GetFace(f).GetPointIds()
                        stream.InsertNextId(ids.GetNumberOfIds())
                        for k in range(ids.GetNumberOfIds()):
                            stream.InsertNextId(ids.GetId(k))
                    poly.InsertNextCell(vtk.VTK_POLYHEDRON, stream)
                grid = poly
            points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
            values = points @ [1.0, 0.3, 0.2]
            array = numpy_to_vtk(values)
            array.SetName("v")
            grid.GetPointData().SetScalars(array)
            contour = vtk.vtkContourFilter()
            contour.SetInputData(grid)
            contour.SetValue(0, 5.1)
            mass = vtk.vtkTriangleFilter()
            mass.SetInputConnection(contour.GetOutputPort())
            mass.Update()
            out = mass.GetOutput()
            theirs = vtk_to_numpy(out.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
            wanted = area_of(vtk_to_numpy(out.GetPoints().GetData()).astype(float), theirs)
            surface = cm.contour(cm.from_vtk(grid), values, 5.1)
            ours = area_of(surface.points, surface.triangles)
            assert abs(ours - wanted) < 1e-4 * wanted, (kind, ours, wanted)
        """,
    )


def test_meshio_meshes_give_the_surface_of_their_cells(python, tmp_path):
    check(
        python,
        f"""
        import meshio
        points, types, offsets, connectivity = box(6)
        cells = connectivity.reshape(-1, 8)
        values = np.linalg.norm(points - 3, axis=1)
        wanted = cm.contour(cm.Mesh.from_cells(points, types, offsets, connectivity), values, 2)
        skin = ("triangle", cells[:7, :3])
        meshio.write({str(tmp_path / "box.msh")!r}, meshio.Mesh(points, [skin, ("hexahedron", cells)]), file_format="gmsh22")
        read = meshio.read({str(tmp_path / "box.msh")!r})
        assert [block.type for block in read.cells] == ["triangle", "hexahedron"]
        mesh = cm.from_meshio(read)
        assert mesh.report["skipped_cells"] == 7
        surface = cm.contour(mesh, values, 2)
        assert np.array_equal(surface.points, wanted.points)
        assert np.array_equal(surface.polygon_cell, wanted.polygon_cell + 7)
        sides = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
        faces = [[list(cell[side]) for side in sides] for cell in cells[1:]]
        blocks = [("hexahedron", cells[:1]), ("polyhedron8", faces[:100]), ("polyhedron8", faces[100:])]
        polyhedra = cm.contour(cm.from_meshio(meshio.Mesh(points, blocks)), values, 2)
        area = lambda s: np.linalg.norm(np.cross(*(s.points[s.triangles[:, i]] - s.points[s.triangles[:, 0]] for i in (1, 2))), axis=1).sum()
        assert np.array_equal(np.unique(polyhedra.polygon_cell), np.unique(wanted.polygon_cell))
        assert abs(area(polyhedra) / area(wanted) - 1) < 1e-3
        tetra = meshio.Mesh(points[:4], [("tetra10", np.arange(10)[None] % 4)])
        assert cm.from_meshio(tetra).report["reduced_cells"] == 1
        for bad, words in ((meshio.Mesh(points, [("hexahedron", cells[:0])]), "has no cells"),
                           (meshio.Mesh(points, [("VTK_LAGRANGE_WEDGE", cells[:1])]), "VTK_LAGRANGE_WEDGE")):
            try:
                cm.from_meshio(bad)
            except ValueError as error:
                assert words in str(error), error
            else:
                raise AssertionError(words)
        """,
    )


@pytest.mark.parametrize("script", [("slider.py", "0.5", "2"), ("with_vtk.py",)])
def test_examples_run(python, script):
    out = run(python, EXAMPLES / script[0], *script[1:])
    assert "triangles" in out or "area" in out


def test_the_version_is_that_of_the_project(python):
    said = run(python, "-c", "import ciel_mesh; print(ciel_mesh.__version__)")
    assert said.strip() == (ROOT / "server/ciel/version.txt").read_text().strip()


def test_the_types_are_there(python):
    code = "import ciel_mesh, pathlib; p = pathlib.Path(ciel_mesh.__file__).parent; print((p / 'py.typed').exists())"
    assert run(python, "-c", code).strip() == "True"


def test_the_source_distribution_installs(tmp_path):
    left_out = shutil.ignore_patterns(".git", "build*", "node_modules", "data")  # an old list of sources is in build
    source = shutil.copytree(ROOT, tmp_path / "source", ignore=left_out)
    run("/usr/bin/python3", "setup.py", "-q", "sdist", "--dist-dir", tmp_path, cwd=source)
    shutil.rmtree(source)
    (archive,) = tmp_path.glob("*.tar.gz")
    program = fresh_python(tmp_path / "venv")
    pip_install(program, archive)
    check(
        program,
        """
        points, types, offsets, connectivity = box(2)
        surface = cm.contour(cm.Mesh.from_cells(points, types, offsets, connectivity), points[:, 0], 0.5)
        assert len(surface) == 4
        """,
    )
