"""Generated from protocol/openrpc.json; do not edit."""

from typing import Any, Literal, NotRequired, TypedDict

from .schemas import (
    AmbientOcclusion as AmbientOcclusion,
    Annotations as Annotations,
    ArrayInfo as ArrayInfo,
    Camera as Camera,
    CellExtreme as CellExtreme,
    CellExtremes as CellExtremes,
    ClipLayer as ClipLayer,
    Color as Color,
    ColorPoint as ColorPoint,
    Coloring as Coloring,
    Contours as Contours,
    DatasetDescription as DatasetDescription,
    Edges as Edges,
    EdgesLayer as EdgesLayer,
    EmptyLayer as EmptyLayer,
    ExpectedArray as ExpectedArray,
    IsoLayer as IsoLayer,
    Layer as Layer,
    Light as Light,
    Lighting as Lighting,
    MeshInfo as MeshInfo,
    OpacityPoint as OpacityPoint,
    OutlineLayer as OutlineLayer,
    Picture as Picture,
    PointsLayer as PointsLayer,
    ProbeResult as ProbeResult,
    Range as Range,
    Revision as Revision,
    Scene as Scene,
    SessionState as SessionState,
    SliceLayer as SliceLayer,
    SurfaceLayer as SurfaceLayer,
    Threshold as Threshold,
    Upload as Upload,
    Vec3 as Vec3,
    VolumeLayer as VolumeLayer,
    WantedArray as WantedArray,
)


class RpcDiscoverParams(TypedDict):
    """rpc.discover: This document."""

    pass


RpcDiscoverResult = dict[str, Any]


class ServerInfoParams(TypedDict):
    """server.info: Version, GL renderer, limits, color maps."""

    pass


class ServerInfoResultProtocol(TypedDict):
    """the version of this document"""

    major: int
    minor: int


class ServerInfoResult(TypedDict):
    version: str  # of the program
    protocol: ServerInfoResultProtocol  # the version of this document
    gl_renderer: str
    backend: str
    engine: str
    limits: dict[str, float]  # by name, as `ciel serve --help` lists them: bytes, seconds, pixels, counts
    color_maps: list[str]
    layer_types: list[str]  # values of a layer's type
    streams: list[str]  # values of a view's stream


class DatasetListParams(TypedDict):
    """dataset.list: The datasets on offer."""

    pass


class DatasetListResultItem(TypedDict):
    name: str
    problem: str  # empty when it can be opened


DatasetListResult = list[DatasetListResultItem]


class DatasetDescribeParams(TypedDict):
    """dataset.describe: Arrays, times, bounds, patches and a scene to start from."""

    dataset: str  # a name of dataset.list


DatasetDescribeResult = DatasetDescription


class DatasetOpenParams(TypedDict):
    """dataset.open: Shows a dataset's default scene in a session, as an undoable change."""

    session: str  # the id that session.open answered with
    dataset: str  # a name of dataset.list


DatasetOpenResult = SessionState


class DatasetHistogramParams(TypedDict):
    """dataset.histogram: Counts of a scalar's values at one time."""

    dataset: str  # a name of dataset.list
    array: str  # a scalar name, such as `p`, `U:x` or `cell:p`
    time: NotRequired[float]  # the first time when absent
    bins: NotRequired[int]  # of equal width; the last one holds its upper end, too
    range: NotRequired[Range]  # the array's own when absent


class DatasetHistogramResult(TypedDict):
    range: Range
    counts: list[int]
    invalid: int  # values that are not finite
    below: int
    above: int
    cells: NotRequired[CellExtremes]  # of the cells that the array is of, or was made from, at this step


