from collections.abc import Callable, Sequence
from typing import Any, Literal, overload

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str

Algorithm = Literal["signatures", "propagation", "naive"]
Decider = Literal["isolate-high", "asymptotic"]
Normals = Literal["gradient", "polygons"]
Vector = Sequence[float] | NDArray[Any]  # three numbers
Levels = Sequence[float] | NDArray[Any]
Blocks = Sequence[int] | NDArray[Any]

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
    def block_count(self) -> int: ...
    @property
    def report(self) -> dict[str, Any]: ...

class Surface:
    @property
    def points(self) -> NDArray[numpy.float64]: ...
    @property
    def normals(self) -> NDArray[numpy.float32]: ...
    @property
    def polygon_offset(self) -> NDArray[numpy.int32]: ...
    @property
    def polygon_vertex(self) -> NDArray[numpy.int32]: ...
    @property
    def polygon_cell(self) -> NDArray[numpy.uint32]: ...
    @property
    def edges(self) -> NDArray[numpy.uint32]: ...
    @property
    def weights(self) -> NDArray[numpy.float64]: ...
    @property
    def chunks(self) -> NDArray[numpy.uint32]: ...
    @property
    def triangles(self) -> NDArray[numpy.int32]: ...
    def __len__(self) -> int: ...

class Contour:
    def __init__(
        self,
        mesh: Mesh,
        values: NDArray[Any],
        *,
        of_cells: bool = False,
        algorithm: Algorithm = "signatures",
        decider: Decider = "isolate-high",
        normals: Normals | None = "gradient",
        blocks: Blocks | None = None,
        threads: int = 0,
    ) -> None: ...
    def set(self, values: NDArray[Any], mesh: Mesh | None = None, *, of_cells: bool = False) -> None: ...
    def at(self, level: float) -> Surface: ...

@overload
def contour(
    mesh: Mesh,
    values: NDArray[Any],
    level: float,
    *,
    of_cells: bool = False,
    algorithm: Algorithm = "signatures",
    decider: Decider = "isolate-high",
    normals: Normals | None = "gradient",
    blocks: Blocks | None = None,
    threads: int = 0,
) -> Surface: ...
@overload
def contour(
    mesh: Mesh,
    values: NDArray[Any],
    *,
    levels: Levels,
    of_cells: bool = False,
    algorithm: Algorithm = "signatures",
    decider: Decider = "isolate-high",
    normals: Normals | None = "gradient",
    blocks: Blocks | None = None,
    threads: int = 0,
) -> list[Surface]: ...
def slice(
    mesh: Mesh,
    origin: Vector,
    normal: Vector,
    *,
    algorithm: Algorithm = "signatures",
    decider: Decider = "isolate-high",
    normals: Normals | None = "gradient",
    blocks: Blocks | None = None,
    threads: int = 0,
) -> Surface: ...
def sweep(
    mesh: Mesh,
    values: NDArray[Any],
    levels: Levels,
    callback: Callable[[int, Surface], object],
    *,
    of_cells: bool = False,
    algorithm: Algorithm = "signatures",
    decider: Decider = "isolate-high",
    threads: int = 0,
) -> None: ...
def threshold(mesh: Mesh, values: NDArray[Any], range: Sequence[float], of_cells: bool = False) -> Surface: ...
def interpolate(
    surface: Surface, mesh: Mesh, values: NDArray[Any], *, of_cells: bool = False
) -> NDArray[numpy.float32] | NDArray[numpy.float64]: ...
def clip(
    surface: Surface,
    mesh: Mesh,
    planes: Sequence[tuple[Vector, Vector]],
    values: NDArray[Any] | None = None,
    *,
    slack: float = 0.0,
) -> tuple[Surface, NDArray[numpy.float64] | None]: ...
def triangulate(surface: Surface) -> NDArray[numpy.int32]: ...
def gradients(mesh: Mesh, values: NDArray[Any]) -> NDArray[numpy.float32]: ...
def contour_lines(surface: Surface, values: ArrayLike, levels: Levels) -> NDArray[numpy.float64]: ...
def from_meshio(mesh: Any) -> Mesh: ...
def from_vtk(grid: Any) -> Mesh: ...
