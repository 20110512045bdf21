"""Emits the contract as one TypeScript module: types, maps of methods and notifications, version, defaults, errors."""

import json

from .model import Contract, Field, Method, Schema, default_of, described, fields_of, limits, ref_name

STANDARD_ERRORS = {
    "ParseError": -32700,
    "InvalidRequest": -32600,
    "MethodNotFound": -32601,
    "InvalidParams": -32602,
    "InternalError": -32603,
}


def type_of(schema: Schema, indent: str = "") -> str:
    if name := ref_name(schema):
        return name
    if "const" in schema:
        return json.dumps(schema["const"])
    if "enum" in schema:
        return " | ".join(json.dumps(value) for value in schema["enum"])
    for key in ("anyOf", "oneOf"):
        if key in schema:
            return " | ".join(dict.fromkeys(type_of(option, indent) for option in schema[key]))
    kind = schema.get("type")
    if kind == "array":
        return array(schema, indent)
    if kind == "object":
        return object_(schema, indent)
    return {"string": "string", "number": "number", "integer": "number", "boolean": "boolean", "null": "null"}[kind]


def array(schema: Schema, indent: str) -> str:
    item = type_of(schema["items"], indent)
    length = schema.get("minItems")
    if length is not None and length == schema.get("maxItems"):
        return "[" + ", ".join([item] * length) + "]"
    return f"Array<{item}>"


def object_(schema: Schema, indent: str) -> str:
    if "properties" in schema:
        return "{\n" + members(fields_of(schema), indent + "  ") + indent + "}"
    values = schema.get("additionalProperties")
    return f"Record<string, {type_of(values, indent) if isinstance(values, dict) else 'unknown'}>"


def members(fields: list[Field], indent: str) -> str:
    lines = []
    for one in fields:
        if comment := described(one, json.dumps):
            lines.append(f"{indent}/** {comment} */\n")
        mark = "" if one.required else "?"
        lines.append(f"{indent}{one.name}{mark}: {type_of(one.schema, indent)};\n")
    return "".join(lines)


def parameters(method: Method, indent: str) -> str:
    return "{\n" + members(method.params, indent + "  ") + indent + "}" if method.params else "Record<string, never>"


def owners(contract: Contract) -> list[tuple[str, str, list[Field]]]:
    """Returns name, TypeScript type and members of all schemas and of the parameters of all methods."""
    schemas = [(name, name, fields_of(schema)) for name, schema in contract.schemas.items() if "properties" in schema]
    methods = [(json.dumps(m.name), f'Methods["{m.name}"]["params"]', m.params) for m in contract.methods]
    return schemas + methods


def defaults(contract: Contract) -> str:
    types, values = [], []
    for name, type_name, fields in owners(contract):
        given = {one.name: default_of(one.schema) for one in fields if default_of(one.schema) is not None}
        if not given:
            continue
        names = " | ".join(json.dumps(member) for member in given)
        types.append(f"  readonly {name}: Given<{type_name}, {names}>;\n")
        values.append(f"  {name}: {{ " + ", ".join(f"{key}: {json.dumps(one)}" for key, one in given.items()) + " },\n")
    return (
        "type Given<T, K extends keyof T> = Readonly<Required<Pick<T, K>>>;\n\n"
        "/** Values of absent members, by schema, and of absent parameters, by method. */\n"
        f"export const DEFAULTS: {{\n{''.join(types)}}} = {{\n{''.join(values)}}};\n\n"
    )


def limit_table(contract: Contract) -> str:
    rows = []
    for name, _, fields in owners(contract):
        given = {one.name: limits(one.schema) for one in fields}
        stated = ", ".join(f"{key}: {json.dumps(both)}" for key, both in given.items() if both)
        if stated:
            rows.append(f"  {name}: {{ {stated} }},\n")
    return (
        "/** [least, most] of a number, or of an array's number of items. A bound may be exclusive: see the member. */\n"
        f"export const LIMITS = {{\n{''.join(rows)}}} as const;\n\n"
    )


def version(contract: Contract) -> str:
    major, minor = contract.protocol
    return (
        "/** The version of the contract that this code is generated from. */\n"
        f"export const PROTOCOL = {{ major: {major}, minor: {minor} }} as const;\n\n"
    )


def emit(contract: Contract) -> str:
    out = ["// Generated from protocol/openrpc.json; do not edit.\n\n"]
    for name, schema in contract.schemas.items():
        if description := schema.get("description"):
            out.append(f"/** {description} */\n")
        if "properties" in schema:
            out.append(f"export interface {name} {type_of(schema)}\n\n")
        else:
            out.append(f"export type {name} = {type_of(schema)};\n\n")
    out.append("export interface Methods {\n")
    for method in contract.methods:
        out.append(f"  /** {method.summary} */\n  {json.dumps(method.name)}: {{\n")
        out.append(f"    params: {parameters(method, '    ')};\n")
        out.append(f"    result: {type_of(method.result or {}, '    ')};\n  }};\n")
    out.append("}\n\nexport interface Notifications {\n")
    for note in contract.notifications:
        out.append(f"  /** {note.summary} */\n  {json.dumps(note.name)}: {parameters(note, '  ')};\n")
    out += ["}\n\n", version(contract), defaults(contract), limit_table(contract), "export const ErrorCode = {\n"]
    for name, code in {**STANDARD_ERRORS, **{n: c for n, (c, _) in contract.errors.items()}}.items():
        out.append(f"  {name}: {code},\n")
    out.append("} as const;\n")
    return "".join(out)
