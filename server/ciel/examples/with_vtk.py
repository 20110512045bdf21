"""Example: cuts a vtkUnstructuredGrid with ciel_mesh and with VTK, and compares the areas of the surfaces."""

import ciel_mesh as cm
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

source = vtk.vtkCellTypeSource()
source.SetCellType(vtk.VTK_WEDGE)
source.SetBlocksDimensions(12, 12, 12)
source.Update()
grid = source.GetOutput()
points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
values = np.linalg.norm(points - points.mean(axis=0), axis=1)
array = numpy_to_vtk(values)
array.SetName("distance")
grid.GetPointData().SetScalars(array)

surface = cm.contour(cm.from_vtk(grid), values, 4)
a, b, c = (surface.points[surface.triangles[:, i]] for i in range(3))
area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2

contour = vtk.vtkContourFilter()
contour.SetInputData(grid)
contour.SetValue(0, 4)
triangles = vtk.vtkTriangleFilter()
triangles.SetInputConnection(contour.GetOutputPort())
mass = vtk.vtkMassProperties()
mass.SetInputConnection(triangles.GetOutputPort())
mass.Update()
print(f"area {area:.3f} here, {mass.GetSurfaceArea():.3f} by VTK")
assert abs(area - mass.GetSurfaceArea()) < 0.01 * area
