"""Generated from server/ciel/version.txt; do not edit."""

__version__ = "0.2.0"
