"""vtkUnstructuredGrid, and PyVista's, as a Mesh."""

import numpy

from ._kernel import Mesh


def _numpy(array):
    from vtkmodules.util.numpy_support import vtk_to_numpy

    return None if array is None else vtk_to_numpy(array)


def _polyhedra(grid):
    """The faces of polyhedra, as this VTK stores them: from 9.4 on as two cell arrays, before as one stream."""
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
    """The Mesh of a vtkUnstructuredGrid or of a PyVista UnstructuredGrid.

    Values of its points, as NumPy arrays, are in the order that contour() and the others want. Needs the vtk package.
    """
    cells = grid.GetCells()
    types = _numpy(grid.GetCellTypesArray())
    if types is None or grid.GetPoints() is None:
        raise ValueError("the grid has no cells; read or make them first")
    return Mesh.from_cells(
        _numpy(grid.GetPoints().GetData()),
        numpy.asarray(types),
        _numpy(cells.GetOffsetsArray()),
        _numpy(cells.GetConnectivityArray()),
        **_polyhedra(grid),
    )
