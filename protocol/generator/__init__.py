"""openrpc.json -> C++, TypeScript and Python: one emitter per language, one model for all."""
