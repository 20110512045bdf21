"""Generated from protocol/openrpc.json; do not edit."""

from typing import Any, Literal

from .types import (
    AppendBeginResult,
    AppendCancelResult,
    AppendCommitResult,
    AppendPieceResult,
    ColorRangeResult,
    DatasetDescribeResult,
    DatasetHistogramResult,
    DatasetListResult,
    DatasetOpenResult,
    PictureRenderResult,
    ProbePointResult,
    Range,
    RpcDiscoverResult,
    Scene,
    SceneBoundsResult,
    SceneCameraResult,
    SceneGetResult,
    ScenePatchResult,
    ScenePickResult,
    SceneRedoResult,
    SceneUndoResult,
    ServerInfoResult,
    SessionCloseResult,
    SessionOpenResult,
    SurfaceExportResult,
    Vec3,
    ViewAckResult,
    ViewCloseResult,
    ViewOpenResult,
    ViewResizeResult,
    ViewStreamResult,
    WantedArray,
)


class AsyncCalls:
    async def call(self, method: str, **params: Any) -> Any:
        """Calls a method. Parameters that are None are left out."""
        raise NotImplementedError

    async def rpc_discover(self) -> RpcDiscoverResult:
        """Returns this document."""
        return await self.call("rpc.discover")

    async def server_info(self) -> ServerInfoResult:
        """Returns the server's version, GL renderer, limits, color maps, layer types and streams."""
        return await self.call("server.info")

    async def dataset_list(self) -> DatasetListResult:
        """Returns the names of the datasets that the server offers."""
        return await self.call("dataset.list")

    async def dataset_describe(
        self,
        *,
        dataset: str,
    ) -> DatasetDescribeResult:
        """Returns a dataset's arrays, times, bounds and patches, and a scene to start from.

        dataset: Name of the dataset, as in dataset.list.
        """
        return await self.call("dataset.describe", dataset=dataset)

    async def dataset_open(
        self,
        *,
        session: str,
        dataset: str,
    ) -> DatasetOpenResult:
        """Replaces a session's scene with a dataset's default scene. scene.undo restores the earlier scene.

        session: Id of the session, as session.open returned it.
        dataset: Name of the dataset, as in dataset.list.
        """
        return await self.call("dataset.open", session=session, dataset=dataset)

    async def dataset_histogram(
        self,
        *,
        dataset: str,
        array: str,
        time: float | None = None,
        bins: int = 256,
        range: Range | None = None,
        progress: str | None = None,
    ) -> DatasetHistogramResult:
        """Counts the values of a scalar at one time step in bins of equal width.

        dataset: Name of the dataset, as in dataset.list.
        array: Name of the scalar, such as `p`, `U:x` or `cell:p`.
        time: Simulation time; the nearest step is used. Default: the first step.
        bins: Number of bins of equal width. Each excludes its upper end, except the last. (1 to 4096, default 256)
        range: Range that the bins divide, with minimum < maximum. Default: the range of the finite values at the step.
        progress: Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call, and to no one after a POST. Absent: no notifications.
        """
        return await self.call("dataset.histogram", dataset=dataset, array=array, time=time, bins=bins, range=range, progress=progress)

    async def session_open(
        self,
        *,
        session: str | None = None,
        dataset: str | None = None,
        scene: Scene | None = None,
        undo: list[dict[str, Any]] | None = None,
        redo: list[dict[str, Any]] | None = None,
    ) -> SessionOpenResult:
        """Opens a new session or joins an existing one. A WebSocket that calls it receives scene.changed for the session.

        session: Id of the session to join. If there is none with this id, a session with this id is opened. The id is the key to the session, so a client that chooses one must make it from 128 random bits. Absent: the server chooses an id.
        dataset: Dataset whose default scene a new session shows. Default: the first of dataset.list that can be opened. Ignored if `scene` is given.
        scene: Scene of a new session. An existing session keeps its own.
        undo: Undo history of a new session, for a client whose server was restarted: RFC 7396 merge patches, the nearest step first. The first patch applies to the scene, each other patch to the result of the one before it. An existing session keeps its own history. (at most 50 items)
        redo: Redo history of a new session, for a client whose server was restarted: RFC 7396 merge patches, the nearest step first. The first patch applies to the scene, each other patch to the result of the one before it. An existing session keeps its own history. (at most 50 items)
        """
        return await self.call("session.open", session=session, dataset=dataset, scene=scene, undo=undo, redo=redo)

    async def session_close(
        self,
        *,
        session: str,
    ) -> SessionCloseResult:
        """Ends a session and deletes its scene and history.

        session: Id of the session, as session.open returned it.
        """
        return await self.call("session.close", session=session)

    async def scene_get(
        self,
        *,
        session: str,
    ) -> SceneGetResult:
        """Returns the scene of a session.

        session: Id of the session, as session.open returned it.
        """
        return await self.call("scene.get", session=session)

    async def scene_patch(
        self,
        *,
        session: str,
        patch: dict[str, Any],
        gesture: str | None = None,
    ) -> ScenePatchResult:
        """Applies an RFC 7396 merge patch to a session's scene. Consecutive patches with the same gesture are one undo step.

        session: Id of the session, as session.open returned it.
        patch: RFC 7396 merge patch of the scene. null removes a member.
        gesture: Any text that identifies one action of the user, such as one drag of a slider. At most 256 bytes of UTF-8. Absent: the patch is its own undo step.
        """
        return await self.call("scene.patch", session=session, patch=patch, gesture=gesture)

    async def scene_undo(
        self,
        *,
        session: str,
    ) -> SceneUndoResult:
        """Undoes the last change of a session's scene.

        session: Id of the session, as session.open returned it.
        """
        return await self.call("scene.undo", session=session)

    async def scene_redo(
        self,
        *,
        session: str,
    ) -> SceneRedoResult:
        """Redoes the change of a session's scene that was undone last.

        session: Id of the session, as session.open returned it.
        """
        return await self.call("scene.redo", session=session)

    async def view_open(
        self,
        *,
        session: str,
        width: int,
        height: int,
        pixel_ratio: float = 1,
        stream: Literal["image", "geometry"] = 'image',
        moving: Literal["png", "jpeg"] = 'png',
    ) -> ViewOpenResult:
        """Opens a view of a session. The server sends its frames on this WebSocket.

        session: Id of the session, as session.open returned it.
        width: Width of the view in pixels. (16 to 8192)
        height: Height of the view in pixels. (16 to 8192)
        pixel_ratio: Factor on the widths of lines and the sizes of points. In a browser, devicePixelRatio. (0.25 to 16, default 1)
        stream: What the frames contain (frame.md). image: pictures. geometry: polygons that the client draws. (default 'image')
        moving: Format of interactive pictures. Stills are always PNG. (default 'png')
        """
        return await self.call("view.open", session=session, width=width, height=height, pixel_ratio=pixel_ratio, stream=stream, moving=moving)

    async def view_resize(
        self,
        *,
        view: int,
        width: int,
        height: int,
        pixel_ratio: float | None = None,
    ) -> ViewResizeResult:
        """Changes the size of a view.

        view: Number of the view, as view.open returned it. (at least 1)
        width: New width of the view in pixels. (16 to 8192)
        height: New height of the view in pixels. (16 to 8192)
        pixel_ratio: Factor on the widths of lines and the sizes of points. Absent: unchanged. (0.25 to 16)
        """
        return await self.call("view.resize", view=view, width=width, height=height, pixel_ratio=pixel_ratio)

    async def view_stream(
        self,
        *,
        view: int,
        stream: Literal["image", "geometry"],
        moving: Literal["png", "jpeg"] | None = None,
    ) -> ViewStreamResult:
        """Switches a view between pictures and batches of polygons.

        view: Number of the view, as view.open returned it. (at least 1)
        stream: What the frames contain (frame.md). image: pictures. geometry: polygons that the client draws.
        moving: Format of interactive pictures. Stills are always PNG. Absent: unchanged.
        """
        return await self.call("view.stream", view=view, stream=stream, moving=moving)

    async def view_ack(
        self,
        *,
        view: int,
        frame: int,
    ) -> ViewAckResult:
        """Acknowledges that the client has presented a frame. Usually sent as a notification.

        view: Number of the view, as view.open returned it. (at least 1)
        frame: Number of the frame, from its header.
        """
        return await self.call("view.ack", view=view, frame=frame)

    async def view_close(
        self,
        *,
        view: int,
    ) -> ViewCloseResult:
        """Closes a view. The server sends no more frames of it.

        view: Number of the view, as view.open returned it. (at least 1)
        """
        return await self.call("view.close", view=view)

    async def picture_render(
        self,
        *,
        session: str | None = None,
        scene: Scene | None = None,
        width: int = 1280,
        height: int = 720,
        progress: str | None = None,
    ) -> PictureRenderResult:
        """Draws one lossless picture with all annotations and returns it as PNG.

        session: Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
        scene: Scene to use instead of a session's. The server does not keep it after the call.
        width: Width in pixels. The server's limit for width times height is 33554432 pixels unless image_pixels of server.info says otherwise. (16 to 8192, default 1280)
        height: Height in pixels. Text and lines are larger in larger pictures. (16 to 8192, default 720)
        progress: Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.
        """
        return await self.call("picture.render", session=session, scene=scene, width=width, height=height, progress=progress)

    async def probe_point(
        self,
        *,
        session: str | None = None,
        scene: Scene | None = None,
        position: Vec3 | None = None,
        pixel: list[float] | None = None,
        width: int | None = None,
        height: int | None = None,
        progress: str | None = None,
    ) -> ProbePointResult:
        """Returns the values at a position, or at the position under a pixel of a picture of the given size.

        session: Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
        scene: Scene to use instead of a session's. The server does not keep it after the call.
        position: Position in the dataset's length units. Give either `position` or `pixel`.
        pixel: Pixel [x, y] of the picture, counted from the top left. Needs `width` and `height`.
        width: Width in pixels of the picture that `pixel` belongs to. Required with `pixel`. (16 to 8192)
        height: Height in pixels of the picture that `pixel` belongs to. Required with `pixel`. (16 to 8192)
        progress: Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.
        """
        return await self.call("probe.point", session=session, scene=scene, position=position, pixel=pixel, width=width, height=height, progress=progress)

    async def scene_camera(
        self,
        *,
        session: str | None = None,
        scene: Scene | None = None,
        width: int = 1280,
        height: int = 720,
        progress: str | None = None,
    ) -> SceneCameraResult:
        """Returns the camera of a scene. If the scene has none, returns the default camera that pictures and views of this size use.

        session: Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
        scene: Scene to use instead of a session's. The server does not keep it after the call.
        width: Width of the picture or view in pixels. The default camera shows the whole bounds beside the annotations, so it depends on the size. (16 to 8192, default 1280)
        height: Height of the picture or view in pixels. The default camera shows the whole bounds beside the annotations, so it depends on the size. (16 to 8192, default 720)
        progress: Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.
        """
        return await self.call("scene.camera", session=session, scene=scene, width=width, height=height, progress=progress)

    async def scene_bounds(
        self,
        *,
        session: str | None = None,
        scene: Scene | None = None,
        of: Literal["mesh", "drawn"] = 'mesh',
        progress: str | None = None,
    ) -> SceneBoundsResult:
        """Returns the box to which a camera is fitted to show everything.

        session: Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
        scene: Scene to use instead of a session's. The server does not keep it after the call.
        of: mesh: the box of the mesh. Clip planes reduce it. Thresholds reduce it if all visible layers have one. Iso-surfaces and slices do not reduce it. If nothing is left, the result is the bounds of the dataset. drawn: the box of the polygons, lines and points that visible layers draw. If a part of the boundary is drawn (`groups` or a threshold), only this part and iso-surfaces count. Otherwise a volume counts as the whole box. If only outlines are drawn, the result is that of mesh. (default 'mesh')
        progress: Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.
        """
        return await self.call("scene.bounds", session=session, scene=scene, of=of, progress=progress)

    async def scene_pick(
        self,
        *,
        pixel: list[float],
        width: int,
        height: int,
        session: str | None = None,
        scene: Scene | None = None,
        progress: str | None = None,
    ) -> ScenePickResult:
        """Finds the first polygon under a pixel of a picture of the given size, without drawing. Lines, points and volumes are ignored.

        pixel: Pixel [x, y], counted from the top left.
        width: Width of the picture in pixels. (16 to 8192)
        height: Height of the picture in pixels. (16 to 8192)
        session: Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
        scene: Scene to use instead of a session's. The server does not keep it after the call.
        progress: Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.
        """
        return await self.call("scene.pick", pixel=pixel, width=width, height=height, session=session, scene=scene, progress=progress)

    async def color_range(
        self,
        *,
        layers: list[str],
        session: str | None = None,
        scene: Scene | None = None,
        aspect: float | None = None,
        of: Literal["layers", "contours"] = 'layers',
        progress: str | None = None,
    ) -> ColorRangeResult:
        """Returns the range of the values by which layers are colored, or of the part that is in view.

        layers: Ids of layers of the scene. (at most 64 items)
        session: Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
        scene: Scene to use instead of a session's. The server does not keep it after the call.
        aspect: Width / height of the view. If given, only values inside the view that no clip plane cuts away count. Absent: all values of the layers count. (0.01 to 100)
        of: layers: values by which the layers are colored. contours: values of the contour lines on the layers, which have their own color scale. (default 'layers')
        progress: Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.
        """
        return await self.call("color.range", layers=layers, session=session, scene=scene, aspect=aspect, of=of, progress=progress)

    async def surface_export(
        self,
        *,
        layer: str,
        format: Literal["ply", "stl", "vtp"],
        session: str | None = None,
        scene: Scene | None = None,
        triangles: bool = False,
        origin: bool = False,
        progress: str | None = None,
    ) -> SurfaceExportResult:
        """Returns a layer's surface as a file. As in pictures, visible clip planes cut the surface, and caps close it.

        layer: Id of a visible iso, slice or surface layer of the scene.
        format: ply: binary PLY. stl: binary STL. vtp: XML PolyData of VTK.
        session: Id of the session whose scene is used. Give either `session` or `scene`; `scene` is used if both are given.
        scene: Scene to use instead of a session's. The server does not keep it after the call.
        triangles: true: polygons are split into triangles. STL always has triangles. (default False)
        origin: true: coordinates are relative to an origin that is the same for all surfaces of the dataset, and zero if 32-bit floats are precise enough for its bounds. STL always uses this origin. (default False)
        progress: Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call; after a POST, to all WebSockets of the session. Absent: no notifications.
        """
        return await self.call("surface.export", layer=layer, format=format, session=session, scene=scene, triangles=triangles, origin=origin, progress=progress)

    async def append_begin(
        self,
        *,
        dataset: str,
        time: float,
        arrays: list[WantedArray],
    ) -> AppendBeginResult:
        """Begins the upload of a time step. Checks time, names, sizes, limits and free disk space. Needs `ciel serve --allow-append` and the server's token.

        dataset: Name of the dataset, as in dataset.list.
        time: Time of the step. It must be later than the last step of the dataset.
        arrays: Arrays of the step. (1 to 256 items)
        """
        return await self.call("append.begin", dataset=dataset, time=time, arrays=arrays)

    async def append_piece(
        self,
        *,
        upload: str,
        array: int,
        offset: int,
        data: str,
    ) -> AppendPieceResult:
        """Adds bytes to one array of an upload. On a WebSocket, a binary message does the same (frame.md).

        upload: Id of the upload, as append.begin returned it.
        array: Index of the array in `arrays` of append.begin, from 0. (0 to 255)
        offset: Offset of the first byte in the array. At most the number of bytes received so far. A piece may be sent again. (at least 0)
        data: Little-endian values as base64 (RFC 4648), in the `type` of append.begin, interleaved by component. At most `piece_bytes` bytes before encoding.
        """
        return await self.call("append.piece", upload=upload, array=array, offset=offset, data=data)

    async def append_commit(
        self,
        *,
        upload: str,
        progress: str | None = None,
    ) -> AppendCommitResult:
        """Writes the step of a completely received upload to the dataset and notifies all clients. If it fails, the upload is kept.

        upload: Id of the upload, as append.begin returned it.
        progress: Any name, which the notifications call.progress of this call repeat. They go to the WebSocket of the call, and to no one after a POST. Absent: no notifications.
        """
        return await self.call("append.commit", upload=upload, progress=progress)

    async def append_cancel(
        self,
        *,
        upload: str,
    ) -> AppendCancelResult:
        """Cancels an upload and deletes its bytes. Fails while append.commit stores the upload.

        upload: Id of the upload, as append.begin returned it.
        """
        return await self.call("append.cancel", upload=upload)
