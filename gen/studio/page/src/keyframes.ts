/** Values that change over the film: keys of a time and a value each. */

import { isObject, type Path } from "./pointer";

export type Key = [number, unknown];

/** Keys are a list whose items are a number and a value each; a vector is a list of numbers. */
export const keysOf = (value: unknown): Key[] | null =>
  Array.isArray(value) && value.length > 0 && value.every((k) => Array.isArray(k)) ? (value as Key[]) : null;

/** How fast the curve goes at a key: at rest at the ends and where it turns back (Fritsch and Butland 1984, as gen/core/curve.h). */
function slopeAt(times: number[], values: number[], i: number): number {
  if (i === 0 || i === times.length - 1) return 0;
  const [before, after] = [times[i]! - times[i - 1]!, times[i + 1]! - times[i]!];
  const [left, right] = [(values[i]! - values[i - 1]!) / before, (values[i + 1]! - values[i]!) / after];
  if (left * right <= 0) return 0;
  const weight = (before + 2 * after) / (3 * (before + after));
  return (left * right) / (weight * right + (1 - weight) * left);
}

function numberAt(times: number[], values: number[], i: number, time: number): number {
  const width = times[i + 1]! - times[i]!;
  const t = (time - times[i]!) / width;
  const s = 1 - t;
  const value = (1 + 2 * t) * s * s * values[i]! + t * t * (3 - 2 * t) * values[i + 1]! +
    t * s * width * (s * slopeAt(times, values, i) - t * slopeAt(times, values, i + 1));
  return Number(value.toFixed(4));
}

/** The value at a time, as films have it: resting at the first and the last key, smooth between them. */
export function valueAtTime(value: unknown, time: number): unknown {
  const keys = keysOf(value);
  if (!keys) return value;
  const after = keys.findIndex(([t]) => t >= time);
  if (after < 0) return keys.at(-1)![1];
  if (after === 0 || keys[after]![0] === time) return keys[after]![1];
  const times = keys.map(([t]) => t);
  const first = keys[0]![1];
  if (!Array.isArray(first)) return numberAt(times, keys.map(([, v]) => Number(v)), after - 1, time);
  return first.map((_, axis) => numberAt(times, keys.map(([, v]) => Number((v as number[])[axis])), after - 1, time));
}

/** With a key at that time, in place of one that is (all but) there. */
export function withKey(value: unknown, time: number, at: unknown): Key[] {
  const t = Number(time.toFixed(3));
  const kept = (keysOf(value) ?? []).filter(([other]) => Math.abs(other - t) > 0.02);
  return [...kept, [t, at] as Key].sort((a, b) => a[0] - b[0]);
}

/** Lists of points that are no keys. */
const POINTS = new Set(["at", "points", "curve", "profile"]);

/** Lists of keys in an object, to any depth, each with the way to it. */
export function keyLists(value: unknown, path: Path = []): { path: Path; keys: Key[] }[] {
  if (!isObject(value)) return [];
  return Object.entries(value).flatMap(([name, inner]) => {
    const keys = POINTS.has(name) ? null : keysOf(inner);
    if (keys?.every((k) => k.length === 2 && typeof k[0] === "number")) return [{ path: [...path, name], keys }];
    return keyLists(inner, [...path, name]);
  });
}
