"""Iso-surfaces and slices of polyhedral meshes, computed incrementally from one value to the next.

Circular incident edge lists (Levy, Caumon, Conreaux, Cavin, IEEE Visualization 2001): tetrahedra, hexahedra, wedges,
pyramids and arbitrary polyhedra. NumPy arrays in and out.

    import ciel_mesh as cm
    mesh = cm.from_vtk(grid)                      # or cm.Mesh.from_cells(points, types, offsets, connectivity)
    surface = cm.contour(mesh, pressure, 101325)  # surface.points, surface.triangles
"""

from importlib.metadata import version

from ._from_meshio import from_meshio
from ._from_vtk import from_vtk
from ._kernel import (
    Contour,
    Error,
    Mesh,
    Surface,
    clip,
    contour,
    contour_lines,
    gradients,
    interpolate,
    slice,
    sweep,
    threshold,
    triangulate,
)

__all__ = [
    "Contour",
    "Error",
    "Mesh",
    "Surface",
    "clip",
    "contour",
    "contour_lines",
    "from_meshio",
    "from_vtk",
    "gradients",
    "interpolate",
    "slice",
    "sweep",
    "threshold",
    "triangulate",
]
__version__ = version("ciel-mesh")
