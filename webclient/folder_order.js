// ESLint rule: a file of src/ imports only from its own folder and from folders before it.
import { dirname, relative, resolve, sep } from "node:path";

const SRC = resolve(import.meta.dirname, "src");

/** Order of the entries of each folder that has subfolders. "" is src/. */
const ORDER = {
  "": ["generated", "wasm", "model", "server", "view", "commands", "panels", "style", "main"],
  panels: ["context", "controls", "color", "volume", "layers", "look", "time", "stage", "shell"],
};

/** Folders that these folders may not import, although they are before them. */
const HIDDEN = { panels: ["wasm", "server", "view"] };

/** Path below src/ as a list, without the extension of the file. */
const partsOf = (path) =>
  relative(SRC, path)
    .replace(/\.\w+$/, "")
    .split(sep);

/** Returns the reason why the file `from` may not import `to`; null if it may. */
function refusal(from, to) {
  const depth = from.findIndex((part, level) => part !== to[level]);
  if (depth < 0 || to[0] === "..") return null; // the file itself, or data outside src/
  const folder = from.slice(0, depth).join("/");
  const [mine, other] = [from[depth], to[depth]];
  const order = ORDER[folder];
  const areFiles = from.length === depth + 1 && to.length === depth + 1;
  if (order === undefined) return areFiles ? null : `Give the order of src/${folder} in folder_order.js.`;
  for (const part of [mine, other])
    if (!order.includes(part))
      return `Give the place of ${part ?? "the folder itself"} in the order of src/${folder} (folder_order.js).`;
  if (folder === "" && HIDDEN[mine]?.includes(other)) return `src/${mine} may not import src/${other}.`;
  if (order.indexOf(other) < order.indexOf(mine)) return null;
  return `${mine} is before ${other} in the order of src/${folder}: ${order.join(", ")}.`;
}

export const folderOrder = {
  create(context) {
    const check = ({ source }) => {
      if (!source?.value.startsWith(".")) return;
      const message = refusal(partsOf(context.filename), partsOf(resolve(dirname(context.filename), source.value)));
      if (message !== null) context.report({ node: source, message });
    };
    return { ImportDeclaration: check, ExportNamedDeclaration: check, ExportAllDeclaration: check };
  },
};
