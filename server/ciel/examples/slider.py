"""Example: a slider for iso-surfaces of a polyhedral mesh. With LEVEL... as arguments, it prints sizes instead."""

import sys

import ciel_mesh as cm
import numpy as np

# A honeycomb: columns of hexagonal prisms, each a polyhedron of eight faces.
i, j, k = np.mgrid[:20, :20, :20].reshape(3, -1, 1)
ring = 1.5 * i + 1j * np.sqrt(3) * (j + i % 2 / 2) + np.exp(1j * np.pi / 3 * np.arange(6))
corners = np.concatenate([np.stack([ring.real, ring.imag, (k + up) / 2 + 0 * ring.real], 2) for up in (0, 1)], 1)
points, ids = np.unique(corners.reshape(-1, 3).round(6) + 0.0, axis=0, return_inverse=True)
sides = [[a, (a + 1) % 6, (a + 1) % 6 + 6, a + 6] for a in range(6)]
faces = ids.reshape(-1, 12)[:, np.concatenate([range(5, -1, -1), range(6, 12), *sides])]
offset = np.append(0, np.cumsum(np.tile([6, 6, 4, 4, 4, 4, 4, 4], len(faces))))
values = np.sin(points[:, 0] / 4) + np.cos(points[:, 1] / 5) + points[:, 2] / 5
slider = cm.Contour(cm.Mesh.from_polyhedra(points, 8 * np.arange(len(faces) + 1), offset, faces.ravel()), values)
for level in map(float, sys.argv[1:]):
    print(f"{level}: {len(slider.at(level))} polygons, {len(slider.at(level).triangles)} triangles")
if len(sys.argv) == 1:
    import pyvista

    def show(level):
        surface = slider.at(level)
        triangles = np.insert(surface.triangles, 0, 3, axis=1)
        plotter.add_mesh(pyvista.PolyData(surface.points, triangles), name="surface")

    plotter = pyvista.Plotter()
    plotter.add_slider_widget(show, [values.min(), values.max()], title="level")
    plotter.show()
