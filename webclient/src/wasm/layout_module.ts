// Loads the WebAssembly module of server/page. Annotations and colors of the page are then the same as in saved
// pictures.
import { messageOf, ResultReader, type Item } from "./message";
import { textMeasure, type TextMeasure } from "./text_measure";

type Call = () => number;
type FunctionName =
  | ("lay_out" | "lay_texts" | "label_on" | "number_alone" | "pretty_units")
  | ("has_width" | "place_of" | "value_at" | "color_of" | "colors_along" | "color_row" | "scale_rules")
  | ("named_background" | "is_bright")
  | ("range_of" | "range_above_zero" | "is_shown_by" | "color_maps")
  | ("legend_title" | "legend_name_of" | "legend_names" | "default_camera");
type Exports = Record<FunctionName, Call> & {
  memory: WebAssembly.Memory;
  _initialize: () => void;
  room: (floats: number) => number;
  results: () => number;
};

let loaded: Exports | null = null;

/** Imports of the module's C library. They do nothing: the library writes only to report defects of the module. */
function systemCalls(): WebAssembly.ModuleImports {
  const none = (): number => 0;
  return { fd_close: none, fd_seek: none, fd_write: none };
}

function measureIn(memory: () => WebAssembly.Memory, measure: TextMeasure): WebAssembly.ModuleImports {
  const decoder = new TextDecoder();
  return {
    text_width: (at: number, bytes: number, pixels: number): number =>
      measure.width(decoder.decode(new Uint8Array(memory().buffer, at, bytes)), pixels),
    ascent: (pixels: number): number => measure.ascent(pixels),
    descent: (pixels: number): number => measure.descent(pixels),
    digit_height: (pixels: number): number => measure.digitHeight(pixels),
  };
}

/** Call before all other functions of this folder. Throws Error if the browser refuses the module. */
export async function startLayoutModule(bytes: BufferSource, measure: TextMeasure = textMeasure()): Promise<void> {
  const { instance } = await WebAssembly.instantiate(bytes, {
    page: measureIn(() => exportsOf().memory, measure),
    wasi_snapshot_preview1: systemCalls(),
  });
  loaded = instance.exports as Exports;
  loaded._initialize();
}

function exportsOf(): Exports {
  if (loaded === null) throw new Error("The layout module is not loaded; call startLayoutModule() first");
  return loaded;
}

/** Calls a function of the module. The reader is valid until the next call. */
export function call(name: FunctionName, ...items: readonly Item[]): ResultReader {
  const module = exportsOf();
  const message = messageOf(items);
  const at = module.room(message.length);
  new Float64Array(module.memory.buffer, at, message.length).set(message);
  const count = module[name]();
  return new ResultReader(new Float64Array(module.memory.buffer, module.results(), count));
}
