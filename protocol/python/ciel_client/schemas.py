"""Generated from protocol/openrpc.json; do not edit."""

from typing import Any, Literal, NotRequired, TypedDict

Vec3 = list[float]


Range = list[float]


Color = str


class Camera(TypedDict):
    position: Vec3
    target: Vec3
    up: NotRequired[Vec3]  # default [0, 0, 1]
    fov: NotRequired[float]  # Vertical angle of view in degrees, of a camera that is not parallel. (above 0 and below 180, default 30)
    parallel: NotRequired[bool]  # default False
    parallel_height: NotRequired[float]  # Height of the visible area in the dataset's length units. Required if `parallel` is true. (above 0)


class ColorPoint(TypedDict):
    at: float  # Position on the color scale, from 0 at the lower end of the range to 1 at the upper end. With `log`, positions are those of the logarithmic scale. (0 to 1)
    color: Color


class Coloring(TypedDict):
    array: NotRequired[str]  # Name of the scalar that is mapped to colors. Absent: the layer has the color `solid`.
    map: NotRequired[str]  # Name of a color map, from color_maps of server.info. (default 'viridis')
    points: NotRequired[list[ColorPoint] | None]  # Custom colors instead of `map`, in ascending order of `at`. Colors are linear between two points. (2 to 64 items)
    reverse: NotRequired[bool]  # default False
    range: NotRequired[Range | None]  # Values of the two ends of the color scale. Absent: the range of the array at the shown time.
    symmetric: NotRequired[bool]  # Widens the range to be symmetric about zero. (default False)
    log: NotRequired[bool]  # Logarithmic scale. A given range must lie above zero. Without one, the scale covers only the positive values of the array; if the array reaches zero, it begins at a millionth of the largest value. With `symmetric`, the scale is logarithmic on both sides of zero and nearly linear within a thousandth of the end of the range. (default False)
    steps: NotRequired[int | None]  # Number of equal parts of the scale. Each part has one color. Absent: a smooth scale. (2 to 256)
    nan: NotRequired[Color]  # Color of missing, NaN and infinite values. (default '#808080')
    below: NotRequired[Color | None]  # Color of values below the range. Absent: the color of the lower end.
    above: NotRequired[Color | None]  # Color of values above the range. Absent: the color of the upper end.
    solid: NotRequired[Color]  # default '#cccccc'


class Edges(TypedDict):
    """Lines along the sides of a layer's polygons. There is one polygon per cut cell or boundary face, so no lines of a triangulation are shown. Absent: no lines."""

    visible: NotRequired[bool]  # default True
    color: NotRequired[Color]  # default '#1a1a1a'
    width: NotRequired[float]  # Width in pixels of a 1280 x 720 picture. A view multiplies it by its `pixel_ratio`. Larger stills have wider lines, in proportion to their larger text. (above 0 and at most 32, default 1)


class Contours(TypedDict):
    """Contour lines of an array on a slice, at either the levels `values`, or `count` levels in `range`."""

    visible: NotRequired[bool]  # default True
    array: str  # Name of the scalar on points whose contour lines are shown.
    values: NotRequired[list[float]]  # at most 64 items
    count: NotRequired[int]  # Number of contour lines without `values`, evenly spaced inside `range` without its ends. (1 to 64, default 10)
    range: NotRequired[Range | None]  # Range for `count`. Absent: the range of the array at the shown time.
    color: NotRequired[Color]  # default '#1a1a1a'
    coloring: NotRequired[Coloring]  # Color scale of the lines: each line has the color of its value, instead of `color`. Its `array` may only be that of the lines.
    width: NotRequired[float]  # Width in pixels of a 1280 x 720 picture. A view multiplies it by its `pixel_ratio`. Larger stills have wider lines, in proportion to their larger text. (above 0 and at most 32, default 1.5)


class Threshold(TypedDict):
    """Draws the layer as if the mesh had only the cells with values of `array` in `range`. Cells stay whole, and faces towards removed cells become boundary. Absent: all cells."""

    enabled: NotRequired[bool]  # default True
    array: str  # Name of a scalar on points or on cells.
    range: Range
    keep: NotRequired[Literal["all", "any"]]  # all: keeps cells whose vertices all have a value in the range, ends included. any: keeps cells of which at least one vertex has. No effect on arrays of cells. (default 'all')


