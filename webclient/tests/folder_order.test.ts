// The rule on the order of folders, as eslint.config.js applies it to the files of src/.
import { resolve } from "node:path";
import { Linter } from "eslint";
import tseslint from "typescript-eslint";
import { describe, expect, test } from "vitest";
import config from "../eslint.config.js";

const ROOT = resolve(import.meta.dirname, "../..");
const ofSources = config.filter(({ rules }) => rules?.["page/folder-order"] !== undefined);
const typescript: Linter.Config = { files: ["**/*.{ts,tsx}"], languageOptions: { parser: tseslint.parser } };
const linter = new Linter({ cwd: ROOT });

/** Lints a file of src/, which need not exist. */
const messagesOf = (file: string, code: string): string[] =>
  linter
    .verify(code, [typescript, ...(ofSources as Linter.Config[])], { filename: resolve(ROOT, "webclient/src", file) })
    .map(({ message }) => message);

const STATIC: Record<string, (path: string) => string> = {
  "a named import": (path) => `import { x } from "${path}";`,
  "a default import": (path) => `import x from "${path}";`,
  "an import of all": (path) => `import * as x from "${path}";`,
  "an import for effects": (path) => `import "${path}";`,
  "an import of types": (path) => `import type { X } from "${path}";`,
  "an import of one type": (path) => `import { type X } from "${path}";`,
  "a named export": (path) => `export { x } from "${path}";`,
  "an export of types": (path) => `export type { X } from "${path}";`,
  "an export of all": (path) => `export * from "${path}";`,
  "an export of all under a name": (path) => `export * as x from "${path}";`,
  "an export of all types": (path) => `export type * from "${path}";`,
};

const ELSEWHERE: Record<string, (path: string) => string> = {
  "a dynamic import": (path) => `export const x = () => import("${path}");`,
  "the type of a module": (path) => `export type X = typeof import("${path}");`,
  "a type of a module": (path) => `export type X = import("${path}").X;`,
  "a require": (path) => `import x = require("${path}");`,
};

const each = (forms: Record<string, (path: string) => string>): [string, (path: string) => string][] =>
  Object.entries(forms);

const ORDER = "generated, wasm, model, server, view, commands, panels, style, main";
const PANELS = "context, controls, color, volume, layers, look, time, stage, shell";

describe("a file of src/", () => {
  test.each([
    ["model/one.ts", "./other"],
    ["model/one.ts", "../wasm/other"],
    ["model/one.ts", "../model/other"],
    ["model/one.ts", "../../src/generated/protocol"],
    ["panels/color/one.tsx", "./other"],
    ["panels/color/one.tsx", "../context"],
    ["panels/color/one.tsx", "../controls/other"],
    ["panels/color/one.tsx", "../../model/other"],
    ["panels/color/one.tsx", "../../panels/controls/../context"],
    ["panels/context.ts", "../commands/other"],
    ["main.tsx", "./panels/shell/shell"],
    ["main.tsx", "./style/tokens.css"],
    ["main.tsx", "./generated/annotations.wasm?url"],
    ["wasm/one.ts", "preact"],
    ["wasm/one.ts", "../../../protocol/shading/lighting.glsl?raw"],
  ])("%s may import %s in each form at its top", (file, path) => {
    for (const [name, form] of each(STATIC)) expect([name, messagesOf(file, form(path))]).toEqual([name, []]);
  });

  test.each([
    ["wasm/one.ts", "../model/other", `wasm is before model in the order of src/: ${ORDER}.`],
    ["model/one.ts", "../panels/color/other", `model is before panels in the order of src/: ${ORDER}.`],
    ["model/one.ts", "../main", `model is before main in the order of src/: ${ORDER}.`],
    ["model/one.ts", "./../model/../view/other", `model is before view in the order of src/: ${ORDER}.`],
    ["panels/color/one.tsx", "../../main", `panels is before main in the order of src/: ${ORDER}.`],
    ["panels/color/one.tsx", "../../../src/style/one.css", `panels is before style in the order of src/: ${ORDER}.`],
    ["panels/controls/one.tsx", "../shell/other", `controls is before shell in the order of src/panels: ${PANELS}.`],
    ["panels/look/one.tsx", "../../panels/time/o", `look is before time in the order of src/panels: ${PANELS}.`],
    ["panels/context.ts", "./color/other", `context is before color in the order of src/panels: ${PANELS}.`],
    ["panels/color/one.tsx", "../../wasm/other", "src/panels may not import src/wasm."],
    ["panels/color/one.tsx", "../../server/other", "src/panels may not import src/server."],
    ["panels/context.ts", "../view/other", "src/panels may not import src/view."],
    ["model/one.ts", "../new/other", "Give the place of new in the order of src/ (folder_order.js)."],
    ["new/one.ts", "../model/other", "Give the place of new in the order of src/ (folder_order.js)."],
    ["panels/color/one.tsx", "..", "Give the place of the folder itself in the order of src/panels (folder_order.js)."],
    ["model/new/one.ts", "../other", "Give the order of src/model in folder_order.js."],
    ["model/one.ts", "./new/other", "Give the order of src/model in folder_order.js."],
  ])("%s may not import %s in any form", (file, path, message) => {
    for (const [name, form] of each(STATIC)) expect([name, messagesOf(file, form(path))]).toEqual([name, [message]]);
  });

  test.each(each(ELSEWHERE))("may not have %s, whose folder would not be checked", (_, form) => {
    for (const path of ["./other", "../generated/protocol", "../panels/color/other", "preact"])
      expect(messagesOf("model/one.ts", form(path))).toEqual([
        "Import at the top of the file, so that the rule on folders applies.",
      ]);
  });

  test("is told of each import that it may not have", () => {
    const code = `import { a } from "../model/a";\nimport { b } from "../wasm/b";\nexport { c } from "../view/c";\n`;
    expect(messagesOf("wasm/one.ts", code)).toEqual([
      `wasm is before model in the order of src/: ${ORDER}.`,
      `wasm is before view in the order of src/: ${ORDER}.`,
    ]);
    expect(messagesOf("wasm/one.ts", "export const x = 1;\nexport { x as y };\n")).toEqual([]);
  });
});
