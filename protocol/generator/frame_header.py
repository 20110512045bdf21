"""Emits the frame header of frame_header.json: structure, writer and reader in C++, TypeScript and Python; table.

The table goes to frame.md. All three readers refuse the same messages with the same sentences.
"""

import json
import pathlib
from dataclasses import dataclass
from typing import Any

SOURCE = "Generated from protocol/frame_header.json; do not edit."
RELOAD = "Reload the page, or update the client"
BYTES = {"u8": 1, "u16": 2, "u32": 4, "u64": 8, "f32": 4, "f64": 8}
CPP = {"u32": "std::uint32_t", "u64": "std::uint64_t", "f32": "float", "f64": "double"}
DATA_VIEW = {"u32": "Uint32", "u64": "BigUint64", "f32": "Float32", "f64": "Float64"}
STRUCT = {"u32": "I", "u64": "Q", "f32": "f", "f64": "d"}


@dataclass
class Header:
    magic: str
    version: int
    bytes: int
    kinds: dict[str, int]
    flags: dict[str, tuple[int, str]]  # mask, description
    fields: list[dict[str, Any]]  # in the order of their offsets, without gaps, the first at offset 8

    @property
    def known_flags(self) -> int:
        return sum(mask for mask, _ in self.flags.values())

    @property
    def kind_list(self) -> str:
        return " and ".join(f"{number} ({name})" for name, number in self.kinds.items())


def load(path: pathlib.Path) -> Header:
    table = json.loads(path.read_text(encoding="utf-8"))
    end = 8  # after magic, version, kind and flags
    for one in table["fields"]:
        if one["offset"] != end:
            raise ValueError(f"{path.name}: {one['name']} has offset {one['offset']}; the field before it ends at {end}")
        end += BYTES[one["type"]]
    flags = {name: (1 << flag["bit"], flag["description"]) for name, flag in table["flags"].items()}
    return Header(table["magic"], table["version"], table["bytes"], table["kinds"], flags, table["fields"])


def emit_cpp(header: Header) -> str:
    kinds = ", ".join(f"{name} = {number}" for name, number in header.kinds.items())
    flags = "".join(f"    {name} = {mask}, // {text}\n" for name, (mask, text) in header.flags.items())
    members = "".join(f"    {CPP[one['type']]} {one['name']} = 0; // {one['description']}\n" for one in header.fields)
    puts = "".join(f"    put(out.data() + {one['offset']}, header.{one['name']});\n" for one in header.fields)
    gets = "".join(
        f"    header.{one['name']} = get<{CPP[one['type']]}>(at + {one['offset']});\n" for one in header.fields
    )
    is_kind = " && ".join(f"at[5] != {number}" for number in header.kinds.values())
    magic = ", ".join(f"'{letter}'" for letter in header.magic)
    return f"""// {SOURCE}
#pragma once

#include "ciel/types.hpp"
#include "wire/bytes.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace server::wire {{

enum class FrameKind : std::uint8_t {{ {kinds} }};
enum FrameFlags : std::uint16_t {{
{flags}}};

struct FrameHeader {{
    FrameKind kind = FrameKind::{next(iter(header.kinds))};
    std::uint16_t flags = 0;
{members}}};

inline constexpr std::size_t frame_header_bytes = {header.bytes};
inline constexpr std::array<std::uint8_t, 4> frame_magic{{{magic}}};
inline constexpr std::uint8_t frame_version = {header.version};

inline void write_frame_header(const FrameHeader& header, std::span<std::uint8_t, frame_header_bytes> out) {{
    std::fill(out.begin(), out.end(), std::uint8_t{{0}});
    std::copy(frame_magic.begin(), frame_magic.end(), out.begin());
    put(out.data() + 4, frame_version);
    put(out.data() + 5, static_cast<std::uint8_t>(header.kind));
    put(out.data() + 6, header.flags);
{puts}}}

// Throws Error on a bad magic, version, kind, flag or size.
[[nodiscard]] inline FrameHeader read_frame_header(std::span<const std::uint8_t> bytes) {{
    const auto text = [](std::uint64_t number) {{ return std::to_string(number); }};
    if (bytes.size() < frame_header_bytes)
        throw ciel::Error("a binary frame has " + text(bytes.size()) + " bytes; its header alone has {header.bytes}");
    const std::uint8_t* at = bytes.data();
    if (!std::equal(frame_magic.begin(), frame_magic.end(), at))
        throw ciel::Error("a binary frame does not begin with '{header.magic}'");
    if (at[4] != frame_version)
        throw ciel::Error("a binary frame is of version " + text(at[4]) +
                    "; this program reads version {header.version}. {RELOAD}");
    if ({is_kind})
        throw ciel::Error("a binary frame is of kind " + text(at[5]) + "; the known kinds are {header.kind_list}");
    FrameHeader header;
    header.kind = static_cast<FrameKind>(at[5]);
    header.flags = get<std::uint16_t>(at + 6);
    if ((header.flags & ~{header.known_flags}) != 0)
        throw ciel::Error("a binary frame has unknown flags " + text(header.flags));
{gets}    const std::uint64_t payload = bytes.size() - frame_header_bytes;
    if (payload != header.payload_bytes)
        throw ciel::Error("a binary frame announces " + text(header.payload_bytes) + " bytes after its header and has " +
                    text(payload));
    if (std::uint64_t{{header.piece_offset}} + header.payload_bytes > header.whole_bytes)
        throw ciel::Error("a binary frame has " + text(header.payload_bytes) + " bytes at offset " + text(header.piece_offset) +
                    ", but the whole frame has only " + text(header.whole_bytes));
    return header;
}}

}} // namespace server::wire
"""