class IsoLayer(TypedDict):
    type: Literal["iso"]
    order: NotRequired[float]  # default 0
    visible: NotRequired[bool]  # default True
    opacity: NotRequired[float]  # 0 to 1, default 1
    array: str
    values: list[float]  # at most 64 items
    color: NotRequired[Coloring]
    smooth: NotRequired[bool]  # true: normals for lighting from the gradient of the array. false: each polygon is lit with its own normal. (default True)
    edges: NotRequired[Edges]


class SliceLayer(TypedDict):
    """Plane through the mesh, given by either `axis` and `value`, or `origin` and `normal`."""

    type: Literal["slice"]
    order: NotRequired[float]  # default 0
    visible: NotRequired[bool]  # default True
    opacity: NotRequired[float]  # 0 to 1, default 1
    axis: NotRequired[Literal["x", "y", "z"]]
    value: NotRequired[float]  # Position of the plane along `axis`, in the dataset's length units. Required with `axis`.
    origin: NotRequired[Vec3]
    normal: NotRequired[Vec3]
    color: NotRequired[Coloring]
    contours: NotRequired[Contours]
    edges: NotRequired[Edges]


class SurfaceLayer(TypedDict):
    type: Literal["surface"]
    order: NotRequired[float]  # default 0
    visible: NotRequired[bool]  # default True
    opacity: NotRequired[float]  # 0 to 1, default 1
    groups: NotRequired[list[str]]  # Names of the patches to show. Absent or empty: the whole boundary. (default [])
    threshold: NotRequired[Threshold]
    color: NotRequired[Coloring]
    edges: NotRequired[Edges]


class OutlineLayer(TypedDict):
    type: Literal["outline"]
    order: NotRequired[float]  # default 0
    visible: NotRequired[bool]  # default True
    opacity: NotRequired[float]  # 0 to 1, default 1
    color: NotRequired[Coloring]


class EdgesLayer(TypedDict):
    """Edges of the mesh's boundary faces, as lines."""

    type: Literal["edges"]
    order: NotRequired[float]  # default 0
    visible: NotRequired[bool]  # default True
    opacity: NotRequired[float]  # 0 to 1, default 1
    groups: NotRequired[list[str]]  # Names of the patches to show. Absent or empty: the whole boundary. (default [])
    threshold: NotRequired[Threshold]
    angle: NotRequired[float]  # Angle in degrees. Shows only edges where the boundary bends by more than this angle, ends or branches. Absent: all edges. (0 to 180)
    width: NotRequired[float]  # Width in pixels of a 1280 x 720 picture. A view multiplies it by its `pixel_ratio`. Larger stills have wider lines, in proportion to their larger text. (above 0 and at most 32, default 1.5)
    color: NotRequired[Coloring]


class PointsLayer(TypedDict):
    """Vertices of the mesh, as points."""

    type: Literal["points"]
    order: NotRequired[float]  # default 0
    visible: NotRequired[bool]  # default True
    opacity: NotRequired[float]  # 0 to 1, default 1
    of: NotRequired[Literal["boundary", "all"]]  # boundary: vertices of boundary faces. all: vertices of all cells. (default 'boundary')
    groups: NotRequired[list[str]]  # Names of the patches whose vertices are shown. Absent or empty: the whole boundary. Only with `of` boundary. (default [])
    threshold: NotRequired[Threshold]
    size: NotRequired[float]  # Size of each point in pixels of a 1280 x 720 picture. A view multiplies it by its `pixel_ratio`. Larger stills have larger points, in proportion to their larger text. (above 0 and at most 64, default 4)
    most: NotRequired[int]  # Maximum number of points shown. Of more points, every second, third ... is shown, and view.lacking reports it. (1 to 10000000, default 1000000)
    color: NotRequired[Coloring]


