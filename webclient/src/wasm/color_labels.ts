// Labels beside a color scale, computed by the code of server/annotations/color_ticks.hpp.
import { valuesItem, type ScaleOfValues } from "./color_scale";
import { call } from "./layout_module";

export const labelOn = (scale: ScaleOfValues, value: number): string =>
  call("label_on", valuesItem(scale), value).text();
