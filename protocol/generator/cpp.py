"""Emits the contract as C++ headers: types.hpp (structures), json.hpp (their conversions), methods.hpp (a function
declaration per method), method_table.hpp (all these functions: a missing definition fails to link), document.hpp."""

import json

from .model import Contract, Field, Method, Schema, fields_of, nullable, pascal, ref_name

HEAD = "// Generated from protocol/openrpc.json; do not edit.\n#pragma once\n\n"
PLAIN = {"string": "std::string", "integer": "std::int64_t", "number": "double", "boolean": "bool", "null": "std::nullptr_t"}


class Types:
    """Collects C++ structures, each after the structures that it uses."""

    def __init__(self, contract: Contract) -> None:
        self.contract = contract
        self.declarations: list[str] = []
        self.structures: list[tuple[str, list[Field]]] = []
        self.done: set[str] = set()

    def named(self, name: str) -> str:
        schema = self.contract.schemas[name]
        if schema.get("x-document"):  # kept as JSON; cpp_scene.py emits its structures
            return "nlohmann::json"
        if name not in self.done:
            self.done.add(name)
            if "properties" in schema:
                self.structure(name, fields_of(schema), schema.get("description", ""))
            else:
                self.alias(name, self.type_of(schema, name))
        return name

    def alias(self, name: str, type_name: str) -> None:
        self.declarations.append(f"using {name} = {type_name};\n")

    def type_of(self, schema: Schema, hint: str) -> str:
        if name := ref_name(schema):
            return self.named(name)
        if inner := nullable(schema):
            return f"std::optional<{self.type_of(inner, hint)}>"
        if "enum" in schema:
            return "std::string"
        kind = schema.get("type")
        if kind == "array":
            item = self.type_of(schema["items"], hint + "Item")
            length = schema.get("minItems")
            fixed = length is not None and length == schema.get("maxItems")
            return f"std::array<{item}, {length}>" if fixed else f"std::vector<{item}>"
        if kind == "object" and "properties" in schema:
            self.structure(hint, fields_of(schema), schema.get("description", ""))
            return hint
        if kind == "object" and isinstance(schema.get("additionalProperties"), dict):
            return f"std::map<std::string, {self.type_of(schema['additionalProperties'], hint + 'Value')}>"
        return PLAIN.get(kind or "", "nlohmann::json")

    def member(self, one: Field, hint: str) -> str:
        type_name = self.type_of(one.schema, hint)
        comment = f" // {one.description}" if one.description else ""
        if not one.required and "default" in one.schema:
            value = json.dumps(one.schema["default"]).replace("[", "{").replace("]", "}")
            return f"    {type_name} {one.name} = {value};{comment}\n"
        if not one.required and not type_name.startswith("std::optional"):
            type_name = f"std::optional<{type_name}>"
        return f"    {type_name} {one.name}{{}};{comment}\n"

    def structure(self, name: str, fields: list[Field], description: str, extra: str = "") -> None:
        body = "".join(self.member(one, name + pascal(one.name)) for one in fields)
        comment = f"// {description}\n" if description else ""
        self.declarations.append(f"{comment}struct {name} {{\n{extra}{body}}};\n")
        self.structures.append((name, fields))

    def result(self, method: Method) -> None:
        name = method.type_prefix + "Result"
        schema = method.result or {}
        if "properties" in schema:
            self.structure(name, fields_of(schema), "")
        else:
            self.alias(name, self.type_of(schema, name))


def collect(contract: Contract) -> Types:
    types = Types(contract)
    for method in contract.methods:
        types.structure(method.type_prefix + "Params", method.params, f"{method.name}: {method.summary}")
        types.result(method)
    for note in contract.notifications:
        name = f'    static constexpr const char* method = "{note.name}";\n'
        types.structure(note.type_prefix, note.params, note.summary, name)
    return types


def emit_types(contract: Contract) -> str:
    errors = "".join(f"    {name} = {code}, // {message}\n" for name, (code, message) in contract.errors.items())
    return (
        HEAD + "#include <array>\n#include <cstddef>\n#include <cstdint>\n#include <map>\n#include <nlohmann/json.hpp>\n"
        "#include <optional>\n#include <string>\n#include <vector>\n\nnamespace server::protocol {\n\n"
        f"enum ErrorCode : int {{\n{errors}}};\n\n"
        + "\n".join(collect(contract).declarations)
        + "\n} // namespace server::protocol\n"
    )


def reads(one: Field) -> str:
    if one.required:
        return f'    j.at("{one.name}").get_to(v.{one.name});\n'
    return f'    if (const auto i = j.find("{one.name}"); i != j.end()) i->get_to(v.{one.name});\n'