class ClipLayer(TypedDict):
    """Plane that cuts all layers, given by either `axis` and `value`, or `origin` and `normal`. At most 6 may be visible. Pictures, probes under a pixel, polygon batches and surface.export show what remains."""

    type: Literal["clip"]
    order: NotRequired[float]  # default 0
    visible: NotRequired[bool]  # default True
    axis: NotRequired[Literal["x", "y", "z"]]
    value: NotRequired[float]  # Position of the plane along `axis`, in the dataset's length units. Required with `axis`.
    origin: NotRequired[Vec3]
    normal: NotRequired[Vec3]
    invert: NotRequired[bool]  # false: cuts away the side to which the normal or the axis points. true: cuts away the other side. (default False)
    caps: NotRequired[bool]  # Closes surface layers that show the whole boundary with a slice of the mesh along the plane. (default True)
    color: NotRequired[Coloring]  # Coloring of the caps. Absent: that of the surface layer.


OpacityPoint = list[float]


class VolumeLayer(TypedDict):
    """The mesh as a medium that emits and absorbs light. `color` maps values of `array` to colors, `opacity_points` to opacity. Several volumes are mixed point by point, whatever their order."""

    type: Literal["volume"]
    order: NotRequired[float]  # default 0
    visible: NotRequired[bool]  # default True
    opacity: NotRequired[float]  # Fades the finished volume. `opacity_points` set its density. Several volumes are mixed point by point: the largest `opacity` fades the mixture, and the `opacity_points` of volumes with a smaller `opacity` are lowered in proportion. (0 to 1, default 1)
    array: str
    color: NotRequired[Coloring]
    opacity_points: NotRequired[list[OpacityPoint]]  # Opacity along the color scale, in ascending order of position. Opacity is linear between two points, and constant before the first and after the last. Two points with the same position are a step. (1 to 256 items, default [[0, 0], [1, 0.9]])
    unit_length: NotRequired[float | None]  # Length in the dataset's length units. A ray through one value has the opacity of `opacity_points` after this length. null or absent: a tenth of the diagonal of the bounds. (above 0)
    slices: NotRequired[int | None]  # Number of slices of a still. Fewer are drawn during movement, with the same brightness. null or absent: 200 to 1000; more along a long side of the bounds, so that the distance of the slices is similar in all directions, and more if `opacity_points` are steep. (1 to 1000)
    direction: NotRequired[Literal["auto", "x", "y", "z", "screen"]]  # Normal of the slices. auto: the axis nearest to the viewing direction. screen: the viewing direction; during movement, the nearest axis. x, y, z: this axis, unless rays of the picture run nearly along its slices; then as auto. Stills use the viewing direction if rays run nearly along the slices of the chosen axis. The first visible volume decides for all volumes. (default 'auto')
    shaded: NotRequired[bool]  # Shades the volume by the gradient of its array, with a light at the eye. (default True)


Layer = IsoLayer | SliceLayer | SurfaceLayer | OutlineLayer | ClipLayer | EdgesLayer | PointsLayer | VolumeLayer


class EmptyLayer(TypedDict):
    layer: str
    why: Literal["outside", "threshold", "clipped", "opacity", "missing", "nothing"]  # outside: its values or its plane are outside the data. threshold: its threshold keeps no cell. clipped: clip planes cut all of it away. opacity: its opacity is 0. missing: its array was not written at this time. nothing: another reason.
    reason: str  # Sentence for the user.


class Annotations(TypedDict):
    """Text, legends and axes over a picture. Pictures of picture.render and `ciel render` contain them. Frames of a view do not; the client draws them over the frames."""

    legend: NotRequired[bool]  # Color bars with name, units and ticks. (default True)
    triad: NotRequired[bool]  # Arrows that show the directions of x, y and z. (default True)
    axes: NotRequired[bool]  # Ticks and numbers along edges of the bounding box, in the dataset's length units. (default False)
    time: NotRequired[bool]  # Time of the shown step. (default False)
    dataset: NotRequired[bool]  # Name of the dataset. (default False)
    title: NotRequired[str]  # Title of the picture. At most 256 bytes of UTF-8. Empty: no title. (default '')
    scale: NotRequired[float]  # Factor on the size of text and of the annotations' lines. At 1, text has 13 pixels in a picture of 1280 x 720, and more in larger pictures. (0.25 to 4, default 1)