class SessionOpenParams(TypedDict):
    """session.open: A new session, or one that exists; over WebSocket the connection then hears of its changes."""

    session: NotRequired[str]  # an id to join or recreate; it is the session's key, so a client that chooses one makes it of 128 random bits
    dataset: NotRequired[str]  # whose default scene a new session shows; the first of dataset.list when absent
    scene: NotRequired[Scene]  # the scene of a new session
    undo: NotRequired[list[dict[str, Any]]]  # RFC 7396 merge patches, nearest step first: what scene.undo goes back to in a new session. The first applies to the scene, each other to the result of the one before it. For a client whose server was restarted; an existing session keeps its own history
    redo: NotRequired[list[dict[str, Any]]]  # likewise for scene.redo


SessionOpenResult = SessionState


class SessionCloseParams(TypedDict):
    """session.close: Forgets the session."""

    session: str  # the id that session.open answered with


SessionCloseResult = None


class SceneGetParams(TypedDict):
    """scene.get: The session's scene."""

    session: str  # the id that session.open answered with


SceneGetResult = SessionState


class ScenePatchParams(TypedDict):
    """scene.patch: Applies an RFC 7396 merge patch. Patches with the same gesture are one undo step."""

    session: str  # the id that session.open answered with
    patch: dict[str, Any]  # an RFC 7396 merge patch of the scene: null removes a member
    gesture: NotRequired[str]  # any text that names what the user is doing, such as one drag of a slider; at most 256 bytes of UTF-8


ScenePatchResult = Revision


class SceneUndoParams(TypedDict):
    """scene.undo: Takes the last step back."""

    session: str  # the id that session.open answered with


SceneUndoResult = SessionState


class SceneRedoParams(TypedDict):
    """scene.redo: Does it again."""

    session: str  # the id that session.open answered with


SceneRedoResult = SessionState


class ViewOpenParams(TypedDict):
    """view.open: A stream of frames of the session on this WebSocket."""

    session: str  # the id that session.open answered with
    width: int  # in pixels
    height: int  # in pixels
    pixel_ratio: NotRequired[float]  # pixels of the pictures for one of lines and points: what the page is shown with (devicePixelRatio)
    stream: NotRequired[Literal["image", "geometry"]]  # pictures, or polygons for the client to draw (frame.md)
    moving: NotRequired[Literal["png", "jpeg"]]  # How interactive pictures are coded; a still is a PNG.


class ViewOpenResult(TypedDict):
    view: int


class ViewResizeParams(TypedDict):
    """view.resize: Changes the size of a view's pictures."""

    view: int  # the number that view.open answered with
    width: int  # in pixels
    height: int  # in pixels
    pixel_ratio: NotRequired[float]  # as in view.open; without it this stays as it is


ViewResizeResult = None


class ViewStreamParams(TypedDict):
    """view.stream: Chooses pictures or polygon batches."""

    view: int  # the number that view.open answered with
    stream: Literal["image", "geometry"]  # pictures, or polygons for the client to draw (frame.md)
    moving: NotRequired[Literal["png", "jpeg"]]  # As in view.open; without it this stays as it is.


ViewStreamResult = None


class ViewAckParams(TypedDict):
    """view.ack: The frame has been presented (usually a notification)."""

    view: int  # the number that view.open answered with
    frame: int  # the number in the frame's header


ViewAckResult = None


class ViewCloseParams(TypedDict):
    """view.close: Ends the stream."""

    view: int  # the number that view.open answered with


ViewCloseResult = None


class PictureRenderParams(TypedDict):
    """picture.render: A lossless still picture."""

    session: NotRequired[str]  # without it, `scene` is used and nothing is kept
    scene: NotRequired[Scene]  # the scene to be used in place of a session's; nothing is kept of it
    width: NotRequired[int]  # width times height may be at most 33554432
    height: NotRequired[int]  # in pixels; text and lines grow with it
    progress: NotRequired[str]  # a name of the caller's own for call.progress, which is sent to the calling WebSocket, or after a POST to all WebSockets of the session


PictureRenderResult = Picture


