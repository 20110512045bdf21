"""Makes the Python suite's file writers and dataset reader available."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "python"))
