"""Queue of the frames that have arrived but have not been taken yet."""

from __future__ import annotations

import asyncio
import collections

from .frames import Frame


class FrameQueue:
    """A queue of at most `most_bytes` bytes, for one event loop. Any number of tasks may take frames."""

    def __init__(self, most_bytes: int) -> None:
        self._most_bytes = most_bytes
        self._bytes = 0
        self._frames: collections.deque[Frame] = collections.deque()
        self._end: str | None = None  # reason for the end; None while frames may come
        self._changed = asyncio.Condition()

    async def put(self, frame: Frame) -> None:
        """Adds a frame. Raises BufferError if the frames would exceed the limit. A single frame always fits."""
        async with self._changed:
            if self._frames and self._bytes + len(frame.payload) > self._most_bytes:
                raise BufferError(
                    f"more than {self._most_bytes} bytes of frames wait to be taken; take frames, close views that "
                    "are not needed, or give a larger most_frame_bytes"
                )
            self._frames.append(frame)
            self._bytes += len(frame.payload)
            self._changed.notify()

    async def end(self, reason: str) -> None:
        """Ends the queue: no more frames are added. Frames that have arrived can still be taken."""
        async with self._changed:
            self._end = reason
            self._changed.notify_all()

    async def take(self) -> Frame:
        """Waits for a frame and returns the oldest frame. Raises ConnectionError after the last frame."""
        async with self._changed:
            await self._changed.wait_for(lambda: self._frames or self._end is not None)
            if not self._frames:
                raise ConnectionError(self._end)
            frame = self._frames.popleft()
            self._bytes -= len(frame.payload)
            return frame
