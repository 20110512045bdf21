// Vectors of three numbers, and 4x4 matrices in column-major order, as WebGL reads them.
import type { Vec3 } from "../generated/protocol";

export type { Vec3 };
export type Matrix = [
  number, number, number, number,
  number, number, number, number,
  number, number, number, number,
  number, number, number, number,
]; // prettier-ignore

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export function normalize(a: Vec3, fallback: Vec3 = [0, 0, 1]): Vec3 {
  const size = length(a);
  return size > 0 ? scale(a, 1 / size) : fallback;
}

/** Rotates `a` about the unit vector `axis` by `angle` in radians (Rodrigues' formula). */
export function rotate(a: Vec3, axis: Vec3, angle: number): Vec3 {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return add(add(scale(a, c), scale(cross(axis, a), s)), scale(axis, dot(axis, a) * (1 - c)));
}

export function multiply(a: Matrix, b: Matrix): Matrix {
  const at = (m: Matrix, row: number, column: number): number => m[column * 4 + row] ?? 0;
  const entry = (row: number, column: number): number =>
    at(a, row, 0) * at(b, 0, column) +
    at(a, row, 1) * at(b, 1, column) +
    at(a, row, 2) * at(b, 2, column) +
    at(a, row, 3) * at(b, 3, column);
  return Array.from({ length: 16 }, (_, i) => entry(i % 4, Math.floor(i / 4))) as Matrix;
}
