"""A small client of a CIEL server."""

from .client import Client, RpcError, Stream
from .frames import Batch, Batches, Frame, Pieces, read_frame
from .version import __version__

__all__ = ["Batch", "Batches", "Client", "Frame", "Pieces", "RpcError", "Stream", "__version__", "read_frame"]
