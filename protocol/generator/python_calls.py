"""Emits the methods of the contract as Python functions: mixins for the synchronous and the asynchronous client."""

import re

from .model import Contract, Field, Method, described, pascal
from .python import Types


class Signatures:
    def __init__(self, contract: Contract) -> None:
        self.contract = contract
        self.names: set[str] = set()  # names to import from types.py

    def type_of(self, method: Method, one: Field) -> str:
        text = Types().type_of(one.schema, f"{method.type_prefix}Params{pascal(one.name)}")
        without_words = re.sub(r'"[^"]*"', "", text)
        self.names |= set(re.findall(r"\b[A-Z]\w*", without_words)) - {"Any", "Literal", "None"}
        return text

    def parameter(self, method: Method, one: Field) -> str:
        text = self.type_of(method, one)
        if one.required:
            return f"        {one.name}: {text},\n"
        if "default" in one.schema:
            return f"        {one.name}: {text} = {one.schema['default']!r},\n"
        return f"        {one.name}: {text if text.endswith('None') else text + ' | None'} = None,\n"

    def function(self, method: Method, is_async: bool) -> str:
        result = f"{method.type_prefix}Result"
        self.names.add(result)
        start = "async def" if is_async else "def"
        parameters = "".join(self.parameter(method, one) for one in method.params)
        signature = f"(\n        self,\n        *,\n{parameters}    )" if parameters else "(self)"
        facts = "".join(f"        {one.name}: {described(one, repr)}\n" for one in method.params)
        doc = f'        """{method.summary}' + (f"\n\n{facts}        " if facts else "") + '"""\n'
        given = "".join(f", {one.name}={one.name}" for one in method.params)
        call = f'{"await " if is_async else ""}self.call("{method.name}"{given})'
        return f"    {start} {method.identifier}{signature} -> {result}:\n{doc}        return {call}\n"

    def mixin(self, name: str, is_async: bool) -> str:
        start = "async def" if is_async else "def"
        functions = "\n".join(self.function(method, is_async) for method in self.contract.methods)
        return (
            f"class {name}:\n    {start} call(self, method: str, **params: Any) -> Any:\n"
            f'        """Calls a method. Parameters that are None are left out."""\n'
            f"        raise NotImplementedError\n\n{functions}"
        )


def emit(contract: Contract, is_async: bool) -> str:
    signatures = Signatures(contract)
    mixin = signatures.mixin("AsyncCalls" if is_async else "Calls", is_async)
    names = "".join(f"    {name},\n" for name in sorted(signatures.names))
    return (
        '"""Generated from protocol/openrpc.json; do not edit."""\n\n'
        f"from typing import Any, Literal\n\nfrom .types import (\n{names})\n\n\n{mixin}"
    )
