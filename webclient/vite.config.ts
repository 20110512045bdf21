import { defineConfig } from "vitest/config";

export default defineConfig({
  base: "./", // the server may live under any path prefix
  build: { target: "es2022", assetsInlineLimit: 0, modulePreload: { polyfill: false } },
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  server: { proxy: { "/ws": { target: "ws://127.0.0.1:8080", ws: true } } },
  test: { include: ["tests/**/*.test.{ts,tsx}"], environment: "node", setupFiles: "tests/layout_module.ts" },
});
