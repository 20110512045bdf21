from collections.abc import Sequence
from typing import Any, Literal

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str

Algorithm = Literal["signatures", "propagation", "naive"]
Decider = Literal["isolate-high", "asymptotic"]
Normals = Literal["gradient", "polygons"]

class Error(ValueError): ...

class Mesh:
    @staticmethod
    def from_cells(
        points: NDArray[Any],
        types: NDArray[Any],
        offsets: NDArray[Any],
        connectivity: NDArray[Any],
        *,
        face_locations: NDArray[Any] | None = None,
        faces: NDArray[Any] | None = None,
        cell_face_offsets: NDArray[Any] | None = None,
        cell_faces: NDArray[Any] | None = None,
        face_offsets: NDArray[Any] | None = None,
        face_connectivity: NDArray[Any] | None = None,
    ) -> Mesh: ...
    @staticmethod
    def from_polyhedra(
        points: NDArray[Any], cell_offset: NDArray[Any], face_offset: NDArray[Any], face_vertex: NDArray[Any]
    ) -> Mesh: ...
    @staticmethod
    def from_faces(
        points: NDArray[Any],
        face_offset: NDArray[Any],
        face_vertex: NDArray[Any],
        owner: NDArray[Any],
        neighbour: NDArray[Any],
    ) -> Mesh: ...
    def moved(self, points: NDArray[Any]) -> Mesh: ...
    @property
    def point_count(self) -> int: ...
    @property
    def cell_count(self) -> int: ...
    @property
    def report(self) -> dict[str, Any]: ...

class Surface:
    @property
    def points(self) -> NDArray[numpy.float64]: ...
    @property
    def normals(self) -> NDArray[numpy.float32]: ...
    @property
    def polygon_offset(self) -> NDArray[numpy.uint32]: ...
    @property
    def polygon_vertex(self) -> NDArray[numpy.uint32]: ...
    @property
    def polygon_cell(self) -> NDArray[numpy.uint32]: ...
    @property
    def edges(self) -> NDArray[numpy.uint32]: ...
    @property
    def weights(self) -> NDArray[numpy.float64]: ...
    @property
    def triangles(self) -> NDArray[numpy.uint32]: ...
    def __len__(self) -> int: ...

class Contour:
    def __init__(
        self,
        mesh: Mesh,
        values: NDArray[Any],
        *,
        algorithm: Algorithm = "signatures",
        decider: Decider = "isolate-high",
        normals: Normals | None = "gradient",
    ) -> None: ...
    def set(self, values: NDArray[Any], mesh: Mesh | None = None) -> None: ...
    def at(self, level: float) -> Surface: ...

def contour(
    mesh: Mesh,
    values: NDArray[Any],
    level: float,
    *,
    algorithm: Algorithm = "signatures",
    decider: Decider = "isolate-high",
    normals: Normals | None = "gradient",
) -> Surface: ...
def slice(mesh: Mesh, origin: Sequence[float], normal: Sequence[float]) -> Surface: ...
def threshold(mesh: Mesh, values: NDArray[Any], range: Sequence[float], of_cells: bool = False) -> Surface: ...
def interpolate(surface: Surface, mesh: Mesh, values: NDArray[Any]) -> NDArray[numpy.float32]: ...
def gradients(mesh: Mesh, values: NDArray[Any]) -> NDArray[numpy.float32]: ...
def contour_lines(surface: Surface, values: ArrayLike, levels: Sequence[float]) -> NDArray[numpy.float64]: ...
def from_meshio(mesh: Any) -> Mesh: ...
def from_vtk(grid: Any) -> Mesh: ...