class ProbePointParams(TypedDict):
    """probe.point: Values at a world position, or under a pixel of a picture of the given size."""

    session: NotRequired[str]  # without it, `scene` is used and nothing is kept
    scene: NotRequired[Scene]  # the scene to be used in place of a session's; nothing is kept of it
    position: NotRequired[Vec3]  # in the dataset's length units; either this or a pixel
    pixel: NotRequired[list[float]]  # x, y from the top left
    width: NotRequired[int]  # of the picture that the pixel is of; with pixel
    height: NotRequired[int]  # of the picture that the pixel is of; with pixel


ProbePointResult = ProbeResult


class SceneCameraParams(TypedDict):
    """scene.camera: Where a scene is seen from: its own camera, or the one that pictures and views of a scene without one have."""

    session: NotRequired[str]  # without it, `scene` is used and nothing is kept
    scene: NotRequired[Scene]  # the scene to be used in place of a session's; nothing is kept of it
    width: NotRequired[int]  # of the picture or the view: without a camera all of the bounds is seen, clear of what is written
    height: NotRequired[int]  # of the picture or the view, in pixels


SceneCameraResult = Camera


class SceneBoundsParams(TypedDict):
    """scene.bounds: The box around what clip planes and thresholds leave of the mesh: what a view of everything frames. Iso-surfaces and slices do not narrow it; where nothing is left it is the dataset's."""

    session: NotRequired[str]  # without it, `scene` is used and nothing is kept
    scene: NotRequired[Scene]  # the scene to be used in place of a session's; nothing is kept of it
    of: NotRequired[Literal["mesh", "drawn"]]  # drawn: the box around what the visible layers draw. Where a part of the boundary is drawn, slices, volumes and the whole boundary do not widen it; an outline counts alone only.


class SceneBoundsResult(TypedDict):
    bounds: list[float]  # x minimum, x maximum, y minimum, y maximum, z minimum, z maximum


class ScenePickParams(TypedDict):
    """scene.pick: The first polygon on the line of sight through a pixel of a picture of the given size. Nothing is drawn for it: lines, points and volumes are not met."""

    pixel: list[float]  # x, y from the top left
    width: int  # of the picture, pixels
    height: int  # of the picture, pixels
    session: NotRequired[str]  # without it, `scene` is used and nothing is kept
    scene: NotRequired[Scene]  # the scene to be used in place of a session's; nothing is kept of it


class ScenePickResult(TypedDict):
    position: Vec3 | None  # null where no polygon is met
    layer: str | None  # whose polygon it is
    patch: str | None  # of the boundary, where the layer is a surface
    centre: Vec3 | None  # the middle of the box around the points of layers that the picture shows, hidden ones too: of a part of the boundary where one is in view; null where none is


class ColorRangeParams(TypedDict):
    """color.range: The range of the values that color layers, as far as they are in view."""

    layers: list[str]  # ids of layers of the scene
    session: NotRequired[str]  # without it, `scene` is used and nothing is kept
    scene: NotRequired[Scene]  # the scene to be used in place of a session's; nothing is kept of it
    aspect: NotRequired[float]  # width / height of the view; without it, what lies beside the view counts, too
    of: NotRequired[Literal["layers", "contours"]]  # contours: of the values of the contour lines on the layers, which have a color scale of their own


class ColorRangeResult(TypedDict):
    range: Range | None  # null where no value is in view


class SurfaceExportParams(TypedDict):
    """surface.export: A layer's surface as a file, cut by the visible clip planes and with their caps, as pictures show it."""

    layer: str  # the id of an iso-surface, slice or surface layer of the scene
    format: Literal["ply", "stl", "vtp"]  # PLY (binary), STL (binary) or VTK's XML PolyData
    session: NotRequired[str]  # without it, `scene` is used and nothing is kept
    scene: NotRequired[Scene]  # the scene to be used in place of a session's; nothing is kept of it
    triangles: NotRequired[bool]  # true: polygons are cut into triangles; STL has triangles in any case
    origin: NotRequired[bool]  # true: coordinates are relative to an origin that is the same for all surfaces of the dataset; STL is so in any case where its floats would lose digits
    progress: NotRequired[str]  # a name of the caller's own for call.progress, which is sent to the calling WebSocket, or after a POST to all WebSockets of the session