class Light(TypedDict):
    on: NotRequired[bool]  # default True
    strength: NotRequired[float]  # 0 to 4, default 1


class AmbientOcclusion(TypedDict):
    """Darkens opaque lit surfaces where other surfaces nearby block the ambient light. Slices darken other surfaces, but keep their own colors. Lines, points, transparent surfaces and volumes neither darken nor are darkened. Pictures show the effect; polygons of the geometry stream do not."""

    on: NotRequired[bool]  # default False
    radius: NotRequired[float]  # Largest distance at which surfaces darken each other, as a share of the diagonal of the bounds. (above 0 and at most 1, default 0.1)
    strength: NotRequired[float]  # Exponent of the share of the ambient light that reaches a point. 0: no effect. 1: the share itself. 2: as dark as 1 applied twice. (0 to 4, default 1)


class Lighting(TypedDict):
    """Light on surfaces. The headlight is at the eye and the key light over the viewer's left shoulder; both move with the camera. A shaded volume has its own light at the eye, which goes off with the headlight. Slices are never lit."""

    on: NotRequired[bool]  # false: everything is shown in its own colors, without light and shade. (default True)
    ambient: NotRequired[float]  # Strength of the light from all directions. (0 to 4, default 1)
    headlight: NotRequired[Light]
    key_light: NotRequired[Light]
    ambient_occlusion: NotRequired[AmbientOcclusion]


class Scene(TypedDict):
    """Everything that a picture depends on. Undo, links, replay and scripts use this document."""

    dataset: str
    time: NotRequired[float]  # Simulation time. The nearest step is shown. (default 0)
    camera: NotRequired[Camera | None]
    background: NotRequired[Literal["dark", "light"] | Color]  # default 'dark'
    annotations: NotRequired[Annotations]
    lighting: NotRequired[Lighting]
    layers: NotRequired[dict[str, Layer]]  # Layers by id. An id has at most 256 bytes of UTF-8. Layers are drawn by `order`, then by id.


class CellExtreme(TypedDict):
    value: float
    cell: int  # Id of the cell in the imported file.
    place: Vec3  # Mean of the cell's corners.
    time: float  # Time of the step.


class CellExtremes(TypedDict):
    lowest: CellExtreme
    highest: CellExtreme


class ArrayInfo(TypedDict):
    name: str
    association: Literal["point", "cell", "boundary_face"]  # point, cell, or boundary_face. boundary_face: the solver's values on the faces of patches (patch:p), which can color surface layers only.
    components: int
    units: str
    description: str
    range: Range | None
    scalars: list[str]  # Names of the array's scalars: p, U:x, U:magnitude, R:xx. Scalars of cell arrays (cell:U:x) color surfaces flat and select cells in thresholds. Iso-surfaces, contour lines, volumes, and colors of edges and points need values at points.
    times: list[float]  # Times of the steps at which the array was written.
    origin: Literal["unknown", "original", "interpolated", "derived"]  # original: from the imported file. interpolated: made from values on cells. derived: computed by the reader of the file format. unknown: not recorded in the dataset.
    type: NotRequired[str]  # Type of the numbers in the imported file, such as int32. Absent if not known.
    stored: Literal["float32", "float64"]  # Type of the numbers in the dataset. float32 if it holds all numbers of the file's type, else float64. float64 also for integers of 32 and 64 bits.
    file: NotRequired[str]  # Imported file in which the array was found first. Absent if not known.
    invalid: int  # Number of NaN and infinite values, at all steps together.
    missing: int  # Number of missing values, at all steps together: in input grids that have no such array, and in pieces of files that could not be read.
    extremes: NotRequired[CellExtremes]  # Cells with the lowest and the highest value over all steps. Present for arrays on cells and for point arrays that were made from them, if the cells are known.


class MeshInfo(TypedDict):
    vertices: int
    edges: int
    faces: int
    half_edges: int
    boundary_faces: int
    components: int
    cells: dict[str, int]


class DatasetDescriptionInput(TypedDict):
    vertices: int
    edges: int
    cells: int


