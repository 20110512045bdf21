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
    """rpc.discover: Returns this document."""

    pass


RpcDiscoverResult = dict[str, Any]


class ServerInfoParams(TypedDict):
    """server.info: Returns the server's version, GL renderer, limits, color maps, layer types and streams."""

    pass


class ServerInfoResultProtocol(TypedDict):
    """Version of this document."""

    major: int
    minor: int


class ServerInfoResult(TypedDict):
    version: str  # Version of the program ciel.
    protocol: ServerInfoResultProtocol  # Version of this document.
    gl_renderer: str
    backend: str
    algorithm: Literal["signatures", "propagation"]  # How the server finds surfaces. Each algorithm finds the same ones.
    engine: str  # The algorithm. Deprecated: the same value as `algorithm`, kept in all minor versions of protocol 1.
    limits: dict[str, float]  # Limits of the server by name, in the units that `ciel serve --help` states: bytes, seconds, pixels or counts.
    color_maps: list[str]
    layer_types: list[str]  # Allowed values of a layer's `type`.
    streams: list[str]  # Allowed values of a view's `stream`.


class DatasetListParams(TypedDict):
    """dataset.list: Returns the names of the datasets that the server offers."""

    pass


class DatasetListResultItem(TypedDict):
    name: str
    problem: str  # Reason why the dataset cannot be opened. Empty if it can be opened.


DatasetListResult = list[DatasetListResultItem]


class DatasetDescribeParams(TypedDict):
    """dataset.describe: Returns a dataset's arrays, times, bounds and patches, and a scene to start from."""

    dataset: str  # Name of the dataset, as in dataset.list.


DatasetDescribeResult = DatasetDescription


class DatasetOpenParams(TypedDict):
    """dataset.open: Replaces a session's scene with a dataset's default scene. scene.undo restores the earlier scene."""

    session: str  # Id of the session, as session.open returned it.
    dataset: str  # Name of the dataset, as in dataset.list.


DatasetOpenResult = SessionState


class DatasetHistogramParams(TypedDict):
    """dataset.histogram: Counts the values of a scalar at one time step in bins of equal width."""

    dataset: str  # Name of the dataset, as in dataset.list.
    array: str  # Name of the scalar, such as `p`, `U:x` or `cell:p`.
    time: NotRequired[float]  # Simulation time; the nearest step is used. Default: the first step.
    bins: NotRequired[int]  # Number of bins of equal width. Each excludes its upper end, except the last. (1 to 4096, default 256)
    range: NotRequired[Range]  # Range that the bins divide, with minimum < maximum. Default: the range of the finite values at the step.
    progress: NotRequired[str]  # Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call, and to no one after a POST. Absent: no notifications.


class DatasetHistogramResult(TypedDict):
    range: Range
    counts: list[int]
    invalid: int  # Number of values that are NaN or infinite.
    below: int
    above: int
    cells: NotRequired[CellExtremes]  # Cells with the lowest and the highest value at this step. Present for arrays on cells and for point arrays that were made from them, if the cells are known.


class SessionOpenParams(TypedDict):
    """session.open: Opens a new session or joins an existing one. A WebSocket that calls it receives scene.changed for the session."""

    session: NotRequired[str]  # Id of the session to join. If there is none with this id, a session with this id is opened. The id is the key to the session, so a client that chooses one must make it from 128 random bits. Absent: the server chooses an id.
    dataset: NotRequired[str]  # Dataset whose default scene a new session shows. Default: the first of dataset.list that can be opened. Ignored if `scene` is given.
    scene: NotRequired[Scene]  # Scene of a new session. An existing session keeps its own.
    undo: NotRequired[list[dict[str, Any]]]  # Undo history of a new session, for a client whose server was restarted: RFC 7396 merge patches, the nearest step first. The first patch applies to the scene, each other patch to the result of the one before it. An existing session keeps its own history. (at most 50 items)
    redo: NotRequired[list[dict[str, Any]]]  # Redo history of a new session, for a client whose server was restarted: RFC 7396 merge patches, the nearest step first. The first patch applies to the scene, each other patch to the result of the one before it. An existing session keeps its own history. (at most 50 items)


SessionOpenResult = SessionState


class SessionCloseParams(TypedDict):
    """session.close: Ends a session and deletes its scene and history."""

    session: str  # Id of the session, as session.open returned it.


SessionCloseResult = None


class SceneGetParams(TypedDict):
    """scene.get: Returns the scene of a session."""

    session: str  # Id of the session, as session.open returned it.


SceneGetResult = SessionState