def writes(one: Field) -> str:
    if one.required or "default" in one.schema:
        return f'    j["{one.name}"] = v.{one.name};\n'
    return f'    if (v.{one.name}) j["{one.name}"] = *v.{one.name};\n'


def emit_json(contract: Contract) -> str:
    out = [
        HEAD,
        '#include "protocol/types.hpp"\n\n',
        "namespace nlohmann {\ntemplate <class T>\nstruct adl_serializer<std::optional<T>> {\n"
        "    static void to_json(json& j, const std::optional<T>& v) { v ? j = *v : j = nullptr; }\n"
        "    static void from_json(const json& j, std::optional<T>& v) {\n"
        "        if (j.is_null()) v.reset();\n        else v = j.get<T>();\n    }\n};\n} // namespace nlohmann\n\n",
        "namespace server::protocol {\n\n",
    ]
    for name, fields in collect(contract).structures:
        unnamed = "" if fields else "/*v*/"
        source = "j" if fields else "/*j*/"
        out.append(f"inline void from_json(const nlohmann::json& {source}, {name}& {unnamed or 'v'}) {{\n")
        out.extend(reads(one) for one in fields)
        out.append(f"}}\ninline void to_json(nlohmann::json& j, const {name}& {unnamed or 'v'}) {{\n")
        out.append("    j = nlohmann::json::object();\n")
        out.extend(writes(one) for one in fields)
        out.append("}\n")
    out.append("\n} // namespace server::protocol\n")
    return "".join(out)


def emit_methods(contract: Contract) -> str:
    functions = "".join(
        f"// {m.summary}\n[[nodiscard]] protocol::{m.type_prefix}Result {m.identifier}(CallContext& context, "
        f"const protocol::{m.type_prefix}Params& params);\n"
        for m in contract.methods
    )
    return HEAD + (
        '#include "protocol/types.hpp"\n\nnamespace server::methods {\n\n'
        "struct CallContext; // methods/call_context.hpp\n\n" + functions + "\n} // namespace server::methods\n"
    )


def emit_table(contract: Contract) -> str:
    rows = "".join(
        f'    {{"{m.name}", {str(m.slow).lower()}, call<protocol::{m.type_prefix}Params, {m.identifier}>}},\n'
        for m in contract.methods
    )
    return HEAD + (
        '#include "protocol/json.hpp"\n#include "protocol/methods.hpp"\n\n#include <string_view>\n\n'
        "namespace server::methods {\n\n"
        "struct Method {\n    std::string_view name;\n    bool slow; // x-slow: draws, extracts or exports\n"
        "    nlohmann::json (*call)(CallContext& context, const nlohmann::json& params);\n};\n\n"
        "template <class Params, auto function>\n"
        "nlohmann::json call(CallContext& context, const nlohmann::json& params) {\n"
        "    return nlohmann::json(function(context, params.get<Params>()));\n}\n\n"
        f"inline constexpr std::array<Method, {len(contract.methods)}> method_table{{{{\n{rows}}}}};\n\n"
        "} // namespace server::methods\n"
    )


# A compiler need not take a string literal of more than 65,536 characters ([implimits] of the C++ standard).
LONGEST_LITERAL = 60_000


def document_parts(text: str) -> list[str]:
    """Splits the document into parts that fit into string literals."""
    return [text[begin : begin + LONGEST_LITERAL] for begin in range(0, len(text), LONGEST_LITERAL)]


def emit_document(contract: Contract) -> str:
    major, minor = contract.protocol
    view_open = next(method for method in contract.methods if method.name == "view.open")
    streams = next(param for param in view_open.params if param.name == "stream").schema["enum"]
    parts = document_parts(contract.text)
    literals = ", ".join(f'R"openrpc({part})openrpc"' for part in parts)
    words = ", ".join(f'"{stream}"' for stream in streams)
    return HEAD + (
        "#include <array>\n#include <string_view>\n\nnamespace server::protocol {\n\n"
        f"inline constexpr int major_version = {major}, minor_version = {minor};\n"
        f"inline constexpr std::array<std::string_view, {len(streams)}> streams{{{words}}}; // of a view\n"
        "// The text of openrpc.json, in parts.\n"
        f"inline constexpr std::array<std::string_view, {len(parts)}> document_parts{{{literals}}};\n\n"
        "} // namespace server::protocol\n"
    )


FILES = {
    "types.hpp": emit_types,
    "json.hpp": emit_json,
    "methods.hpp": emit_methods,
    "method_table.hpp": emit_table,
    "document.hpp": emit_document,
}
