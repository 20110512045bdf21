import js from "@eslint/js";
import tseslint from "typescript-eslint";
import { folderOrder } from "./folder_order.js";

export default tseslint.config(
  { ignores: ["**/dist/", "**/src/generated/"] },
  js.configs.recommended,
  ...tseslint.configs.strictTypeChecked,
  {
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: `${import.meta.dirname}/..` } },
    rules: {
      "max-lines": ["error", 500],
      "max-lines-per-function": ["error", 60],
      "@typescript-eslint/restrict-template-expressions": ["error", { allowNumber: true }],
      "@typescript-eslint/no-confusing-void-expression": ["error", { ignoreArrowShorthand: true }],
    },
  },
  {
    files: ["webclient/src/**"],
    plugins: { page: { rules: { "folder-order": folderOrder } } },
    rules: {
      "page/folder-order": "error",
      "no-restricted-imports": [
        "error",
        {
          paths: ["@preact/signals", "@preact/signals-core"].map((name) => ({
            name,
            importNames: ["effect", "useSignalEffect"],
            message:
              "Only panels and the view react to signals, by drawing. Other code is called where the scene changes (Server.sceneChanged).",
          })),
        },
      ],
      // The rule on folders does not see these forms of an import.
      "no-restricted-syntax": [
        "error",
        ...["ImportExpression", "TSImportType", "TSExternalModuleReference"].map((selector) => ({
          selector,
          message: "Import at the top of the file, so that the rule on folders applies.",
        })),
      ],
    },
  },
  {
    files: ["**/*.test.{ts,tsx}"],
    rules: {
      "max-lines-per-function": "off", // a describe block is a list
      "@typescript-eslint/no-floating-promises": [
        "error",
        {
          allowForKnownSafeCalls: [
            { from: "package", package: "node:test", name: ["test", "describe", "before", "after"] },
          ],
        },
      ],
    },
  },
);
