/** Values that change over the film: keys of a time and a value each. */

import { isObject, type Path } from "./pointer";
import { isCurve } from "./schema";

export type Key = [time: number, value: unknown, shape?: unknown];

/** Keys are a list whose items are a number and a value each; a vector is a list of numbers. */
export const keysOf = (value: unknown): Key[] | null =>
  Array.isArray(value) && value.length > 0 && value.every((k) => Array.isArray(k)) ? (value as Key[]) : null;

/** What a key may say besides its time and value: an ease of the way to the next one, and handles in space. */
export interface Shape {
  ease?: Ease;
  in?: number[];
  out?: number[];
}
export const shapeOf = ([, , shape]: Key): Shape => (typeof shape === "string" ? { ease: shape as Ease } : isObject(shape) ? (shape as Shape) : {});

export const EASES = ["none", "in", "out", "both"] as const;
export type Ease = (typeof EASES)[number];
/** As gen/base/core/ease.h. */
const EASED: Record<Ease, (t: number) => number> = { none: (t) => t, in: (t) => t * t, out: (t) => t * (2 - t), both: (t) => t * t * (3 - 2 * t) };

/** How fast the curve goes at a key: at rest at the ends and where it turns back (Fritsch and Butland 1984, as gen/base/core/curve.h). */
function slopeAt(keys: Key[], of: (value: unknown) => number, i: number): number {
  if (i === 0 || i === keys.length - 1) return 0;
  const [a, b, c] = [keys[i - 1]!, keys[i]!, keys[i + 1]!];
  const [before, after] = [b[0] - a[0], c[0] - b[0]];
  const [left, right] = [(of(b[1]) - of(a[1])) / before, (of(c[1]) - of(b[1])) / after];
  if (left * right <= 0) return 0;
  const weight = (before + 2 * after) / (3 * (before + after));
  return (left * right) / (weight * right + (1 - weight) * left);
}

/** The handle of a key on the side of a key beside it, given or as the curve goes without. */
function handleOf(keys: Key[], of: (value: unknown) => number, k: number, way: "in" | "out"): number {
  const shape = shapeOf(keys[k]!);
  if (shape[way]) return of(shape[way]);
  const other = shape[way === "in" ? "out" : "in"];
  if (other) return -of(other);
  const [a, d] = way === "out" ? [keys[k]!, keys[k + 1]!] : [keys[k - 1]!, keys[k]!];
  const third = (shapeOf(a).ease ? of(d[1]) - of(a[1]) : (d[0] - a[0]) * slopeAt(keys, of, k)) / 3;
  return way === "out" ? third : -third;
}

/** A number of the values between key `i` and the next, a share of the time on: along a cubic Bézier curve. */
function between(keys: Key[], of: (value: unknown) => number, i: number, share: number): number {
  const [a, d] = [keys[i]!, keys[i + 1]!];
  const { ease } = shapeOf(a);
  const t = ease && ease in EASED ? EASED[ease](share) : share;
  const s = 1 - t;
  return s * s * s * of(a[1]) + 3 * s * s * t * (of(a[1]) + handleOf(keys, of, i, "out")) + 3 * s * t * t * (of(d[1]) + handleOf(keys, of, i + 1, "in")) + t * t * t * of(d[1]);
}

const component = (axis: number) => (value: unknown): number => Number((value as number[])[axis]);

/** The value at a time, as films have it: resting at the first and the last key, smooth between them. */
export function valueAtTime(value: unknown, time: number): unknown {
  const keys = keysOf(value);
  if (!keys) return value;
  const after = keys.findIndex(([t]) => t >= time);
  if (after < 0) return keys.at(-1)![1];
  if (after === 0 || keys[after]![0] === time) return keys[after]![1];
  const before = keys[after - 1]!;
  const share = (time - before[0]) / (keys[after]![0] - before[0]);
  const at = (of: (v: unknown) => number): number => Number(between(keys, of, after - 1, share).toFixed(4));
  return Array.isArray(before[1]) ? before[1].map((_, axis) => at(component(axis))) : at(Number);
}

/** Places along the way of keys in space, `pieces` between two; x, y, z in turn. */
export function wayOf(keys: Key[], pieces: number): Float32Array {
  const all = new Float32Array(3 * (Math.max(0, keys.length - 1) * pieces + 1));
  for (let axis = 0; axis < 3; ++axis) {
    const of = component(axis);
    for (let i = 0; i + 1 < keys.length; ++i) for (let k = 0; k <= pieces; ++k) all[3 * (i * pieces + k) + axis] = between(keys, of, i, k / pieces);
    if (keys.length === 1) all[axis] = of(keys[0]![1]);
  }
  return all;
}

/** The handle of a key in space; null on the outer side of the first and the last. */
export function handleAt(keys: Key[], k: number, way: "in" | "out"): number[] | null {
  return keys[way === "out" ? k + 1 : k - 1] ? [0, 1, 2].map((axis) => handleOf(keys, component(axis), k, way)) : null;
}

/** With a key at that time, in place of one that is (all but) there, whose ease stays. */
export function withKey(value: unknown, time: number, at: unknown): Key[] {
  const t = Number(time.toFixed(3));
  const is = ([other]: Key): boolean => Math.abs(other - t) <= 0.02;
  const keys = keysOf(value) ?? [];
  const shape = keys.find(is)?.slice(2) ?? [];
  return [...keys.filter((k) => !is(k)), [t, at, ...shape] as Key].sort((a, b) => a[0] - b[0]);
}

/** Lists of points that are no keys. */
const POINTS = new Set(["at", "points"]);

/** Lists of keys in an object, to any depth, each with the way to it. */
export function keyLists(value: unknown, path: Path = []): { path: Path; keys: Key[] }[] {
  if (!isObject(value)) return [];
  return Object.entries(value).flatMap(([name, inner]) => {
    const keys = POINTS.has(name) || isCurve(name) ? null : keysOf(inner);
    if (keys?.every((k) => (k.length === 2 || k.length === 3 && typeof k[2] !== "number") && typeof k[0] === "number")) return [{ path: [...path, name], keys }];
    return keyLists(inner, [...path, name]);
  });
}
