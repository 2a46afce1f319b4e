import type { Vec3 } from "./header";

/** The curve through keyframes as the film goes along it: continuous speed, at rest at the first and the last key
 *  (Fritsch and Butland 1984; the same as Animated in gen/core/curve.h). */

export interface Key {
  t: number;
  at: Vec3;
}

function slopes(keys: readonly Key[], axis: number): number[] {
  const result = new Array<number>(keys.length).fill(0);
  const secant = (i: number): number => (keys[i + 1]!.at[axis]! - keys[i]!.at[axis]!) / (keys[i + 1]!.t - keys[i]!.t);
  for (let i = 1; i + 1 < keys.length; ++i) {
    const before = secant(i - 1);
    const after = secant(i);
    if (before * after <= 0) continue;
    const h0 = keys[i]!.t - keys[i - 1]!.t;
    const h1 = keys[i + 1]!.t - keys[i]!.t;
    const weight = (h0 + 2 * h1) / (3 * (h0 + h1));
    result[i] = (before * after) / (weight * after + (1 - weight) * before);
  }
  return result;
}

/** Points along the curve, `pieces` between two keys; x, y, z in turn. */
export function points(keys: readonly Key[], pieces: number): Float32Array {
  const all = new Float32Array(3 * (Math.max(0, keys.length - 1) * pieces + 1));
  for (let axis = 0; axis < 3; ++axis) {
    const slope = slopes(keys, axis);
    for (let i = 0; i + 1 < keys.length; ++i) {
      const width = keys[i + 1]!.t - keys[i]!.t;
      for (let k = 0; k <= pieces; ++k) {
        const t = k / pieces;
        const s = 1 - t;
        all[3 * (i * pieces + k) + axis] =
          (1 + 2 * t) * s * s * keys[i]!.at[axis]! +
          t * s * s * width * slope[i]! +
          t * t * (3 - 2 * t) * keys[i + 1]!.at[axis]! -
          t * t * s * width * slope[i + 1]!;
      }
    }
  }
  if (keys.length === 1) all.set(keys[0]!.at);
  return all;
}
