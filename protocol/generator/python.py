"""Emits the contract as Python TypedDicts."""

from .model import Contract, Field, Method, Schema, described, fields_of, nullable, pascal, ref_name

PLAIN = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "null": "None"}


class Types:
    """Collects type definitions, each after the definitions that it uses."""

    def __init__(self) -> None:
        self.definitions: list[str] = []

    def type_of(self, schema: Schema, hint: str) -> str:
        if name := ref_name(schema):
            return name
        if "const" in schema or "enum" in schema:
            values = schema.get("enum", [schema.get("const")])
            return "Literal[" + ", ".join(f'"{value}"' for value in values) + "]"
        if inner := nullable(schema):
            return f"{self.type_of(inner, hint)} | None"
        for key in ("anyOf", "oneOf"):
            if key in schema:
                return " | ".join(self.type_of(option, hint) for option in schema[key])
        kind = schema.get("type")
        if kind == "array":
            return f"list[{self.type_of(schema['items'], hint + 'Item')}]"
        if kind == "object" and "properties" in schema:
            return self.typed_dict(hint, fields_of(schema), schema.get("description", ""))
        if kind == "object":
            values = schema.get("additionalProperties")
            return f"dict[str, {self.type_of(values, hint + 'Value') if isinstance(values, dict) else 'Any'}]"
        return PLAIN[kind or ""]

    def typed_dict(self, name: str, fields: list[Field], description: str) -> str:
        lines = []
        for one in fields:
            type_name = self.type_of(one.schema, name + pascal(one.name))
            mark = type_name if one.required else f"NotRequired[{type_name}]"
            comment = described(one, repr)
            lines.append(f"    {one.name}: {mark}" + (f"  # {comment}" if comment else "") + "\n")
        doc = f'    """{description}"""\n\n' if description else ""
        self.definitions.append(f"class {name}(TypedDict):\n" + doc + ("".join(lines) or "    pass\n"))
        return name


def method_types(types: Types, method: Method) -> None:
    types.typed_dict(method.type_prefix + "Params", method.params, f"{method.name}: {method.summary}")
    if method.result is not None:
        name = method.type_prefix + "Result"
        result = types.type_of(method.result, name)
        if result != name:
            types.definitions.append(f"{name} = {result}\n")


HEAD = '"""Generated from protocol/openrpc.json; do not edit."""\n\nfrom typing import Any, Literal, NotRequired, TypedDict\n\n'


def schemas_of(contract: Contract) -> Types:
    types = Types()
    for name, schema in contract.schemas.items():
        if "properties" in schema:
            types.typed_dict(name, fields_of(schema), schema.get("description", ""))
        else:
            types.definitions.append(f"{name} = {types.type_of(schema, name)}\n")
    return types


def emit_schemas(contract: Contract) -> str:
    """The types that several methods share: the scene and what it consists of, descriptions, states."""
    return HEAD + "\n\n".join(schemas_of(contract).definitions)


def emit(contract: Contract) -> str:
    """Parameters and results of each method. The shared types can be imported from here, too."""
    types = Types()
    for method in contract.methods + contract.notifications:
        method_types(types, method)
    shared = "".join(f"    {name} as {name},\n" for name in sorted(contract.schemas))
    codes = "".join(f'    "{name}": {code},\n' for name, (code, _) in contract.errors.items())
    return (
        HEAD
        + f"from .schemas import (\n{shared})\n\n\n"
        + "\n\n".join(types.definitions)
        + "\n\nPROTOCOL = {{\"major\": {}, \"minor\": {}}}  # the version of the contract\n".format(*contract.protocol)
        + f"ERROR_CODES: dict[str, int] = {{\n{codes}}}\n"
    )


def emit_version(version: str) -> str:
    return f'"""Generated from server/ciel/version.txt; do not edit."""\n\n__version__ = "{version.strip()}"\n'