class DatasetDescriptionGroupsItem(TypedDict):
    name: str
    of: Literal["faces", "cells"]
    count: int
    type: NotRequired[str]  # Type of the patch in the solver, if the source states it: wall, empty, symmetryPlane.
    conditions: NotRequired[dict[str, str]]  # Boundary condition on the patch for each array, at the first step of the mesh.


class DatasetDescription(TypedDict):
    name: str
    source: str
    created: str
    length_units: str
    times: list[float]
    unread_steps: NotRequired[int]  # Number of steps with arrays that have not been read from the source of the import. The ranges of arrays are those of the other steps. Absent if all steps have been read. (at least 1)
    bounds: list[float]  # [x minimum, x maximum, y minimum, y maximum, z minimum, z maximum] in the dataset's length units.
    input: DatasetDescriptionInput
    mesh: MeshInfo
    arrays: list[ArrayInfo]
    groups: list[DatasetDescriptionGroupsItem]
    notes: list[str]
    default_scene: Scene  # Scene that is shown first. With bodies in the flow: the bodies colored by pressure, and a slice colored by speed, at the last step whose arrays are finite. Without bodies: an iso-surface; in a mesh of one layer of cells, a slice; if no scalar varies, the boundary.
    default_bounds: list[float]  # Box that the camera of default_scene looks at: around the bodies, or the bounds. A client can fit a camera for another picture size to it. [x minimum, x maximum, y minimum, y maximum, z minimum, z maximum] in the dataset's length units.


class WantedArray(TypedDict):
    name: str  # Name of an array of the dataset, or of a new one. Names of arrays on cells begin with 'cell:'.
    components: NotRequired[int]  # Number of components. Default: 1 for a new array, and the existing number for an array of the dataset, from which it may not differ. (1 to 64)
    type: NotRequired[Literal["float32", "float64"]]  # Type of the uploaded values. Default: float32. A new array is stored in this type.


class ExpectedArray(TypedDict):
    name: str
    association: Literal["point", "cell"]
    components: int
    tuples: int  # Number of points or cells of the imported file. The values come in their order.
    bytes: int  # Size of the array: tuples x components x 4 (float32) or 8 (float64).


class Upload(TypedDict):
    upload: str  # Id of the upload, for append.piece, append.commit and append.cancel. Keep it secret.
    piece_bytes: int  # Maximum number of bytes of a piece.
    idle_seconds: int  # Number of seconds without a call after which the server drops the upload.
    arrays: list[ExpectedArray]
    made: list[str]  # Names of point arrays that the server makes from the uploaded arrays on cells, as an import does.
    added: list[str]  # Names of arrays that the dataset does not have yet. A misspelt name appears here.
    lacking: list[str]  # Names of arrays of the dataset that will have no values at this step.
    rounded: list[str]  # Names of arrays that are sent as float64 and stored as float32, because earlier steps are stored as float32.


class SessionState(TypedDict):
    session: str
    revision: int
    scene: Scene
    can_undo: bool
    can_redo: bool


class Revision(TypedDict):
    revision: int
    can_undo: bool
    can_redo: bool


class Picture(TypedDict):
    mime: str
    width: int
    height: int
    revision: int
    time: float
    remarks: list[str]  # Sentences about data that the picture does not show, or not completely: layers of which nothing is seen, arrays that were not written at this time, too many points, more transparent layers behind each other than can be drawn.
    data: str  # The PNG file as base64 (RFC 4648).


class ProbeResult(TypedDict):
    hit: bool
    position: Vec3 | None
    vertex: int | None
    cell: int | None
    layer: str | None  # Id of the layer whose polygon is under the pixel. null for a position, and if a line or a point is under the pixel.
    patch: str | None  # Patch under the pixel. null if the layer there is not a surface layer, or the face is in no patch.
    values: dict[str, float | None]  # Value of each scalar at the position. null if it was not written at this time or is not finite.
    solver_cell: NotRequired[int]  # Id that the solver gave to the cell. Absent if the source has none (cellProcAddressing, GlobalElementId).
    solver_vertex: NotRequired[int]  # Id that the solver gave to the nearest vertex. Absent if the source has none (GlobalNodeId).
    extremes: NotRequired[dict[str, CellExtremes]]  # For each array on cells: the cells with the lowest and the highest value at this step, of the magnitude if the array has one.
