// Sizes of text in the page's font, in CSS pixels, for the layout of annotations.

export interface TextMeasure {
  /** Width of a text whose font has `pixels` per em. */
  width: (text: string, pixels: number) => number;
  /** Heights above and below the base line, both positive. */
  ascent: (pixels: number) => number;
  descent: (pixels: number) => number;
  digitHeight: (pixels: number) => number;
}

/** Largest number of cached widths. The cache is useful, because the same numbers appear in many frames. */
const MOST_KEPT = 2000;

/** Heights as fractions of an em, as in common sans-serif fonts. */
const ASCENT = 0.93;
const DESCENT = 0.24;
const DIGIT_HEIGHT = 0.73;

export function textMeasure(): TextMeasure {
  const kept = new Map<string, number>();
  let context: CanvasRenderingContext2D | null = null;
  const measured = (text: string, pixels: number): number => {
    context ??= document.createElement("canvas").getContext("2d");
    if (context === null) return estimatedWidth(text, pixels);
    context.font = `${pixels}px ${getComputedStyle(document.body).fontFamily}`;
    return context.measureText(text).width;
  };
  return {
    ...heights,
    width: (text, pixels) => {
      const key = `${pixels} ${text}`;
      const before = kept.get(key);
      if (before !== undefined) return before;
      if (kept.size >= MOST_KEPT) kept.clear();
      const width = measured(text, pixels);
      kept.set(key, width);
      return width;
    },
  };
}

const heights = {
  ascent: (pixels: number): number => Math.round(ASCENT * pixels),
  descent: (pixels: number): number => Math.round(DESCENT * pixels),
  digitHeight: (pixels: number): number => Math.round(DIGIT_HEIGHT * pixels),
};

/** Assumed width of a character in ems: the width of a digit. */
const CHARACTER = 0.62;
const estimatedWidth = (text: string, pixels: number): number => Array.from(text).length * CHARACTER * pixels;

/** Measures without a font: all characters have the width of a digit. */
export const plainMeasure: TextMeasure = { ...heights, width: estimatedWidth };
