"""Emits the contract's scene as C++: scene.hpp (structures with their defaults), read_scene.hpp (JSON -> structures).

Each schema becomes one structure, by these rules:
- enum: `enum class` named as the member, inside its structure; anyOf: std::variant; anyOf with null: std::optional.
- A member that is neither required nor has a default is std::optional. Exception: a string with minLength above 0 is a
  plain std::string, which is empty if the member is absent.
- A member with a default and x-optional is std::optional too, because a rule asks whether it was given. Its default is a
  constant beside it: default_ and its name.
- A number is a double, or a float where its format says so. An integer that is not negative is a std::size_t.
- oneOf becomes a std::variant; the constant `type` selects the form. x-shared names members that all forms have; they
  are members of the structure around the variant.
- An object whose values have an x-key becomes a std::vector. Each value keeps its name in the member that x-key names.
"""

import json
from typing import Any

from .model import Contract, Schema, nullable, pascal, ref_name

HEAD = "// Generated from protocol/openrpc.json; do not edit.\n#pragma once\n\n"
COLOR = "^#[0-9a-fA-F]{6}$"
KEYWORDS = {"auto": "automatic"}


class Structures:
    """Collects the structures that `Scene` needs, each after the structures that it uses."""

    def __init__(self, contract: Contract) -> None:
        self.schemas = contract.schemas
        self.declared: list[str] = []
        self.readers: list[str] = []
        self.done: set[str] = set()
        self.layer_types: list[str] = []

    def resolve(self, schema: Schema) -> Schema:
        name = ref_name(schema)
        return self.schemas[name] if name else schema

    def named(self, name: str) -> str:
        if name not in self.done:
            self.done.add(name)
            schema = self.schemas[name]
            if "oneOf" in schema:
                self.choice(name, schema)
            elif "properties" in schema:
                self.structure(name, schema)
            elif schema.get("pattern") == COLOR:
                self.declared.append(f"using {name} = std::array<std::uint8_t, 3>; // {schema['description']}\n")
            else:
                self.declared.append(f"using {name} = {self.type_of(schema, '')}; // {schema['description']}\n")
        return name

    def type_of(self, schema: Schema, enum: str) -> str:
        """Returns the C++ type of a schema. `enum`: the type's name if the schema is an enumeration."""
        if name := ref_name(schema):
            return self.named(name)
        if inner := nullable(schema):
            return f"std::optional<{self.type_of(inner, enum)}>"
        if "anyOf" in schema:
            return "std::variant<" + ", ".join(self.type_of(option, enum) for option in schema["anyOf"]) + ">"
        if "enum" in schema:
            return enum
        kind = schema["type"]
        if kind == "array":
            item, length = self.type_of(schema["items"], enum), schema.get("minItems")
            fixed = length is not None and length == schema.get("maxItems")
            return f"std::array<{item}, {length}>" if fixed else f"std::vector<{item}>"
        if kind == "object":
            return f"std::vector<{self.type_of(schema['additionalProperties'], enum)}>"
        if kind == "integer":
            return "std::size_t" if schema.get("minimum", -1) >= 0 else "std::int64_t"
        if kind == "number":
            return "float" if schema.get("format") == "float" else "double"
        return {"string": "std::string", "boolean": "bool"}[kind]

    def literal(self, schema: Schema, value: Any, enum: str) -> str:
        if isinstance(value, dict):
            return "{}"
        schema = self.resolve(schema)
        if "anyOf" in schema:
            fitting = [option for option in schema["anyOf"] if value in option.get("enum", [value])]
            return self.literal(fitting[0], value, enum)
        if "enum" in schema:
            return f"{enum}::{enumerator(value)}"
        if schema.get("pattern") == COLOR:
            return "{" + ", ".join(f"0x{value[at : at + 2]}" for at in (1, 3, 5)) + "}"
        if isinstance(value, list):
            return "{" + ", ".join(self.literal(schema["items"], one, enum) for one in value) + "}"
        text = json.dumps(value)
        return text + "F" if schema.get("format") == "float" and "." in text else text

    def structure(self, name: str, schema: Schema, without: tuple[str, ...] = ()) -> None:
        required = set(schema.get("required", []))
        members, enums, reads = [], [], []
        for member, part in schema["properties"].items():
            if "const" in part:
                members.append(f'    static constexpr const char* {member} = "{part["const"]}";\n')
                continue
            if member in without:
                continue
            members.append(self.member(member, part, member in required, f"{pascal(member)}"))
            reads.append(self.read_of(member, part))
            enums.extend(self.enums_of(name, pascal(member), part))
        comment = f"// {schema['description']}\n" if "description" in schema else ""
        nested = "".join(f"    enum class {enum} {{ {', '.join(map(enumerator, values))} }};\n" for enum, values in enums)
        self.declared.append(f"{comment}struct {name} {{\n{nested}{''.join(members)}{equality(name)}}};\n")
        self.readers.extend(enum_reader(f"{name}::{enum}", values) for enum, values in enums)
        self.readers.extend(self.mixed_readers(name, schema))
        self.readers.append(reader(name, "".join(reads)))

    def member(self, name: str, part: Schema, required: bool, enum: str) -> str:
        type_name = self.type_of(part, enum)
        comment = f" // {part['description']}" if "description" in part else ""
        if part.get("x-optional"):
            value = self.literal(part, part["default"], enum)
            constant = f"    static constexpr {type_name} default_{name} = {value};\n"
            return f"{constant}    std::optional<{type_name}> {name}{{}};{comment}\n"
        if "default" in part:
            value = self.literal(part, part["default"], enum)
            return f"    {type_name} {name}{value if value == '{}' else ' = ' + value};{comment}\n"
        is_absent_when_empty = part.get("type") == "string" and part.get("minLength", 0) > 0
        if not required and not is_absent_when_empty and not type_name.startswith("std::optional"):
            type_name = f"std::optional<{type_name}>"
        return f"    {type_name} {name}{{}};{comment}\n"

    def enums_of(self, structure: str, name: str, part: Schema) -> list[tuple[str, list[str]]]:
        options = part.get("anyOf", [part])
        return [(name, option["enum"]) for option in options if "enum" in option]

    def mixed_readers(self, structure: str, schema: Schema) -> list[str]:
        """Returns readers for members that are one of a few words, or a color."""
        out = []
        for member, part in schema["properties"].items():
            if "anyOf" not in part or nullable(part):
                continue
            enum = f"{structure}::{pascal(member)}"
            words = next(option["enum"] for option in part["anyOf"] if "enum" in option)
            is_word = " || ".join(f'j == "{word}"' for word in words)
            out.append(
                reader(f"std::variant<{enum}, Color>", f"    if ({is_word}) read(j, v.emplace<{enum}>());\n    else read(j, v.emplace<Color>());\n")
            )
        return out

    def read_of(self, member: str, part: Schema) -> str:
        layer = self.resolve(part.get("additionalProperties") or {}) if part.get("type") == "object" else {}
        if key := layer.get("x-key"):
            kind = ref_name(part["additionalProperties"])
            return f'    read_by_key(j, "{member}", v.{member}, &{kind}::{key});\n'
        return f'    read_member(j, "{member}", v.{member});\n'

    def choice(self, name: str, schema: Schema) -> None:
        shared = schema.get("x-shared", [])
        forms = [ref_name(option) or "" for option in schema["oneOf"]]
        members = [f"    std::string {schema['x-key']};\n"] if "x-key" in schema else []
        reads = []
        for member in shared:
            parts = [self.schemas[form]["properties"].get(member) for form in forms]
            forms_of_member = [{k: v for k, v in part.items() if k != "description"} for part in parts if part]
            part = forms_of_member[0]
            if any(other != part for other in forms_of_member):
                raise ValueError(f"{name}: the forms disagree about the shared member {member}")
            members.append(self.member(member, part, False, ""))
            reads.append(self.read_of(member, part))
        for form in forms:
            self.done.add(form)
            self.structure(form, self.schemas[form], tuple(shared))
        members.append(f"    std::variant<{', '.join(forms)}> kind;\n")
        self.declared.append(f"struct {name} {{\n{''.join(members)}{equality(name)}}};\n")
        reads.append('    const auto& type = j.at("type").get_ref<const std::string&>();\n')
        for form in forms:
            reads.append(f"    if (type == {form}::type) read(j, v.kind.emplace<{form}>());\n")
        self.readers.append(reader(name, "".join(reads)))
        self.layer_types = [self.schemas[form]["properties"]["type"]["const"] for form in forms]


