import js from "@eslint/js";
import tseslint from "typescript-eslint";

export default tseslint.config(
  { ignores: ["**/dist/", "**/src/generated/"] },
  js.configs.recommended,
  ...tseslint.configs.strictTypeChecked,
  {
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: `${import.meta.dirname}/..` } },
    rules: {
      "max-lines": ["error", 500],
      "max-lines-per-function": ["error", 80],
      "@typescript-eslint/restrict-template-expressions": ["error", { allowNumber: true }],
      "@typescript-eslint/no-confusing-void-expression": ["error", { ignoreArrowShorthand: true }],
    },
  },
  ...["wasm", "model", "server", "view", "commands", "panels"].map((folder, level, folders) => ({
    // One direction: a folder imports those before it. Panels get the model and the commands, and nothing else.
    files: [`webclient/src/${folder}/**`],
    rules: {
      "no-restricted-imports": [
        "error",
        {
          patterns: [
            {
              regex: `^(\\.\\./)+(${[...folders.slice(level + 1), ...(folder === "panels" ? ["wasm", "server", "view"] : []), "main"].join("|")})(/|$)`,
              message:
                "The folders of src/ import those before them only: wasm, model, server, view, commands, panels.",
            },
          ],
        },
      ],
      // no-restricted-imports does not see these forms of an import.
      "no-restricted-syntax": [
        "error",
        ...["ImportExpression", "TSImportType"].map((selector) => ({
          selector,
          message: "Import at the top of the file, so that the rule on folders applies.",
        })),
      ],
    },
  })),
  {
    files: ["**/*.test.ts"],
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
