// Decodes screenshots: PNG with 8-bit RGB or RGBA, not interlaced. Compares pictures and colors.
import { inflateSync } from "node:zlib";

export type Color = [number, number, number];

export interface Picture {
  width: number;
  height: number;
  at(x: number, y: number): Color;
}

function paeth(left: number, up: number, corner: number): number {
  const estimate = left + up - corner;
  const [a, b, c] = [Math.abs(estimate - left), Math.abs(estimate - up), Math.abs(estimate - corner)];
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

function unfilter(raw: Buffer, width: number, height: number, channels: number): Uint8Array {
  const stride = width * channels;
  const pixels = new Uint8Array(stride * height);
  for (let y = 0; y < height; y += 1) {
    const filter = raw[y * (stride + 1)] ?? 0;
    const [from, to, above] = [y * (stride + 1) + 1, y * stride, (y - 1) * stride];
    for (let i = 0; i < stride; i += 1) {
      const left = i >= channels ? (pixels[to + i - channels] ?? 0) : 0;
      const up = y > 0 ? (pixels[above + i] ?? 0) : 0;
      let guess = 0;
      if (filter === 1) guess = left;
      else if (filter === 2) guess = up;
      else if (filter === 3) guess = (left + up) >> 1;
      else if (filter === 4) guess = paeth(left, up, i >= channels && y > 0 ? (pixels[above + i - channels] ?? 0) : 0);
      pixels[to + i] = (raw[from + i] ?? 0) + guess;
    }
  }
  return pixels;
}

export function decodePng(file: Buffer): Picture {
  const parts: Buffer[] = [];
  let [width, height, type] = [0, 0, 0];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
    const name = file.toString("latin1", at + 4, at + 8);
    const data = file.subarray(at + 8, at + 8 + file.readUInt32BE(at));
    if (name === "IHDR") [width, height, type] = [data.readUInt32BE(0), data.readUInt32BE(4), data[9] ?? 0];
    if (name === "IDAT") parts.push(data);
  }
  const channels = type === 6 ? 4 : 3;
  const pixels = unfilter(inflateSync(Buffer.concat(parts)), width, height, channels);
  const channel = (x: number, y: number, c: number): number => pixels[(y * width + x) * channels + c] ?? 0;
  return {
    width,
    height,
    at: (x, y) => [channel(x, y, 0), channel(x, y, 1), channel(x, y, 2)],
  };
}

/** Returns the share of pixels for which the predicate holds. */
export function share(picture: Picture, holds: (color: Color, x: number, y: number) => boolean): number {
  let count = 0;
  for (let y = 0; y < picture.height; y += 1) {
    for (let x = 0; x < picture.width; x += 1) if (holds(picture.at(x, y), x, y)) count += 1;
  }
  return count / (picture.width * picture.height);
}

/** Returns the first pixel, row by row, for which the predicate holds. Throws Error if there is none. */
export function find(picture: Picture, holds: (color: Color, x: number, y: number) => boolean): [number, number] {
  for (let y = 0; y < picture.height; y += 1) {
    for (let x = 0; x < picture.width; x += 1) if (holds(picture.at(x, y), x, y)) return [x, y];
  }
  throw new Error("no such pixel in the picture");
}

export const distance = (a: Color, b: Color): number =>
  Math.max(Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1]), Math.abs(a[2] - b[2]));

/** Share of pixels that differ by more than 12 of 255 in any channel. */
export const difference = (a: Picture, b: Picture): number =>
  share(a, (color, x, y) => distance(color, b.at(x, y)) > 12);

const brightness = ([r, g, b]: Color): number => (r + g + b) / 3;

/** Share of pixels that are darker in b by more than 12 of 255. */
export const darker = (a: Picture, b: Picture): number =>
  share(a, (color, x, y) => brightness(color) - brightness(b.at(x, y)) > 12);

/** Share of pixels that have not the color of the picture's first pixel, which must lie on the background. */
export const covered = (picture: Picture): number => share(picture, (color) => distance(color, picture.at(0, 0)) > 12);

/** Mean over all pixels of the largest channel difference, from 0 to 255. */
export function meanDistance(a: Picture, b: Picture): number {
  let sum = 0;
  for (let y = 0; y < a.height; y += 1) {
    for (let x = 0; x < a.width; x += 1) sum += distance(a.at(x, y), b.at(x, y));
  }
  return sum / (a.width * a.height);
}

/** Hue of a color in degrees: 0 red, 120 green, 240 blue. null for grays. */
export function hue([r, g, b]: Color): number | null {
  const most = Math.max(r, g, b);
  const span = most - Math.min(r, g, b);
  if (span < 24) return null;
  const sector = most === r ? (g - b) / span : most === g ? 2 + (b - r) / span : 4 + (r - g) / span;
  return (60 * sector + 360) % 360;
}
