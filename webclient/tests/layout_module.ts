// Starts the WebAssembly module for the tests, with text whose characters all have the width of a digit.
/// <reference types="node" />
import { readFileSync } from "node:fs";
import { startLayoutModule } from "../src/wasm/layout_module";
import { plainMeasure } from "../src/wasm/text_measure";

await startLayoutModule(
  new Uint8Array(readFileSync(`${import.meta.dirname}/../src/generated/annotations.wasm`)),
  plainMeasure,
);
