"""Model of the contract for the emitters: schemas by name, methods with named parameter and result types, errors."""

import json
import pathlib
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

Schema = dict[str, Any]


@dataclass
class Field:
    name: str
    schema: Schema
    required: bool
    description: str = ""


@dataclass
class Method:
    name: str  # "scene.patch"
    summary: str
    params: list[Field]
    result: Schema | None  # None for notifications
    result_name: str = ""
    slow: bool = False  # x-slow in the contract: draws, extracts or exports

    @property
    def type_prefix(self) -> str:
        return pascal(self.name)

    @property
    def identifier(self) -> str:
        return self.name.replace(".", "_")


@dataclass
class Contract:
    text: str  # openrpc.json without white space
    version: str
    schemas: dict[str, Schema]
    methods: list[Method]
    notifications: list[Method]
    errors: dict[str, tuple[int, str]] = field(default_factory=dict)

    @property
    def protocol(self) -> tuple[int, int]:
        """Returns the major and minor version of the contract."""
        major, minor, _ = map(int, self.version.split("."))
        return major, minor


def pascal(name: str) -> str:
    return "".join(part[:1].upper() + part[1:] for part in re.split(r"[._]", name))


def ref_name(schema: Schema) -> str | None:
    reference = schema.get("$ref")
    return reference.rsplit("/", 1)[1] if reference else None


def fields_of(schema: Schema) -> list[Field]:
    required = set(schema.get("required", []))
    return [
        Field(name, part, name in required, part.get("description", "")) for name, part in schema["properties"].items()
    ]


def nullable(schema: Schema) -> Schema | None:
    """Returns X for a schema anyOf [X, null], else None."""
    options = schema.get("anyOf", [])
    rest = [option for option in options if option.get("type") != "null"]
    return rest[0] if len(options) == 2 and len(rest) == 1 else None


def limits(schema: Schema) -> tuple[float, float] | None:
    """Returns the least and the most value of a number, or number of items of an array. None: unlimited on a side.

    An exclusive limit counts as the limit. An array of fixed length has no limits."""
    schema = nullable(schema) or schema
    if schema.get("type") == "array":
        least, most = schema.get("minItems", 0), schema.get("maxItems")
        return None if most is None or least == most else (least, most)
    least = schema.get("minimum", schema.get("exclusiveMinimum"))
    most = schema.get("maximum", schema.get("exclusiveMaximum"))
    return None if least is None or most is None else (least, most)


def default_of(schema: Schema) -> Any:
    """Returns the default of a member, or None. An empty object is no default of its own: its members have defaults."""
    default = schema.get("default")
    return None if default == {} else default


def range_words(schema: Schema) -> str:
    """Returns the range of a number, or the number of items of an array, in words. Empty without limits."""
    schema = nullable(schema) or schema
    if schema.get("type") == "array":
        both = limits(schema)
        if both is None:
            return ""
        return f"{both[0]} to {both[1]} items" if both[0] else f"at most {both[1]} items"
    if "minimum" in schema and "maximum" in schema:
        return f"{schema['minimum']} to {schema['maximum']}"
    words = {"minimum": "at least", "exclusiveMinimum": "above", "maximum": "at most", "exclusiveMaximum": "below"}
    return " and ".join(f"{words[key]} {schema[key]}" for key in words if key in schema)


def described(one: Field, literal: Callable[[Any], str]) -> str:
    """Returns the description of a member, its range and its default. `literal` writes a value in the emitted language."""
    facts = [range_words(one.schema)]
    if (default := default_of(one.schema)) is not None:
        facts.append(f"default {literal(default)}")
    stated = ", ".join(fact for fact in facts if fact)
    if not stated or not one.description:
        return stated or one.description
    return f"{one.description} ({stated})"


def load(path: pathlib.Path) -> Contract:
    document = json.loads(path.read_text(encoding="utf-8"))

    def method(entry: dict[str, Any]) -> Method:
        params = [
            Field(p["name"], p["schema"], p.get("required", False), p.get("description", "")) for p in entry["params"]
        ]
        result = entry.get("result", {}).get("schema")
        return Method(entry["name"], entry.get("summary", ""), params, result, slow=entry.get("x-slow", False))

    return Contract(
        text=json.dumps(document, separators=(",", ":"), ensure_ascii=True),
        version=document["info"]["version"],
        schemas=document["components"]["schemas"],
        methods=[method(entry) for entry in document["methods"]],
        notifications=[method(entry) for entry in document["x-notifications"]],
        errors={name: (e["code"], e["message"]) for name, e in document["components"]["errors"].items()},
    )
