"""The contract and the code generated from it are valid, complete and up to date."""

import importlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else __file__).resolve()
if ROOT.is_file():
    ROOT = ROOT.parents[2]
sys.path.insert(0, str(ROOT / "protocol"))
from generator import cpp, cpp_scene, frame_header, model, python, python_calls, typescript  # noqa: E402

DOCUMENT = json.loads((ROOT / "protocol/openrpc.json").read_text(encoding="utf-8"))


def walk(value, path="#"):
    yield path, value
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from walk(inner, f"{path}/{key}")


class Document(unittest.TestCase):
    """Rules of OpenRPC 1.2.6 that the document could violate."""

    def test_required_members(self):
        self.assertRegex(DOCUMENT["openrpc"], r"^1\.2\.\d+$")
        self.assertTrue({"title", "version"} <= DOCUMENT["info"].keys())
        known = ("openrpc", "info", "servers", "methods", "components")
        self.assertEqual([key for key in DOCUMENT if key not in known and key[:2] != "x-"], [])

    def test_servers(self):
        for server in DOCUMENT["servers"]:
            self.assertTrue({"name", "url"} <= server.keys())
            used = set(re.findall(r"\{(\w+)\}", server["url"] + server["summary"]))
            self.assertEqual(used, set(server["variables"]))
            for variable in server["variables"].values():
                self.assertIn("default", variable)

    def test_each_param_has_a_description(self):
        for method in DOCUMENT["methods"] + DOCUMENT["x-notifications"]:
            for param in method["params"]:
                self.assertTrue(param.get("description"), f"{method['name']}: {param['name']}")

    def test_each_method_has_an_example(self):
        """tests/unit/methods checks the examples' values against the schemas and sends them to a server."""
        for method in DOCUMENT["methods"]:
            with self.subTest(method["name"]):
                self.assertTrue(method["examples"])
                params = {param["name"]: param.get("required", False) for param in method["params"]}
                for example in method["examples"]:
                    given = [param["name"] for param in example["params"]]
                    self.assertLessEqual(set(given), set(params))
                    self.assertLessEqual({name for name, required in params.items() if required}, set(given))
                    self.assertIn("value", example["result"])

    def test_methods(self):
        names = [method["name"] for method in DOCUMENT["methods"]]
        self.assertEqual(len(names), len(set(names)))
        for method in DOCUMENT["methods"]:
            with self.subTest(method["name"]):
                self.assertIn(method["paramStructure"], ("by-name", "by-position", "either"))
                self.assertTrue({"name", "schema"} <= method["result"].keys())
                params = [param["name"] for param in method["params"]]
                self.assertEqual(len(params), len(set(params)))
                required = [param.get("required", False) for param in method["params"]]
                self.assertEqual(required, sorted(required, reverse=True), "required params come first")

    def test_each_slow_method_takes_progress(self):
        for method in DOCUMENT["methods"]:
            if method.get("x-slow"):
                self.assertIn("progress", [param["name"] for param in method["params"]], method["name"])

    def test_references_resolve(self):
        for path, value in walk(DOCUMENT):
            if isinstance(value, dict) and "$ref" in value:
                with self.subTest(path):
                    target = DOCUMENT
                    for step in value["$ref"].removeprefix("#/").split("/"):
                        target = target[step]

    def test_schemas_are_well_formed(self):
        for path, value in walk(DOCUMENT):
            if not isinstance(value, dict) or value.get("type") != "object" or path.endswith("/properties"):
                continue
            with self.subTest(path):
                self.assertLessEqual(set(value.get("required", [])), set(value.get("properties", {})))

    def test_patterns_are_bounded(self):
        """std::regex recurses once per character of an unbounded repetition, so patterns need an upper bound."""
        for path, value in walk(DOCUMENT):
            if isinstance(value, dict) and isinstance(value.get("pattern"), str):
                self.assertNotRegex(value["pattern"], r"[*+]|,\}", path)

    def test_error_codes(self):
        codes = [error["code"] for error in DOCUMENT["components"]["errors"].values()]
        self.assertEqual(len(codes), len(set(codes)))
        for code in codes:
            self.assertTrue(-32099 <= code <= -32000, "the range that JSON-RPC leaves to servers")

    def test_defaults_are_among_the_choices(self):
        for path, value in walk(DOCUMENT):
            if isinstance(value, dict) and "default" in value and "enum" in value:
                self.assertIn(value["default"], value["enum"], path)


