// Re-exports functions of wasm/ that lay out annotations and format numbers. Panels use them from here, because panels/
// may not import wasm/ (folder_order.js).
export { labelOn } from "../wasm/color_labels";
export { legendTitle } from "../wasm/legend_names";
export { numberAlone, prettyUnits } from "../wasm/numbers_as_text";
export { layOut, layTexts, type Box, type Fill, type LegendText, type Overlay } from "../wasm/overlay";
