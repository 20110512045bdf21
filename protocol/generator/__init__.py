"""Generates C++, TypeScript and Python from openrpc.json, read by model.py, and from frame_header.json."""