def equality(name: str) -> str:
    return f"    bool operator==(const {name}&) const = default;\n"


def enumerator(word: str) -> str:
    return KEYWORDS.get(word, word)


def reader(type_name: str, body: str) -> str:
    return f"inline void read(const nlohmann::json& j, {type_name}& v) {{\n{body}}}\n"


def enum_reader(type_name: str, words: list[str]) -> str:
    lines = "".join(f'    if (j == "{word}") v = {type_name}::{enumerator(word)};\n' for word in words)
    return reader(type_name, lines)


def collect(contract: Contract) -> Structures:
    structures = Structures(contract)
    structures.named("Scene")
    return structures


def emit_types(contract: Contract) -> str:
    structures = collect(contract)
    types = ", ".join(f'"{name}"' for name in structures.layer_types)
    return (
        HEAD + "#include <array>\n#include <cstddef>\n#include <cstdint>\n#include <optional>\n#include <string>\n"
        "#include <variant>\n#include <vector>\n\nnamespace server::scene {\n\n"
        + "\n".join(structures.declared)
        + f"\ninline constexpr std::array layer_types{{{types}}};\n"
        + "\n} // namespace server::scene\n"
    )


SUPPORT = """// Each reads a value that satisfies its schema. Absent and null members keep their default.
inline void read(const nlohmann::json& j, bool& v) { j.get_to(v); }
inline void read(const nlohmann::json& j, double& v) { j.get_to(v); }
inline void read(const nlohmann::json& j, float& v) { j.get_to(v); }
inline void read(const nlohmann::json& j, std::size_t& v) { j.get_to(v); }
inline void read(const nlohmann::json& j, std::int64_t& v) { j.get_to(v); }
inline void read(const nlohmann::json& j, std::string& v) { j.get_to(v); }
inline void read(const nlohmann::json& j, Color& v) {
    const auto& text = j.get_ref<const std::string&>(); // #rrggbb
    for (std::size_t i = 0; i < v.size(); ++i)
        v[i] = static_cast<std::uint8_t>(std::stoi(text.substr(1 + 2 * i, 2), nullptr, 16));
}
template <class T>
void read(const nlohmann::json& j, std::vector<T>& v);
template <class T, std::size_t n>
void read(const nlohmann::json& j, std::array<T, n>& v) {
    for (std::size_t i = 0; i < n; ++i) read(j.at(i), v[i]);
}
template <class T>
void read(const nlohmann::json& j, std::optional<T>& v) {
    read(j, v.emplace());
}
template <class T>
void read(const nlohmann::json& j, std::vector<T>& v) {
    v.resize(j.size());
    for (std::size_t i = 0; i < v.size(); ++i) read(j.at(i), v[i]);
}
template <class T>
void read_member(const nlohmann::json& j, const char* name, T& v) {
    if (const auto member = j.find(name); member != j.end() && !member->is_null()) read(*member, v);
}
template <class T>
void read_by_key(const nlohmann::json& j, const char* name, std::vector<T>& v, std::string T::*key) {
    const auto members = j.find(name);
    if (members == j.end()) return;
    for (const auto& [id, member] : members->items()) {
        v.emplace_back().*key = id;
        read(member, v.back());
    }
}

"""


def emit_readers(contract: Contract) -> str:
    return (
        HEAD + '#include "protocol/scene.hpp"\n\n#include <nlohmann/json.hpp>\n\nnamespace server::scene {\n\n'
        + SUPPORT
        + "\n".join(collect(contract).readers)
        + "\n} // namespace server::scene\n"
    )


FILES = {"scene.hpp": emit_types, "read_scene.hpp": emit_readers}
