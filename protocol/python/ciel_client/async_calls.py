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
        """This document."""
        return await self.call("rpc.discover")

    async def server_info(self) -> ServerInfoResult:
        """Version, GL renderer, limits, color maps."""
        return await self.call("server.info")

    async def dataset_list(self) -> DatasetListResult:
        """The datasets on offer."""
        return await self.call("dataset.list")

    async def dataset_describe(
        self,
        *,
        dataset: str,
    ) -> DatasetDescribeResult:
        """Arrays, times, bounds, patches and a scene to start from.

        dataset: a name of dataset.list
        """
        return await self.call("dataset.describe", dataset=dataset)

    async def dataset_open(
        self,
        *,
        session: str,
        dataset: str,
    ) -> DatasetOpenResult:
        """Shows a dataset's default scene in a session, as an undoable change.

        session: the id that session.open answered with
        dataset: a name of dataset.list
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
    ) -> DatasetHistogramResult:
        """Counts of a scalar's values at one time.

        dataset: a name of dataset.list
        array: a scalar name, such as `p`, `U:x` or `cell:p`
        time: the first time when absent
        bins: of equal width; the last one holds its upper end, too
        range: the array's own when absent
        """
        return await self.call("dataset.histogram", dataset=dataset, array=array, time=time, bins=bins, range=range)

    async def session_open(
        self,
        *,
        session: str | None = None,
        dataset: str | None = None,
        scene: Scene | None = None,
        undo: list[dict[str, Any]] | None = None,
        redo: list[dict[str, Any]] | None = None,
    ) -> SessionOpenResult:
        """A new session, or one that exists; over WebSocket the connection then hears of its changes.

        session: an id to join or recreate; it is the session's key, so a client that chooses one makes it of 128 random bits
        dataset: whose default scene a new session shows; the first of dataset.list when absent
        scene: the scene of a new session
        undo: RFC 7396 merge patches, nearest step first: what scene.undo goes back to in a new session. The first applies to the scene, each other to the result of the one before it. For a client whose server was restarted; an existing session keeps its own history
        redo: likewise for scene.redo
        """
        return await self.call("session.open", session=session, dataset=dataset, scene=scene, undo=undo, redo=redo)

    async def session_close(
        self,
        *,
        session: str,
    ) -> SessionCloseResult:
        """Forgets the session.

        session: the id that session.open answered with
        """
        return await self.call("session.close", session=session)

    async def scene_get(
        self,
        *,
        session: str,
    ) -> SceneGetResult:
        """The session's scene.

        session: the id that session.open answered with
        """
        return await self.call("scene.get", session=session)

    async def scene_patch(
        self,
        *,
        session: str,
        patch: dict[str, Any],
        gesture: str | None = None,
    ) -> ScenePatchResult:
        """Applies an RFC 7396 merge patch. Patches with the same gesture are one undo step.

        session: the id that session.open answered with
        patch: an RFC 7396 merge patch of the scene: null removes a member
        gesture: any text that names what the user is doing, such as one drag of a slider; at most 256 bytes of UTF-8
        """
        return await self.call("scene.patch", session=session, patch=patch, gesture=gesture)

    async def scene_undo(
        self,
        *,
        session: str,
    ) -> SceneUndoResult:
        """Takes the last step back.

        session: the id that session.open answered with
        """
        return await self.call("scene.undo", session=session)

    async def scene_redo(
        self,
        *,
        session: str,
    ) -> SceneRedoResult:
        """Does it again.

        session: the id that session.open answered with
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
        """A stream of frames of the session on this WebSocket.

        session: the id that session.open answered with
        width: in pixels
        height: in pixels
        pixel_ratio: pixels of the pictures for one of lines and points: what the page is shown with (devicePixelRatio)
        stream: pictures, or polygons for the client to draw (frame.md)
        moving: How interactive pictures are coded; a still is a PNG.
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
        """Changes the size of a view's pictures.

        view: the number that view.open answered with
        width: in pixels
        height: in pixels
        pixel_ratio: as in view.open; without it this stays as it is
        """
        return await self.call("view.resize", view=view, width=width, height=height, pixel_ratio=pixel_ratio)

    async def view_stream(
        self,
        *,
        view: int,
        stream: Literal["image", "geometry"],
        moving: Literal["png", "jpeg"] | None = None,
    ) -> ViewStreamResult:
        """Chooses pictures or polygon batches.

        view: the number that view.open answered with
        stream: pictures, or polygons for the client to draw (frame.md)
        moving: As in view.open; without it this stays as it is.
        """
        return await self.call("view.stream", view=view, stream=stream, moving=moving)

    async def view_ack(
        self,
        *,
        view: int,
        frame: int,
    ) -> ViewAckResult:
        """The frame has been presented (usually a notification).

        view: the number that view.open answered with
        frame: the number in the frame's header
        """
        return await self.call("view.ack", view=view, frame=frame)

    async def view_close(
        self,
        *,
        view: int,
    ) -> ViewCloseResult:
        """Ends the stream.

        view: the number that view.open answered with
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
        """A lossless still picture.

        session: without it, `scene` is used and nothing is kept
        scene: the scene to be used in place of a session's; nothing is kept of it
        width: width times height may be at most 33554432
        height: in pixels; text and lines grow with it
        progress: a name of the caller's own for call.progress, which is sent to the calling WebSocket, or after a POST to all WebSockets of the session
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
    ) -> ProbePointResult:
        """Values at a world position, or under a pixel of a picture of the given size.

        session: without it, `scene` is used and nothing is kept
        scene: the scene to be used in place of a session's; nothing is kept of it
        position: in the dataset's length units; either this or a pixel
        pixel: x, y from the top left
        width: of the picture that the pixel is of; with pixel
        height: of the picture that the pixel is of; with pixel
        """
        return await self.call("probe.point", session=session, scene=scene, position=position, pixel=pixel, width=width, height=height)

    async def scene_camera(
        self,
        *,
        session: str | None = None,
        scene: Scene | None = None,
        width: int = 1280,
        height: int = 720,
    ) -> SceneCameraResult:
        """Where a scene is seen from: its own camera, or the one that pictures and views of a scene without one have.

        session: without it, `scene` is used and nothing is kept
        scene: the scene to be used in place of a session's; nothing is kept of it
        width: of the picture or the view: without a camera all of the bounds is seen, clear of what is written
        height: of the picture or the view, in pixels
        """
        return await self.call("scene.camera", session=session, scene=scene, width=width, height=height)

    async def scene_bounds(
        self,
        *,
        session: str | None = None,
        scene: Scene | None = None,
        of: Literal["mesh", "drawn"] = 'mesh',
    ) -> SceneBoundsResult:
        """The box around what clip planes and thresholds leave of the mesh: what a view of everything frames. Iso-surfaces and slices do not narrow it; where nothing is left it is the dataset's.

        session: without it, `scene` is used and nothing is kept
        scene: the scene to be used in place of a session's; nothing is kept of it
        of: drawn: the box around what the visible layers draw. Where a part of the boundary is drawn, slices, volumes and the whole boundary do not widen it; an outline counts alone only.
        """
        return await self.call("scene.bounds", session=session, scene=scene, of=of)

    async def scene_pick(
        self,
        *,
        pixel: list[float],
        width: int,
        height: int,
        session: str | None = None,
        scene: Scene | None = None,
    ) -> ScenePickResult:
        """The first polygon on the line of sight through a pixel of a picture of the given size. Nothing is drawn for it: lines, points and volumes are not met.

        pixel: x, y from the top left
        width: of the picture, pixels
        height: of the picture, pixels
        session: without it, `scene` is used and nothing is kept
        scene: the scene to be used in place of a session's; nothing is kept of it
        """
        return await self.call("scene.pick", pixel=pixel, width=width, height=height, session=session, scene=scene)

    async def color_range(
        self,
        *,
        layers: list[str],
        session: str | None = None,
        scene: Scene | None = None,
        aspect: float | None = None,
        of: Literal["layers", "contours"] = 'layers',
    ) -> ColorRangeResult:
        """The range of the values that color layers, as far as they are in view.

        layers: ids of layers of the scene
        session: without it, `scene` is used and nothing is kept
        scene: the scene to be used in place of a session's; nothing is kept of it
        aspect: width / height of the view; without it, what lies beside the view counts, too
        of: contours: of the values of the contour lines on the layers, which have a color scale of their own
        """
        return await self.call("color.range", layers=layers, session=session, scene=scene, aspect=aspect, of=of)

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
        """A layer's surface as a file, cut by the visible clip planes and with their caps, as pictures show it.

        layer: the id of an iso-surface, slice or surface layer of the scene
        format: PLY (binary), STL (binary) or VTK's XML PolyData
        session: without it, `scene` is used and nothing is kept
        scene: the scene to be used in place of a session's; nothing is kept of it
        triangles: true: polygons are cut into triangles; STL has triangles in any case
        origin: true: coordinates are relative to an origin that is the same for all surfaces of the dataset; STL is so in any case where its floats would lose digits
        progress: a name of the caller's own for call.progress, which is sent to the calling WebSocket, or after a POST to all WebSockets of the session
        """
        return await self.call("surface.export", layer=layer, format=format, session=session, scene=scene, triangles=triangles, origin=origin, progress=progress)

    async def append_begin(
        self,
        *,
        dataset: str,
        time: float,
        arrays: list[WantedArray],
    ) -> AppendBeginResult:
        """Begins to push a step to a dataset, and checks it: time, names, sizes, limits, free disk. Needs `ciel serve --allow-append` and the server's token.

        dataset: a name of dataset.list
        time: of the step; later than the last one
        arrays: the arrays of the step
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
        """Adds bytes to an array of an upload. On a WebSocket a binary message does the same (frame.md).

        upload: as append.begin answered
        array: its place among the arrays of append.begin, from 0
        offset: of the first byte among the array's; at most as many as have come, so that a piece may be sent again
        data: base64 (RFC 4648) of little-endian values in the `type` of append.begin, interleaved by component; at most `piece_bytes` bytes
        """
        return await self.call("append.piece", upload=upload, array=array, offset=offset, data=data)

    async def append_commit(
        self,
        *,
        upload: str,
    ) -> AppendCommitResult:
        """Writes the step of an upload whose arrays have all come; every client then hears of it. When it fails, the upload stays.

        upload: as append.begin answered
        """
        return await self.call("append.commit", upload=upload)

    async def append_cancel(
        self,
        *,
        upload: str,
    ) -> AppendCancelResult:
        """Forgets an upload.

        upload: as append.begin answered
        """
        return await self.call("append.cancel", upload=upload)