def camel(name: str) -> str:
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def emit_typescript(header: Header) -> str:
    kinds = ", ".join(f"{name}: {number}" for name, number in header.kinds.items())
    flags = ", ".join(f"{camel(name)}: {mask}" for name, (mask, _) in header.flags.items())
    flag_members = "".join(f"  /** {text} */\n  {camel(name)}: boolean;\n" for name, (_, text) in header.flags.items())
    members = "".join(f"  /** {one['description']} */\n  {camel(one['name'])}: number;\n" for one in header.fields)
    flag_reads = "".join(
        f"    {camel(name)}: (flags & {mask}) !== 0,\n" for name, (mask, _) in header.flags.items()
    )

    def read(one: dict[str, Any]) -> str:
        number = f"view.get{DATA_VIEW[one['type']]}({one['offset']}, true)"
        return f"    {camel(one['name'])}: {f'Number({number})' if one['type'] == 'u64' else number},\n"

    def write(one: dict[str, Any]) -> str:
        value = f"header.{camel(one['name'])}"
        value = f"BigInt({value})" if one["type"] == "u64" else value
        return f"  view.set{DATA_VIEW[one['type']]}({one['offset']}, {value}, true);\n"

    magic = ", ".join(hex(ord(letter)) for letter in header.magic)
    is_kind = " && ".join(f"kind !== {number}" for number in header.kinds.values())
    return f"""// {SOURCE}

export const FRAME_HEADER_BYTES = {header.bytes};
export const FrameKind = {{ {kinds} }} as const;
export const FrameFlags = {{ {flags} }} as const;

export interface FrameHeader {{
  kind: number;
  flags: number;
{flag_members}{members}}}

const MAGIC = [{magic}];

/** Throws Error on a bad magic, version, kind, flag or size. */
export function readFrameHeader(message: ArrayBuffer): FrameHeader {{
  if (message.byteLength < FRAME_HEADER_BYTES)
    throw new Error(`a binary frame has ${{message.byteLength}} bytes; its header alone has {header.bytes}`);
  const view = new DataView(message);
  if (MAGIC.some((letter, at) => view.getUint8(at) !== letter))
    throw new Error("a binary frame does not begin with '{header.magic}'");
  const version = view.getUint8(4);
  if (version !== {header.version})
    throw new Error(`a binary frame is of version ${{version}}; this program reads version {header.version}. {RELOAD}`);
  const kind = view.getUint8(5);
  if ({is_kind}) throw new Error(`a binary frame is of kind ${{kind}}; the known kinds are {header.kind_list}`);
  const flags = view.getUint16(6, true);
  if ((flags & ~{header.known_flags}) !== 0) throw new Error(`a binary frame has unknown flags ${{flags}}`);
  const header = {{
    kind,
    flags,
{flag_reads}{"".join(map(read, header.fields))}  }};
  const payload = message.byteLength - FRAME_HEADER_BYTES;
  if (payload !== header.payloadBytes)
    throw new Error(`a binary frame announces ${{header.payloadBytes}} bytes after its header and has ${{payload}}`);
  if (header.pieceOffset + header.payloadBytes > header.wholeBytes)
    throw new Error(
      `a binary frame has ${{header.payloadBytes}} bytes at offset ${{header.pieceOffset}}, but the whole frame has only ${{header.wholeBytes}}`,
    );
  return header;
}}

/** Writes the header at the start of `message`. */
export function writeFrameHeader(header: FrameHeader, message: ArrayBuffer): void {{
  const view = new DataView(message);
  MAGIC.forEach((letter, at) => view.setUint8(at, letter));
  view.setUint8(4, {header.version});
  view.setUint8(5, header.kind);
  view.setUint16(6, header.flags, true);
{"".join(map(write, header.fields))}}}
"""


