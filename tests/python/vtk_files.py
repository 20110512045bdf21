"""Small meshes written by VTK's writers, in every volume format that they support."""

import itertools

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk


def linear(points):
    """A linear field, which every import must keep exactly."""
    p = np.asarray(points, dtype=float)
    return 2 * p[:, 0] - 3 * p[:, 1] + 0.5 * p[:, 2] + 1


def add_array(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=1)
    array.SetName(name)
    attributes.AddArray(array)


def points_of(data):
    return np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])


def centers_of(data):
    centers = []
    for i in range(data.GetNumberOfCells()):
        ids = data.GetCell(i).GetPointIds()
        centers.append(np.mean([data.GetPoint(ids.GetId(j)) for j in range(ids.GetNumberOfIds())], axis=0))
    return np.array(centers)


def with_fields(data, shift=0.0):
    p = points_of(data)
    add_array(data.GetPointData(), "f", linear(p) + shift)
    add_array(data.GetPointData(), "v", p + shift)
    add_array(data.GetCellData(), "c", linear(centers_of(data)) + shift)
    return data


def image(n=4, origin=(0, 0, 0)):
    data = vtk.vtkImageData()
    data.SetDimensions(n, n, n)
    data.SetSpacing(1 / (n - 1), 1 / (n - 1), 1 / (n - 1))
    data.SetOrigin(*origin)
    return data


def rectilinear(n=4):
    data = vtk.vtkRectilinearGrid()
    data.SetDimensions(n, n, n)
    axis = numpy_to_vtk(np.linspace(0, 1, n) ** 2, deep=1)
    data.SetXCoordinates(axis), data.SetYCoordinates(axis), data.SetZCoordinates(axis)
    return data


def structured(n=4, bend=0.2):
    data = vtk.vtkStructuredGrid()
    data.SetDimensions(n, n, n)
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for k in range(n):
        for j in range(n):
            for i in range(n):
                x, y, z = i / (n - 1), j / (n - 1), k / (n - 1)
                points.InsertNextPoint(x + bend * y * (1 - y), y, z)
    data.SetPoints(points)
    return data


def ring(n_around=12, n_radial=4, n_axial=3):
    """An O-grid whose first and last planes around the axis coincide."""
    data = vtk.vtkStructuredGrid()
    data.SetDimensions(n_radial, n_around + 1, n_axial)
    points = vtk.vtkPoints()
    for k in range(n_axial):
        for j in range(n_around + 1):
            angle = 2 * np.pi * (j % n_around) / n_around
            for i in range(n_radial):
                points.InsertNextPoint((1 + i) * np.cos(angle), (1 + i) * np.sin(angle), k)
    data.SetPoints(points)
    return data


def unstructured(cells, points):
    """`cells`: (VTK type, node ids), or (VTK_POLYHEDRON, [faces])."""
    grid = vtk.vtkUnstructuredGrid()
    p = vtk.vtkPoints()
    p.SetDataTypeToDouble()
    for point in points:
        p.InsertNextPoint(*point)
    grid.SetPoints(p)
    for kind, nodes in cells:
        if kind == vtk.VTK_POLYHEDRON:
            stream = vtk.vtkIdList()
            stream.InsertNextId(len(nodes))
            for face in nodes:
                stream.InsertNextId(len(face))
                for node in face:
                    stream.InsertNextId(node)
            grid.InsertNextCell(kind, stream)
        else:
            grid.InsertNextCell(kind, len(nodes), nodes)
    return grid


CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
CUBE_FACES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def mixed():
    """A hexahedron, a wedge, a pyramid, a tetrahedron and a polyhedron (a cube), with matching faces."""
    points = CUBE + [(2, 0.5, 0), (2, 0.5, 1), (0.5, 0.5, 2), (0.5, -1, 1.5)]
    points += [(x, y, z - 1) for x, y, z in CUBE[:4]]
    cube = [12, 13, 14, 15, 0, 1, 2, 3]  # below the hexahedron
    return unstructured(
        [
            (vtk.VTK_HEXAHEDRON, list(range(8))),
            (vtk.VTK_WEDGE, [1, 2, 8, 5, 6, 9]),
            (vtk.VTK_PYRAMID, [4, 5, 6, 7, 10]),
            (vtk.VTK_TETRA, [4, 5, 10, 11]),
            (vtk.VTK_POLYHEDRON, [[cube[i] for i in face] for face in CUBE_FACES]),
        ],
        points,
    )


def cones(n, first):
    """Two polyhedra of n + 1 faces: the cones on the two sides of a polygon."""
    angle = 2 * np.pi * np.arange(n) / n
    points = [*zip(np.cos(angle) - 3, np.sin(angle), 0 * angle), (-3, 0, -1), (-3, 0, 1)]

    def cone(base, apex):
        return vtk.VTK_POLYHEDRON, [base, *([b, a, apex] for a, b in zip(base, base[1:] + base[:1]))]

    rim = list(range(first, first + n))
    return [cone(rim, first + n), cone(rim[::-1], first + n + 1)], points


def all_types(n=12):
    """n^3 cubes, by slabs of x: hexahedra; wedges; pyramids and tetrahedra. Beside them are two cones."""
    points = [(x, y, z) for z in range(n + 1) for y in range(n + 1) for x in range(n + 1)]
    cells = []
    for z, y, x in itertools.product(range(n), repeat=3):
        cube = [x + i + (n + 1) * (y + j + (n + 1) * (z + k)) for i, j, k in CUBE]
        if x % 3 == 0:
            cells.append((vtk.VTK_HEXAHEDRON, cube))
        elif x % 3 == 1:
            cells += [(vtk.VTK_WEDGE, [cube[i] for i in corners]) for corners in ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7))]
        else:
            center = len(points)
            points.append((x + 0.5, y + 0.5, z + 0.5))
            for of_cube in CUBE_FACES:
                a, b, c, d = (cube[i] for i in of_cube[::-1])
                if of_cube == CUBE_FACES[1 - z % 2]:  # triangles, also in the cube on the other side
                    cells += [(vtk.VTK_TETRA, [a, b, c, center]), (vtk.VTK_TETRA, [a, c, d, center])]
                else:
                    cells.append((vtk.VTK_PYRAMID, [a, b, c, d, center]))
    more, around = cones(300, len(points))
    return unstructured(cells + more, points + around)


def write(writer, path, data, **settings):
    writer.SetFileName(str(path))
    for name, value in settings.items():
        getattr(writer, name)(value)
    writer.SetInputData(data)
    assert writer.Write() == 1
    return path


def multi_block(*blocks):
    data = vtk.vtkMultiBlockDataSet()
    for i, (name, block) in enumerate(blocks):
        data.SetBlock(i, block)
        data.GetMetaData(i).Set(vtk.vtkCompositeDataSet.NAME(), name)
    return data


def hexahedra(n):
    """Points and cells (rows of 8 in VTK's order) of the unit cube as n x n x n hexahedra, x fastest."""
    axis = np.arange(n + 1) / n
    points = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).transpose(2, 1, 0, 3).reshape(-1, 3)
    k, j, i = np.meshgrid(*[np.arange(n)] * 3, indexing="ij")
    first = (i + (n + 1) * (j + (n + 1) * k)).ravel()
    row, slab = n + 1, (n + 1) ** 2
    return points, first[:, None] + np.array([0, 1, 1 + row, row, slab, 1 + slab, 1 + row + slab, row + slab])
