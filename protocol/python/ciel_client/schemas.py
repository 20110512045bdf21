"""Generated from protocol/openrpc.json; do not edit."""

from typing import Any, Literal, NotRequired, TypedDict

Vec3 = list[float]


Range = list[float]


Color = str


class Camera(TypedDict):
    position: Vec3
    target: Vec3
    up: NotRequired[Vec3]
    fov: NotRequired[float]  # vertical, degrees
    parallel: NotRequired[bool]
    parallel_height: NotRequired[float]  # of the view, in length units, when parallel


class ColorPoint(TypedDict):
    at: float  # along the range, of its logarithm with log
    color: Color


class Coloring(TypedDict):
    array: NotRequired[str]  # a scalar name; absent: the solid color
    map: NotRequired[str]  # a name of server.info's color_maps
    points: NotRequired[list[ColorPoint] | None]  # colors of one's own instead of the map, in ascending order; linear between them
    reverse: NotRequired[bool]
    range: NotRequired[Range | None]  # of the values on the map; absent: the array's at the shown time
    symmetric: NotRequired[bool]  # widens the range to as much below zero as above it
    log: NotRequired[bool]  # logarithmic; a given range lies above zero, and of the array's only what does is on the map, six decades at most where it holds zero. With symmetric: logarithmic on both sides of zero, nearly linear within a thousandth of the range's end
    steps: NotRequired[int | None]  # so many equal parts of one color each; absent: smooth
    nan: NotRequired[Color]  # of values that are missing
    below: NotRequired[Color | None]  # of values below the range; absent: that of its lower end
    above: NotRequired[Color | None]  # of values above the range; absent: that of its upper end
    solid: NotRequired[Color]


class Edges(TypedDict):
    """Lines along the edges of a layer's polygons: those of the cells, never those of a triangulation. Absent: none."""

    visible: NotRequired[bool]
    color: NotRequired[Color]
    width: NotRequired[float]  # pixels, of which larger pictures have more: pixel_ratio of a view; of a still so many as its text is larger than at 720 rows


class Contours(TypedDict):
    """Lines where an array takes values on a slice: either values, or count of them."""

    visible: NotRequired[bool]
    array: str  # a scalar name
    values: NotRequired[list[float]]
    count: NotRequired[int]  # number of lines, evenly spaced inside the range; 10 if values is absent, too
    range: NotRequired[Range | None]  # of count; absent: the array's range at the shown time
    color: NotRequired[Color]
    coloring: NotRequired[Coloring]  # each line in the color of its value on this scale, instead of color; its array is that of the lines
    width: NotRequired[float]  # pixels, as of edges


class Threshold(TypedDict):
    """Shows the mesh as if it had only the cells whose values lie in the range. They stay whole: the boundary is then theirs, with the faces towards cells that are left out. Absent: all cells."""

    enabled: NotRequired[bool]
    array: str  # a scalar name, of the points or of the cells
    range: Range
    keep: NotRequired[Literal["all", "any"]]  # cells with all vertices in the range, ends included, or with any; without effect where the cells have values of their own


class IsoLayer(TypedDict):
    type: Literal["iso"]
    order: NotRequired[float]
    visible: NotRequired[bool]
    opacity: NotRequired[float]
    array: str
    values: list[float]
    color: NotRequired[Coloring]
    smooth: NotRequired[bool]  # normals from the field's gradient; false: each polygon's own
    edges: NotRequired[Edges]


class SliceLayer(TypedDict):
    """either axis and value, or origin and normal"""

    type: Literal["slice"]
    order: NotRequired[float]
    visible: NotRequired[bool]
    opacity: NotRequired[float]
    axis: NotRequired[Literal["x", "y", "z"]]
    value: NotRequired[float]  # position along the axis; with axis
    origin: NotRequired[Vec3]
    normal: NotRequired[Vec3]
    color: NotRequired[Coloring]
    contours: NotRequired[Contours]
    edges: NotRequired[Edges]


class SurfaceLayer(TypedDict):
    type: Literal["surface"]
    order: NotRequired[float]
    visible: NotRequired[bool]
    opacity: NotRequired[float]
    groups: NotRequired[list[str]]  # patch names; absent or empty: the whole boundary
    threshold: NotRequired[Threshold]
    color: NotRequired[Coloring]
    edges: NotRequired[Edges]


class OutlineLayer(TypedDict):
    type: Literal["outline"]
    order: NotRequired[float]
    visible: NotRequired[bool]
    opacity: NotRequired[float]
    color: NotRequired[Coloring]


class EdgesLayer(TypedDict):
    """The edges of the mesh's boundary faces, as lines."""

    type: Literal["edges"]
    order: NotRequired[float]
    visible: NotRequired[bool]
    opacity: NotRequired[float]
    groups: NotRequired[list[str]]  # patch names; absent or empty: the whole boundary
    threshold: NotRequired[Threshold]
    angle: NotRequired[float]  # degrees: only where the boundary bends by more, ends or branches; absent: all edges
    width: NotRequired[float]  # pixels, as of edges
    color: NotRequired[Coloring]