def emit_python(header: Header) -> str:
    kinds = ", ".join(name.upper() for name in header.kinds) + " = " + ", ".join(map(str, header.kinds.values()))
    flags = ", ".join(name.upper() for name in header.flags)
    masks = ", ".join(str(mask) for mask, _ in header.flags.values())
    members = "".join(
        f"    {one['name']}: {'float' if one['type'][0] == 'f' else 'int'}  # {one['description']}\n"
        for one in header.fields
    )
    code = "".join(STRUCT[one["type"]] for one in header.fields)
    reserved = header.bytes - 8 - sum(BYTES[one["type"]] for one in header.fields)
    return f'''"""{SOURCE}"""

import struct
from dataclasses import astuple, dataclass

FRAME_HEADER = struct.Struct("<4sBBH{code}{reserved}x")
FRAME_HEADER_BYTES = {header.bytes}
{kinds}
{flags} = {masks}


@dataclass
class FrameHeader:
    kind: int
    flags: int
{members}

def read_frame_header(message: bytes) -> FrameHeader:
    """Raises ValueError on a bad magic, version, kind, flag or size."""
    if len(message) < FRAME_HEADER_BYTES:
        raise ValueError(f"a binary frame has {{len(message)}} bytes; its header alone has {header.bytes}")
    magic, version, *fields = FRAME_HEADER.unpack_from(message)
    header = FrameHeader(*fields)
    if magic != b"{header.magic}":
        raise ValueError("a binary frame does not begin with '{header.magic}'")
    if version != {header.version}:
        raise ValueError(
            f"a binary frame is of version {{version}}; this program reads version {header.version}. "
            "{RELOAD}"
        )
    if header.kind not in ({", ".join(map(str, header.kinds.values()))}):
        raise ValueError(f"a binary frame is of kind {{header.kind}}; the known kinds are {header.kind_list}")
    if header.flags & ~{header.known_flags}:
        raise ValueError(f"a binary frame has unknown flags {{header.flags}}")
    payload = len(message) - FRAME_HEADER_BYTES
    if payload != header.payload_bytes:
        raise ValueError(f"a binary frame announces {{header.payload_bytes}} bytes after its header and has {{payload}}")
    if header.piece_offset + header.payload_bytes > header.whole_bytes:
        raise ValueError(
            f"a binary frame has {{header.payload_bytes}} bytes at offset {{header.piece_offset}}, "
            f"but the whole frame has only {{header.whole_bytes}}"
        )
    return header


def write_frame_header(header: FrameHeader) -> bytes:
    return FRAME_HEADER.pack(b"{header.magic}", {header.version}, *astuple(header))
'''


def emit_table(header: Header) -> str:
    """Returns the table of the header in frame.md, as Markdown."""
    kinds = ", ".join(f"{number} {name}" for name, number in header.kinds.items())
    flags = "; ".join(
        f"bit {mask.bit_length() - 1} {name.replace('_', ' ')}: {text}" for name, (mask, text) in header.flags.items()
    )
    end = header.fields[-1]["offset"] + BYTES[header.fields[-1]["type"]]
    rows = [
        (0, f"u8[{len(header.magic)}]", "magic", f"`{header.magic}`"),
        (4, "u8", "version", header.version),
        (5, "u8", "kind", kinds),
        (6, "u16", "flags", flags),
        *((one["offset"], one["type"], one["name"], one["description"]) for one in header.fields),
        (end, f"u8[{header.bytes - end}]", "", "reserved, zero"),
    ]
    lines = ["| offset | type | field | meaning |", "|---|---|---|---|"]
    lines += ["| " + " | ".join(str(cell) for cell in row).replace("|  |", "| |") + " |" for row in rows]
    return "\n".join(lines) + "\n"
