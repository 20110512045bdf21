"""Generates C++, TypeScript and Python from openrpc.json. All emitters read the same model."""
