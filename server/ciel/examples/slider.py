"""Example: a slider over a polyhedral mesh.

python3 slider.py opens a window with the slider. python3 slider.py LEVEL... prints the surface's size at each level.
"""

import sys

import ciel_mesh as cm
import numpy as np

# A honeycomb: columns of hexagonal prisms, each a polyhedron of eight faces.
corner = np.exp(1j * np.pi / 3 * np.arange(6))
centres = [complex(1.5 * i, np.sqrt(3) * (j + i % 2 / 2)) for i in range(20) for j in range(20)]
ring = np.unique(np.round([c + corner for c in centres], 6))
of = {tuple(np.round([z.real, z.imag], 6)): i for i, z in enumerate(ring)}
layers = 21
points = np.array([[z.real, z.imag, 0.5 * k] for k in range(layers) for z in ring])
faces, cells = [], [0]
for k in range(layers - 1):
    for c in centres:
        low = [of[tuple(np.round([z.real, z.imag], 6))] + k * len(ring) for z in np.round(c + corner, 6)]
        high = [v + len(ring) for v in low]
        sides = [[low[i], low[(i + 1) % 6], high[(i + 1) % 6], high[i]] for i in range(6)]
        faces += [low[::-1], high, *sides]
        cells.append(len(faces))
offset = np.cumsum([0, *map(len, faces)])

mesh = cm.Mesh.from_polyhedra(points, np.array(cells), offset, np.concatenate(faces))
values = np.sin(points[:, 0] / 4) + np.cos(points[:, 1] / 5) + points[:, 2] / 5
slider = cm.Contour(mesh, values)
if len(sys.argv) > 1:
    for level in map(float, sys.argv[1:]):
        surface = slider.at(level)
        print(f"{level}: {len(surface)} polygons, {len(surface.triangles)} triangles")
    sys.exit()

import pyvista  # noqa: E402


def show(level):
    surface = slider.at(level)
    triangles = np.column_stack([np.full(len(surface.triangles), 3), surface.triangles])
    plotter.add_mesh(pyvista.PolyData(surface.points, triangles.ravel()), name="surface")


plotter = pyvista.Plotter()
plotter.add_slider_widget(show, [values.min(), values.max()], title="level")
plotter.show()
