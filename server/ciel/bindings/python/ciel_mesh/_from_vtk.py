"""Converts a vtkUnstructuredGrid or a PyVista UnstructuredGrid to a Mesh."""

import numpy

from ._kernel import Mesh


def _numpy(array):
    from vtkmodules.util.numpy_support import vtk_to_numpy

    return None if array is None else vtk_to_numpy(array)


def _polyhedra(grid):
    """Return the faces of polyhedra as keyword arguments of Mesh.from_cells.

    From version 9.4 on, VTK stores the faces as two cell arrays. Older versions store the faces as one stream.
    """
    if hasattr(grid, "GetPolyhedronFaces"):
        faces, of_cells = grid.GetPolyhedronFaces(), grid.GetPolyhedronFaceLocations()
        if faces is None or of_cells is None:
            return {}
        return {
            "cell_face_offsets": _numpy(of_cells.GetOffsetsArray()),
            "cell_faces": _numpy(of_cells.GetConnectivityArray()),
            "face_offsets": _numpy(faces.GetOffsetsArray()),
            "face_connectivity": _numpy(faces.GetConnectivityArray()),
        }
    if grid.GetFaces() is None:
        return {}
    return {"face_locations": _numpy(grid.GetFaceLocations()), "faces": _numpy(grid.GetFaces())}


def from_vtk(grid):
    """Return the Mesh of a vtkUnstructuredGrid or of a PyVista UnstructuredGrid.

    Points and cells have the same numbers as in `grid`, so that point arrays of `grid` can be passed to contour().
    Raises ValueError if `grid` has no cells or no points. Needs the vtk package.
    """
    cells = grid.GetCells()
    types = _numpy(grid.GetCellTypesArray())
    if types is None or grid.GetPoints() is None:
        raise ValueError("the grid has no points or no cells; pass a grid that has both")
    return Mesh.from_cells(
        _numpy(grid.GetPoints().GetData()),
        numpy.asarray(types),
        _numpy(cells.GetOffsetsArray()),
        _numpy(cells.GetConnectivityArray()),
        **_polyhedra(grid),
    )