class ScenePatchParams(TypedDict):
    """scene.patch: Applies an RFC 7396 merge patch to a session's scene. Consecutive patches with the same gesture are one undo step."""

    session: str  # Id of the session, as session.open returned it.
    patch: dict[str, Any]  # RFC 7396 merge patch of the scene. null removes a member.
    gesture: NotRequired[str]  # Any text that identifies one action of the user, such as one drag of a slider. At most 256 bytes of UTF-8. Absent: the patch is its own undo step.


ScenePatchResult = Revision


class SceneUndoParams(TypedDict):
    """scene.undo: Undoes the last change of a session's scene."""

    session: str  # Id of the session, as session.open returned it.


SceneUndoResult = SessionState


class SceneRedoParams(TypedDict):
    """scene.redo: Redoes the change of a session's scene that was undone last."""

    session: str  # Id of the session, as session.open returned it.


SceneRedoResult = SessionState


class ViewOpenParams(TypedDict):
    """view.open: Opens a view of a session. The server sends its frames on this WebSocket."""

    session: str  # Id of the session, as session.open returned it.
    width: int  # Width of the view in pixels. (16 to 8192)
    height: int  # Height of the view in pixels. (16 to 8192)
    pixel_ratio: NotRequired[float]  # Factor on the widths of lines and the sizes of points. In a browser, devicePixelRatio. (0.25 to 16, default 1)
    stream: NotRequired[Literal["image", "geometry"]]  # What the frames contain (frame.md). image: pictures. geometry: polygons that the client draws. (default 'image')
    moving: NotRequired[Literal["png", "jpeg"]]  # Format of interactive pictures. Stills are always PNG. (default 'png')


class ViewOpenResult(TypedDict):
    view: int


class ViewResizeParams(TypedDict):
    """view.resize: Changes the size of a view."""

    view: int  # Number of the view, as view.open returned it. (at least 1)
    width: int  # New width of the view in pixels. (16 to 8192)
    height: int  # New height of the view in pixels. (16 to 8192)
    pixel_ratio: NotRequired[float]  # Factor on the widths of lines and the sizes of points. Absent: unchanged. (0.25 to 16)


ViewResizeResult = None


class ViewStreamParams(TypedDict):
    """view.stream: Switches a view between pictures and batches of polygons."""

    view: int  # Number of the view, as view.open returned it. (at least 1)
    stream: Literal["image", "geometry"]  # What the frames contain (frame.md). image: pictures. geometry: polygons that the client draws.
    moving: NotRequired[Literal["png", "jpeg"]]  # Format of interactive pictures. Stills are always PNG. Absent: unchanged.


ViewStreamResult = None


class ViewAckParams(TypedDict):
    """view.ack: Acknowledges that the client has presented a frame. Usually sent as a notification."""

    view: int  # Number of the view, as view.open returned it. (at least 1)
    frame: int  # Number of the frame, from its header.


ViewAckResult = None


class ViewCloseParams(TypedDict):
    """view.close: Closes a view. The server sends no more frames of it."""

    view: int  # Number of the view, as view.open returned it. (at least 1)


ViewCloseResult = None


class PictureRenderParams(TypedDict):
    """picture.render: Draws one lossless picture with all annotations and returns it as PNG."""

    session: NotRequired[str]  # Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
    scene: NotRequired[Scene]  # Scene to use instead of a session's. The server does not keep it after the call.
    width: NotRequired[int]  # Width in pixels. The server's limit for width times height is 33554432 pixels unless image_pixels of server.info says otherwise. (16 to 8192, default 1280)
    height: NotRequired[int]  # Height in pixels. Text and lines are larger in larger pictures. (16 to 8192, default 720)
    progress: NotRequired[str]  # Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.


PictureRenderResult = Picture


class ProbePointParams(TypedDict):
    """probe.point: Returns the values at a position, or at the position under a pixel of a picture of the given size."""

    session: NotRequired[str]  # Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
    scene: NotRequired[Scene]  # Scene to use instead of a session's. The server does not keep it after the call.
    position: NotRequired[Vec3]  # Position in the dataset's length units. Give either `position` or `pixel`.
    pixel: NotRequired[list[float]]  # Pixel [x, y] of the picture, counted from the top left. Needs `width` and `height`.
    width: NotRequired[int]  # Width in pixels of the picture that `pixel` belongs to. Required with `pixel`. (16 to 8192)
    height: NotRequired[int]  # Height in pixels of the picture that `pixel` belongs to. Required with `pixel`. (16 to 8192)
    progress: NotRequired[str]  # Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.


ProbePointResult = ProbeResult