class SurfaceExportResult(TypedDict):
    mime: str
    name: str
    data: str  # base64 (RFC 4648)
    polygons: int
    vertices: int
    origin: Vec3  # what the file's coordinates are relative to; the file says it too


class AppendBeginParams(TypedDict):
    """append.begin: Begins to push a step to a dataset, and checks it: time, names, sizes, limits, free disk. Needs `ciel serve --allow-append` and the server's token."""

    dataset: str  # a name of dataset.list
    time: float  # of the step; later than the last one
    arrays: list[WantedArray]  # the arrays of the step


AppendBeginResult = Upload


class AppendPieceParams(TypedDict):
    """append.piece: Adds bytes to an array of an upload. On a WebSocket a binary message does the same (frame.md)."""

    upload: str  # as append.begin answered
    array: int  # its place among the arrays of append.begin, from 0
    offset: int  # of the first byte among the array's; at most as many as have come, so that a piece may be sent again
    data: str  # base64 (RFC 4648) of little-endian values in the `type` of append.begin, interleaved by component; at most `piece_bytes` bytes


class AppendPieceResult(TypedDict):
    received: int  # bytes of the array that have come


class AppendCommitParams(TypedDict):
    """append.commit: Writes the step of an upload whose arrays have all come; every client then hears of it. When it fails, the upload stays."""

    upload: str  # as append.begin answered


class AppendCommitResult(TypedDict):
    step: int  # its number, from 0
    time: float


class AppendCancelParams(TypedDict):
    """append.cancel: Forgets an upload."""

    upload: str  # as append.begin answered


AppendCancelResult = None


class DatasetChangedParams(TypedDict):
    """dataset.changed: Steps were appended. No times: it can no longer be opened, and dataset.list says why."""

    dataset: str  # a name of dataset.list
    times: NotRequired[list[float]]  # absent where the message would be longer than 512 KiB: call dataset.describe


class SceneChangedParams(TypedDict):
    """scene.changed: Another client of this session changed its scene. The scene is absent where the message would be longer than 512 KiB: call scene.get."""

    session: str  # the id that session.open answered with
    revision: int  # counts the changes of the session's scene
    scene: NotRequired[Scene]  # the whole scene, as it is now


class ViewFailedParams(TypedDict):
    """view.failed: A frame could not be made; the last one stays."""

    view: int  # the number that view.open answered with
    revision: int  # of the scene that the frame was of
    message: str  # a sentence for the user


class ViewLackingParams(TypedDict):
    """view.lacking: What the next frame lacks, a sentence each: layers whose array was not written at its time, points that are too many to show all; and of which layers that are switched on it shows nothing. Empty when nothing is lacking any more."""

    view: int  # the number that view.open answered with
    revision: int  # of the scene that the frame is of
    sentences: list[str]  # for the user
    empty: list[EmptyLayer]  # layers that are switched on and show nothing
    missing: list[str]  # layers whose colors have places without a value


class CallProgressParams(TypedDict):
    """call.progress: How far a call is that gave a `progress`. The first comes when the call has had its turn."""

    progress: str  # as the call gave it
    stage: Literal["surfaces", "waiting", "drawing", "writing"]  # waiting: for another picture to be drawn
    done: int  # layers made, of the stage surfaces
    of: int  # layers of the stage surfaces; 0: not counted


class AppendRefusedParams(TypedDict):
    """append.refused: A binary piece of an upload was not taken; the upload stays as it was."""

    upload: str  # as append.begin answered
    reason: str  # a sentence


class ServerDrainingParams(TypedDict):
    """server.draining: The server is about to stop."""

    pass


PROTOCOL = {"major": 1, "minor": 1}  # the version of the contract
ERROR_CODES: dict[str, int] = {
    "NotFound": -32001,
    "InvalidScene": -32002,
    "Limit": -32003,
    "NeedsWebSocket": -32004,
    "Failed": -32005,
    "AnswerTooLong": -32006,
    "NotAllowed": -32007,
}
