"""The writers of small files and the readers of datasets are those of the Python suite."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "python"))