class SceneCameraParams(TypedDict):
    """scene.camera: Returns the camera of a scene. If the scene has none, returns the default camera that pictures and views of this size use."""

    session: NotRequired[str]  # Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
    scene: NotRequired[Scene]  # Scene to use instead of a session's. The server does not keep it after the call.
    width: NotRequired[int]  # Width of the picture or view in pixels. The default camera shows the whole bounds beside the annotations, so it depends on the size. (16 to 8192, default 1280)
    height: NotRequired[int]  # Height of the picture or view in pixels. The default camera shows the whole bounds beside the annotations, so it depends on the size. (16 to 8192, default 720)
    progress: NotRequired[str]  # Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.


SceneCameraResult = Camera


class SceneBoundsParams(TypedDict):
    """scene.bounds: Returns the box to which a camera is fitted to show everything."""

    session: NotRequired[str]  # Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
    scene: NotRequired[Scene]  # Scene to use instead of a session's. The server does not keep it after the call.
    of: NotRequired[Literal["mesh", "drawn"]]  # mesh: the box of the mesh. Clip planes reduce it. Thresholds reduce it if all visible layers have one. Iso-surfaces and slices do not reduce it. If nothing is left, the result is the bounds of the dataset. drawn: the box of the polygons, lines and points that visible layers draw. If a part of the boundary is drawn (`groups` or a threshold), only this part and iso-surfaces count. Otherwise a volume counts as the whole box. If only outlines are drawn, the result is that of mesh. (default 'mesh')
    progress: NotRequired[str]  # Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.


class SceneBoundsResult(TypedDict):
    bounds: list[float]  # [x minimum, x maximum, y minimum, y maximum, z minimum, z maximum] in the dataset's length units.


class ScenePickParams(TypedDict):
    """scene.pick: Finds the first polygon under a pixel of a picture of the given size, without drawing. Lines, points and volumes are ignored."""

    pixel: list[float]  # Pixel [x, y], counted from the top left.
    width: int  # Width of the picture in pixels. (16 to 8192)
    height: int  # Height of the picture in pixels. (16 to 8192)
    session: NotRequired[str]  # Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
    scene: NotRequired[Scene]  # Scene to use instead of a session's. The server does not keep it after the call.
    progress: NotRequired[str]  # Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.


class ScenePickResult(TypedDict):
    position: Vec3 | None  # Position on the polygon. null if no polygon is under the pixel.
    layer: str | None  # Id of the layer that the polygon belongs to. null if no polygon is under the pixel.
    patch: str | None  # Patch of the polygon. null if the layer is not a surface layer or the polygon is in no patch.
    center: Vec3 | None  # Center of the box of all drawn vertices inside the picture, hidden ones included. If a part of the boundary (`groups` or a threshold) is inside, only its vertices count. null if there are none.


class ColorRangeParams(TypedDict):
    """color.range: Returns the range of the values by which layers are colored, or of the part that is in view."""

    layers: list[str]  # Ids of layers of the scene. (at most 64 items)
    session: NotRequired[str]  # Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
    scene: NotRequired[Scene]  # Scene to use instead of a session's. The server does not keep it after the call.
    aspect: NotRequired[float]  # Width / height of the view. If given, only values inside the view that no clip plane cuts away count. Absent: all values of the layers count. (0.01 to 100)
    of: NotRequired[Literal["layers", "contours"]]  # layers: values by which the layers are colored. contours: values of the contour lines on the layers, which have their own color scale. (default 'layers')
    progress: NotRequired[str]  # Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.


class ColorRangeResult(TypedDict):
    range: Range | None  # Smallest and largest finite value. null if there is none.


class SurfaceExportParams(TypedDict):
    """surface.export: Returns a layer's surface as a file. As in pictures, visible clip planes cut the surface, and caps close it."""

    layer: str  # Id of a visible iso, slice or surface layer of the scene.
    format: Literal["ply", "stl", "vtp"]  # ply: binary PLY. stl: binary STL. vtp: XML PolyData of VTK.
    session: NotRequired[str]  # Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
    scene: NotRequired[Scene]  # Scene to use instead of a session's. The server does not keep it after the call.
    triangles: NotRequired[bool]  # true: polygons are split into triangles. STL always has triangles. (default False)
    origin: NotRequired[bool]  # true: coordinates are relative to an origin that is the same for all surfaces of the dataset, and zero if 32-bit floats are precise enough for its bounds. STL always uses this origin. (default False)
    progress: NotRequired[str]  # Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.


class SurfaceExportResult(TypedDict):
    mime: str
    name: str
    data: str  # The file as base64 (RFC 4648).
    polygons: int
    vertices: int
    origin: Vec3  # Origin of the file's coordinates; the file states it too, unless it is zero.