class PointsLayer(TypedDict):
    """The mesh's vertices, as points."""

    type: Literal["points"]
    order: NotRequired[float]
    visible: NotRequired[bool]
    opacity: NotRequired[float]
    of: NotRequired[Literal["boundary", "all"]]  # vertices of boundary faces, or of all cells
    groups: NotRequired[list[str]]  # patch names; absent or empty: the whole boundary; with of: boundary
    threshold: NotRequired[Threshold]
    size: NotRequired[float]  # pixels across, likewise
    most: NotRequired[int]  # where there are more, every second, third ... is shown, and view.lacking says so
    color: NotRequired[Coloring]


class ClipLayer(TypedDict):
    """A plane that cuts all layers: either axis and value, or origin and normal. At most 6 may be visible. Pictures, probes under a pixel, polygon batches and surface.export show what is left."""

    type: Literal["clip"]
    order: NotRequired[float]
    visible: NotRequired[bool]
    axis: NotRequired[Literal["x", "y", "z"]]
    value: NotRequired[float]  # position along the axis; with axis
    origin: NotRequired[Vec3]
    normal: NotRequired[Vec3]
    invert: NotRequired[bool]  # false: what the normal or the axis points to is cut away; true: the other side
    caps: NotRequired[bool]  # close the surface layers that show the whole boundary, which stand for the solid mesh, with a slice
    color: NotRequired[Coloring]  # of the caps; absent: as the surface layer has it


OpacityPoint = list[float]


class VolumeLayer(TypedDict):
    """Light that passes through the mesh, through the map and range of color and the opacity of opacity_points. Several volumes are mixed place by place, whatever their order."""

    type: Literal["volume"]
    order: NotRequired[float]
    visible: NotRequired[bool]
    opacity: NotRequired[float]  # fades the finished volume; how dense it is, opacity_points say. Of several volumes, which are mixed place by place, the largest opacity fades the mixture, and in one of less the opacities of opacity_points are less in proportion.
    array: str
    color: NotRequired[Coloring]
    opacity_points: NotRequired[list[OpacityPoint]]  # by position; straight between two points, constant before the first and after the last. A position twice is a step.
    unit_length: NotRequired[float | None]  # the length, in the dataset's length units, after which a ray through a value has lost the share of its light that opacity_points say; null or absent: a tenth of the diagonal of the bounds
    slices: NotRequired[int | None]  # of a still; while something moves there are fewer, without a change of brightness. null or absent: from 200 on, more along a long axis, so that they are as far apart whatever they are across, and where opacity_points are steep
    direction: NotRequired[Literal["auto", "x", "y", "z", "screen"]]  # normal of the slices: auto is the axis nearest the view, screen the view's own direction (the nearest axis while it moves). A view that looks along slices across an axis somewhere has those of auto instead, and a still of so wide a view that it looks along these, too, those of screen. Of several volumes the first that is shown decides for all.
    shaded: NotRequired[bool]  # by the array's gradient, with a light at the eye


Layer = IsoLayer | SliceLayer | SurfaceLayer | OutlineLayer | ClipLayer | EdgesLayer | PointsLayer | VolumeLayer


class EmptyLayer(TypedDict):
    layer: str
    why: Literal["outside", "threshold", "clipped", "opacity", "missing", "nothing"]  # outside: its values or its plane are outside the data
    reason: str  # a sentence about the layer


class Annotations(TypedDict):
    """What is written over a picture. Pictures (picture.render, ciel render) carry all of it; the frames of a view carry none: who shows them draws it at the resolution of the screen, from this document."""

    legend: NotRequired[bool]  # color bars with name, units and ticks
    triad: NotRequired[bool]  # where x, y and z point
    axes: NotRequired[bool]  # ticks and numbers along edges of the bounding box, in the dataset's length units
    time: NotRequired[bool]  # the time of the step shown
    dataset: NotRequired[bool]  # the dataset's name
    title: NotRequired[str]  # at most 256 bytes of UTF-8
    scale: NotRequired[float]  # of text and lines, on top of the picture's height: 13 pixels of text at 720 rows


class Light(TypedDict):
    on: NotRequired[bool]
    strength: NotRequired[float]


class AmbientOcclusion(TypedDict):
    """Opaque lit surfaces are darker where others near them keep out light from everywhere. Slices keep the colors of their values, but shade what is around them; lines, points, transparent surfaces and volumes neither shade nor are shaded. Pictures show it, the polygons of the geometry stream do not."""

    on: NotRequired[bool]
    radius: NotRequired[float]  # within which surfaces shade each other, of the diagonal of the bounds
    strength: NotRequired[float]  # the share of the sky that a place sees is raised to this power: 1 is what light from everywhere would do, 2 is darker


class Lighting(TypedDict):
    """What lights surfaces: the headlight stands at the eye, the key light over the viewer's left shoulder, both move with the camera. A shaded volume has a light at the eye, which the headlight's switch turns off."""

    on: NotRequired[bool]  # false: all in its own colors, without light and shade
    ambient: NotRequired[float]  # strength of the light from everywhere
    headlight: NotRequired[Light]
    key_light: NotRequired[Light]
    ambient_occlusion: NotRequired[AmbientOcclusion]


