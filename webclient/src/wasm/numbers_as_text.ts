// Numbers and units as text, computed by the code of server/annotations/ticks.hpp.
import { call } from "./layout_module";

/** Formats a single number with at most `digits` digits and its own power of ten. */
export const numberAlone = (value: number, digits = 6): string => call("number_alone", value, digits).text();

/** Returns the units with superscripts: m^2/s^2 becomes m²/s². */
export const prettyUnits = (units: string): string => call("pretty_units", units).text();
