"""A block of hexahedra as an OpenFOAM case, with any number of cells along each axis and any patch type on each side."""

import itertools

import numpy as np
from openfoam_files import field, side_of, write_control, write_mesh

SIDES = ("left", "right", "front", "back", "bottom", "top")  # low and high side along x, y, z


class Block:
    """`types`: patch type of each side; `wall` by default. `place`: maps the points, [n, 3] -> [n, 3]."""

    def __init__(self, cells, types=None, place=lambda points: points):
        self.cells = cells
        nx, ny, nz = cells
        self.types = {side: (types or {}).get(side, "wall") for side in SIDES}
        grid = [(i / nx, j / ny, k / nz) for k in range(nz + 1) for j in range(ny + 1) for i in range(nx + 1)]
        self.points = place(np.array(grid))
        self.inner, self.outer = [], {side: [] for side in SIDES}
        for k, j, i in itertools.product(range(nz), range(ny), range(nx)):
            self._add_cell((i, j, k))
        self.inner.sort(key=lambda face: face[:2])

    def _add_cell(self, here):
        nx, ny, nz = self.cells
        point = lambda i, j, k: i + (nx + 1) * (j + (ny + 1) * k)
        cell = lambda i, j, k: i + nx * (j + ny * k)
        for axis, side in itertools.product(range(3), (0, 1)):
            loop = side_of(here, axis, side, point)
            other = list(here)
            other[axis] += 1 if side else -1
            if not 0 <= other[axis] < self.cells[axis]:
                self.outer[SIDES[2 * axis + side]].append((cell(*here), loop))
            elif side:
                self.inner.append((cell(*here), cell(*other), loop))

    def centers(self):
        """Means of the cells' corners, which are the centroids for parallelepipeds."""
        corners = [set() for _ in range(np.prod(self.cells))]
        for owner, neighbour, loop in self.inner:
            corners[owner].update(loop)
            corners[neighbour].update(loop)
        for owner, loop in itertools.chain(*self.outer.values()):
            corners[owner].update(loop)
        return np.array([self.points[list(ids)].mean(axis=0) for ids in corners])

    def face_centers(self, side):
        return np.array([self.points[loop].mean(axis=0) for _, loop in self.outer[side]])

    def write(self, case, fields):
        """`fields`: name -> (values in the cells, {side: boundary entry})."""
        write_control(case)
        write_mesh(case / "constant/polyMesh", self.points, self.inner, self.outer, {s: f"type {t};" for s, t in self.types.items()})
        (case / "1").mkdir()
        for name, (values, entries) in fields.items():
            kind = "volVectorField" if np.ndim(values) == 2 else "volScalarField"
            (case / "1" / name).write_text(field(kind, name, "[0 1 -1 0 0 0 0]", values, entries))
        return case


def listed(values):
    """The `value` entry of a boundary condition with one value for each face."""
    text = lambda v: "(" + " ".join(map(repr, map(float, v))) + ")" if np.ndim(v) else repr(float(v))
    kind = "vector" if np.ndim(values) == 2 else "scalar"
    return f"value nonuniform List<{kind}> {len(values)}({' '.join(map(text, values))});"
