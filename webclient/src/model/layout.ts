// Exports again, for panels, the server's functions that lay out annotations and write numbers as text. Panels may
// import only model and commands.
export { labelOn } from "../wasm/color_labels";
export { legendTitle } from "../wasm/legend_names";
export { numberAlone, prettyUnits } from "../wasm/numbers_as_text";
export { layOut, layTexts, type Box, type Fill, type LegendText, type Overlay } from "../wasm/overlay";