class AppendBeginParams(TypedDict):
    """append.begin: Begins the upload of a time step. Checks time, names, sizes, limits and free disk space. Needs `ciel serve --allow-append` and the server's token."""

    dataset: str  # Name of the dataset, as in dataset.list.
    time: float  # Time of the step. It must be later than the last step of the dataset.
    arrays: list[WantedArray]  # Arrays of the step. (1 to 256 items)


AppendBeginResult = Upload


class AppendPieceParams(TypedDict):
    """append.piece: Adds bytes to one array of an upload. On a WebSocket, a binary message does the same (frame.md)."""

    upload: str  # Id of the upload, as append.begin returned it.
    array: int  # Index of the array in `arrays` of append.begin, from 0. (0 to 255)
    offset: int  # Offset of the first byte in the array. At most the number of bytes received so far. A piece may be sent again. (at least 0)
    data: str  # Little-endian values as base64 (RFC 4648), in the `type` of append.begin, interleaved by component. At most `piece_bytes` bytes before encoding.


class AppendPieceResult(TypedDict):
    received: int  # Number of bytes of the array received so far.


class AppendCommitParams(TypedDict):
    """append.commit: Writes the step of a completely received upload to the dataset and notifies all clients. If it fails, the upload is kept."""

    upload: str  # Id of the upload, as append.begin returned it.
    progress: NotRequired[str]  # Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call, and to no one after a POST. Absent: no notifications.


class AppendCommitResult(TypedDict):
    step: int  # Index of the new step, from 0.
    time: float


class AppendCancelParams(TypedDict):
    """append.cancel: Cancels an upload and deletes its bytes. Fails while append.commit stores the upload."""

    upload: str  # Id of the upload, as append.begin returned it.


AppendCancelResult = None


class DatasetChangedParams(TypedDict):
    """dataset.changed: Steps were appended to a dataset. If `times` is empty, the dataset can no longer be opened, and dataset.list has the reason."""

    dataset: str  # Name of the dataset, as in dataset.list.
    times: NotRequired[list[float]]  # Times of all steps. Absent if the message would be longer than 512 KiB; then call dataset.describe.


class SceneChangedParams(TypedDict):
    """scene.changed: Another client of the session changed its scene."""

    session: str  # Id of the session, as session.open returned it.
    revision: int  # Revision of the scene. Each change of the scene has the next revision.
    scene: NotRequired[Scene]  # The whole new scene. Absent if the message would be longer than 512 KiB; then call scene.get.


class ViewFailedParams(TypedDict):
    """view.failed: A frame of a view could not be made. The view keeps its last frame."""

    view: int  # Number of the view, as view.open returned it. (at least 1)
    revision: int  # Revision of the scene that the frame would have shown.
    message: str  # Sentence for the user.
    request: str  # Id of the call that made the scene. The failure has the same id in the server's log.


class ViewLackingParams(TypedDict):
    """view.lacking: Data that the next frame of a view does not show. Sent when this changes; all lists are empty if nothing is lacking any more."""

    view: int  # Number of the view, as view.open returned it. (at least 1)
    revision: int  # Revision of the scene that the frame shows.
    sentences: list[str]  # Sentences for the user, for example about arrays that were not written at this time or about too many points.
    empty: list[EmptyLayer]  # Visible layers of which nothing is seen, with the reasons.
    missing: list[str]  # Ids of layers that are colored by an array and have places without a finite value. These places have the color `nan`.


class CallProgressParams(TypedDict):
    """call.progress: Progress of a call that has a parameter `progress`. The first is sent when the call leaves the queue."""

    progress: str  # Name that the call gave as `progress`.
    stage: Literal["reading", "surfaces", "measuring", "waiting", "drawing", "writing"]  # reading: the step is being read from the dataset's source. The call begins again after a pause, so its stages repeat. surfaces: makes the surfaces of the layers. measuring: finds the cell, range, box, point or counts of the answer. waiting: another picture is drawn first, or another commit ends first. drawing: draws the picture. writing: makes the file, or writes the step of append.commit.
    done: int  # Number of layers made in the stage surfaces, of values read by dataset.histogram, or of arrays written by append.commit. 0 in other stages. (at least 0)
    of: int  # Number of layers to make, of values to read (each twice if `range` is absent), or of arrays to write. 0 in other stages. (at least 0)


class AppendRefusedParams(TypedDict):
    """append.refused: The server refused a binary piece of an upload. The upload is unchanged."""

    upload: str  # Id of the upload, as append.begin returned it.
    reason: str  # Sentence that states the reason.
    request: str  # Id of the refusal in the server's log.


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