class Generated(unittest.TestCase):
    def setUp(self):
        self.contract = model.load(ROOT / "protocol/openrpc.json")

    def test_each_method_is_a_file(self):
        for method in self.contract.methods:
            source = ROOT / "server/methods" / f"{method.identifier}.cpp"
            self.assertTrue(source.exists(), source)
            self.assertIn(f"{method.type_prefix}Result {method.identifier}(", source.read_text(encoding="utf-8"))

    def test_each_method_is_in_every_language(self):
        outputs = {
            "C++": cpp.emit_table(self.contract),
            "TypeScript": typescript.emit(self.contract),
        }
        for method in self.contract.methods:
            for language, text in outputs.items():
                self.assertIn(f'"{method.name}"', text, language)
            self.assertIn(f"class {method.type_prefix}Params(TypedDict)", python.emit(self.contract))

    def test_what_draws_extracts_or_exports_is_slow(self):
        """A method that draws, extracts or exports must be declared slow. Otherwise it would block quick calls of all clients."""
        table = cpp.emit_table(self.contract)
        for method in self.contract.methods:
            source = (ROOT / "server/methods" / f"{method.identifier}.cpp").read_text(encoding="utf-8")
            works = any(word in source for word in ("picture_workers()", ".geometry(", "loaded->histogram(", "uploads().commit("))
            self.assertEqual(method.slow, works, method.name)
            self.assertIn(f'{{"{method.name}", {"true" if works else "false"}, ', table)

    def test_each_error_is_in_every_language(self):
        for name, (code, _) in self.contract.errors.items():
            self.assertIn(f"{name} = {code}", cpp.emit_types(self.contract))
            self.assertIn(f"{name}: {code}", typescript.emit(self.contract))
            self.assertIn(f'"{name}": {code}', python.emit(self.contract))

    def test_defaults_and_limits_are_in_every_language(self):
        text = typescript.emit(self.contract)
        self.assertIn("  Camera: { up: [0, 0, 1], fov: 30, parallel: false },\n", text)
        self.assertIn('  "picture.render": { width: 1280, height: 720 },\n', text)
        self.assertIn("  Coloring: { points: [2, 64], steps: [2, 256] },\n", text)
        self.assertIn('  "view.open": { width: [16, 8192], height: [16, 8192], pixel_ratio: [0.25, 16] },\n', text)
        schemas = python.emit_schemas(self.contract)
        self.assertIn("camera that is not parallel. (above 0 and below 180, default 30)\n", schemas)
        self.assertIn("    opacity: NotRequired[float]  # 0 to 1, default 1\n", schemas)
        self.assertIn("    bins: NotRequired[int]  # Number of bins of equal width.", python.emit(self.contract))
        self.assertIn("(1 to 4096, default 256)\n", python_calls.emit(self.contract, is_async=False))

    def test_an_optional_member_with_a_default_can_be_told_from_its_default(self):
        text = cpp_scene.emit_types(self.contract)
        self.assertIn("static constexpr std::size_t default_count = 10;\n    std::optional<std::size_t> count{};", text)
        self.assertRegex(typescript.emit(self.contract), r"  Contours: \{ .*count: 10, ")
        self.assertRegex(python.emit_schemas(self.contract), r"    count: NotRequired\[int\]  # .*default 10\)\n")

    def test_the_version_is_in_every_language(self):
        major, minor = self.contract.protocol
        self.assertIn(f"major_version = {major}, minor_version = {minor};", cpp.emit_document(self.contract))
        self.assertIn(f"PROTOCOL = {{ major: {major}, minor: {minor} }}", typescript.emit(self.contract))
        self.assertIn(f'PROTOCOL = {{"major": {major}, "minor": {minor}}}', python.emit(self.contract))

    def test_again_is_the_same(self):
        again = model.load(ROOT / "protocol/openrpc.json")
        for emit in [*cpp.FILES.values(), *cpp_scene.FILES.values(), typescript.emit, python.emit_schemas, python.emit]:
            self.assertEqual(emit(self.contract), emit(again))

    def test_python_types_are_up_to_date_and_load(self):
        for name, text in {"schemas": python.emit_schemas(self.contract), "types": python.emit(self.contract)}.items():
            committed = (ROOT / f"protocol/python/ciel_client/{name}.py").read_text(encoding="utf-8")
            self.assertEqual(committed, text, f"{name}.py: run protocol/generate.py --python")
        sys.path.insert(0, str(ROOT / "protocol/python"))
        types = importlib.import_module("ciel_client.types")
        for schema in self.contract.schemas:
            self.assertTrue(hasattr(types, schema), schema)

    def test_python_methods_frame_header_and_version_are_up_to_date(self):
        header = frame_header.load(ROOT / "protocol/frame_header.json")
        texts = {
            "calls.py": python_calls.emit(self.contract, is_async=False),
            "async_calls.py": python_calls.emit(self.contract, is_async=True),
            "frame_header.py": frame_header.emit_python(header),
            "version.py": python.emit_version((ROOT / "server/ciel/version.txt").read_text(encoding="utf-8")),
        }
        for name, text in texts.items():
            committed = (ROOT / "protocol/python/ciel_client" / name).read_text(encoding="utf-8")
            self.assertEqual(committed, text, f"{name}: run protocol/generate.py --python protocol/python/ciel_client")

    def test_the_table_of_the_frame_header_is_up_to_date(self):
        table = frame_header.emit_table(frame_header.load(ROOT / "protocol/frame_header.json"))
        self.assertIn(table, (ROOT / "protocol/frame.md").read_text(encoding="utf-8"), "run protocol/generate.py --markdown")

    def test_a_gap_in_the_frame_header_is_noticed(self):
        table = json.loads((ROOT / "protocol/frame_header.json").read_text(encoding="utf-8"))
        table["fields"][3]["offset"] += 1
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "frame_header.json"
            path.write_text(json.dumps(table), encoding="utf-8")
            with self.assertRaisesRegex(ValueError, "width has offset 25; the field before it ends at 24"):
                frame_header.load(path)

    def test_every_layer_type_is_a_structure_of_the_scene(self):
        types = cpp_scene.emit_types(self.contract)
        for option in DOCUMENT["components"]["schemas"]["Layer"]["oneOf"]:
            self.assertIn(f"struct {option['$ref'].rsplit('/', 1)[1]} {{", types)

    def test_the_embedded_document_is_the_document(self):
        text = cpp.emit_document(self.contract)
        parts = re.findall(r'R"openrpc\((.*?)\)openrpc"', text, re.S)
        self.assertLess(max(map(len, parts)), 65_536, "a compiler need not take a longer literal")
        self.assertEqual(json.loads("".join(parts)), DOCUMENT)

    def test_unchanged_files_are_left_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, str(ROOT / "protocol/generate.py"), "--cpp", folder]
            subprocess.run(command, check=True)
            before = {file.name: file.stat().st_mtime_ns for file in pathlib.Path(folder).iterdir()}
            subprocess.run(command, check=True)
            after = {file.name: file.stat().st_mtime_ns for file in pathlib.Path(folder).iterdir()}
            self.assertEqual(before, after)
            self.assertEqual(set(before), {*cpp.FILES, *cpp_scene.FILES, "frame_header.hpp"})


if __name__ == "__main__":
    unittest.main()