class Scene(TypedDict):
    """What a viewer wants to see. Undo, links, replay and scripts all use this document."""

    dataset: str
    time: NotRequired[float]  # the nearest time step is shown
    camera: NotRequired[Camera | None]
    background: NotRequired[Literal["dark", "light"] | Color]
    annotations: NotRequired[Annotations]
    lighting: NotRequired[Lighting]
    layers: NotRequired[dict[str, Layer]]  # by id, of at most 256 bytes of UTF-8; drawn by (order, id)


class CellExtreme(TypedDict):
    value: float
    cell: int  # id in the imported file
    place: Vec3  # the mean of its corners
    time: float  # of the step


class CellExtremes(TypedDict):
    lowest: CellExtreme
    highest: CellExtreme


class ArrayInfo(TypedDict):
    name: str
    association: Literal["point", "cell", "boundary_face"]  # boundary_face: what the solver has on the faces of patches (patch:p); surface layers alone are colored by it
    components: int
    units: str
    description: str
    range: Range | None
    scalars: list[str]  # names usable in layers: U:x, U:magnitude, R:xx. Those of cell arrays (cell:U:x) color surfaces, flat, and choose cells; nothing else is made from them
    times: list[float]  # steps at which the array was written
    origin: Literal["unknown", "original", "interpolated", "derived"]  # as the file has it; made from values of the cells; computed by the reader of the file
    type: NotRequired[str]  # of the numbers in the imported file, such as int32; absent where it is not known
    stored: Literal["float32", "float64"]  # of the numbers in the dataset: the smaller one that can hold all numbers of the file's type, and float64 for integers of 32 and 64 bits
    file: NotRequired[str]  # where it was first read from; absent where it is not known
    invalid: int  # values that are not finite, at all steps together
    missing: int  # values that are not there: of blocks without the array, of parts that could not be read
    extremes: NotRequired[CellExtremes]  # of an array of the cells, or made from one: the ends of its range, at all steps


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
    type: NotRequired[str]  # what the solver calls the patch, where the source says so: wall, empty, symmetryPlane
    conditions: NotRequired[dict[str, str]]  # array: its boundary condition on the patch at the mesh's first step


class DatasetDescription(TypedDict):
    name: str
    source: str
    created: str
    length_units: str
    times: list[float]
    bounds: list[float]  # xmin, xmax, ymin, ymax, zmin, zmax
    input: DatasetDescriptionInput
    mesh: MeshInfo
    arrays: list[ArrayInfo]
    groups: list[DatasetDescriptionGroupsItem]
    notes: list[str]
    default_scene: Scene  # What is shown first: bodies in the flow colored by pressure, with a slice colored by speed, at the last step whose arrays are finite. Without bodies: an iso-surface.
    default_bounds: list[float]  # The box that the camera of default_scene looks at, for a camera that fits another canvas: around the bodies, or bounds. xmin, xmax, ymin, ymax, zmin, zmax


class WantedArray(TypedDict):
    name: str  # of an array of the dataset, or of a new one; begins with 'cell:' for values of the cells
    components: NotRequired[int]  # of a new array, 1 when absent; that of another must be the same
    type: NotRequired[Literal["float32", "float64"]]  # of the values to be sent, float32 when absent; a new array is stored in it


class ExpectedArray(TypedDict):
    name: str
    association: Literal["point", "cell"]
    components: int
    tuples: int  # values of each component: in the order of the imported file's points or cells
    bytes: int  # 4 or 8 (float64) x tuples x components


class Upload(TypedDict):
    upload: str  # names the upload in pieces, commit and cancel; a secret of its clients
    piece_bytes: int  # that a piece may have at most
    idle_seconds: int  # without a piece, after which the upload is forgotten
    arrays: list[ExpectedArray]
    made: list[str]  # arrays of the points that are made from arrays of the cells, as an import makes them
    added: list[str]  # arrays that the dataset does not have yet: a misspelt name is among them
    lacking: list[str]  # arrays of the dataset that have no values at this step
    rounded: list[str]  # arrays that are sent as float64 and stored as float32, as they are at earlier steps


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
    remarks: list[str]  # what the picture does not show, or not in full, a sentence each: points that are too many, more transparent layers behind each other than can be drawn, layers of which nothing is seen, values that were not written at its time
    data: str  # base64 (RFC 4648)


class ProbeResult(TypedDict):
    hit: bool
    position: Vec3 | None
    vertex: int | None
    cell: int | None
    layer: str | None  # the layer whose polygon is under the pixel; null for a position, and where a line or a point is
    patch: str | None  # the patch under the pixel, where that layer is a surface; null on other layers
    values: dict[str, float | None]  # scalar name to value at the position; null where it was not written, or is no number
    solver_cell: NotRequired[int]  # the solver's own id of the cell, where the source has one (cellProcAddressing, GlobalElementId)
    solver_vertex: NotRequired[int]  # likewise of the nearest vertex (GlobalNodeId)
    extremes: NotRequired[dict[str, CellExtremes]]  # array of the cells to its lowest and highest value at this step, of the magnitude where it has one
