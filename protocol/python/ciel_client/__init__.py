"""A small client of a CIEL server."""

from .client import Client, RpcError, Stream
from .frames import Batch, Frame, Pieces, read_batch, read_frame

__all__ = ["Batch", "Client", "Frame", "Pieces", "RpcError", "Stream", "read_batch", "read_frame"]
