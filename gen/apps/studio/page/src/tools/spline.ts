import { Vector3 } from "three";

/** A point of a line and the handles that it has, from it to the control points of cubic curves. */
export interface Knot {
  at: Vector3;
  in?: Vector3;
  out?: Vector3;
}

const PIECES = 12;

/** The handle of a point, given or opposite to the other; without any, that of a smooth line, or null at a corner. */
export function handleOf(knots: readonly Knot[], i: number, way: "in" | "out", smooth: boolean, closed: boolean): Vector3 | null {
  const knot = knots[i]!;
  const other = knot[way === "in" ? "out" : "in"];
  if (knot[way]) return knot[way];
  if (other) return other.clone().negate();
  return smooth ? slope(knots, i, closed, way).multiplyScalar(way === "out" ? 1 : -1) : null;
}

/**
 * A third of the slope of a smooth line at a point, as spline_slopes() of gen/base/core/spline.h has it: of Catmull and Rom
 * where both ways are about as long, of their centripetal curve where one is much longer.
 */
export function slope(knots: readonly Knot[], i: number, closed: boolean, way: "in" | "out" = "out"): Vector3 {
  const n = knots.length;
  const near = (k: number): Vector3 => knots[closed ? (k + n) % n : Math.min(n - 1, Math.max(0, k))]!.at;
  const even = near(i + 1).clone().sub(near(i - 1)).divideScalar(6);
  if (!closed && (i === 0 || i === n - 1)) return even;
  const come = near(i).clone().sub(near(i - 1));
  const go = near(i + 1).clone().sub(near(i));
  const [a, b] = [come.length(), go.length()];
  const ratio = Math.max(a, b) / Math.min(a, b);
  if (!(ratio > 1.5)) return even;
  if (!(Math.min(a, b) > 0)) return new Vector3();
  const s = Math.min((ratio - 1.5) / 1.5, 1);
  const [before, after] = [Math.sqrt(a), Math.sqrt(b)];
  const share = s * s * (3 - 2 * s);
  const speed = come.multiplyScalar(after / before).addScaledVector(go, before / after).divideScalar(3 * (before + after));
  // Both of one direction, or there would be a corner.
  const line = even.clone().lerp(speed.clone().multiplyScalar(Math.sqrt(before * after)), share);
  const along = speed.length() * (way === "in" ? before : after);
  return line.setLength(even.length() + (along - even.length()) * share);
}

/** Places along a line, as gen/base/core/spline.h has them. */
export function splinePlaces(knots: readonly Knot[], smooth: boolean, closed: boolean): Vector3[] {
  const n = knots.length;
  const places: Vector3[] = [];
  for (let i = 0; i < (closed ? n : n - 1); ++i) {
    const j = (i + 1) % n;
    const [a, d] = [knots[i]!.at, knots[j]!.at];
    const [on, back] = [handleOf(knots, i, "out", smooth, closed), handleOf(knots, j, "in", smooth, closed)];
    places.push(a);
    if (!on && !back) continue;
    const [b, c] = [a.clone().add(on ?? new Vector3()), d.clone().add(back ?? new Vector3())];
    for (let k = 1; k < PIECES; ++k) {
      const t = k / PIECES;
      const s = 1 - t;
      places.push(new Vector3().addScaledVector(a, s * s * s).addScaledVector(b, 3 * s * s * t).addScaledVector(c, 3 * s * t * t).addScaledVector(d, t * t * t));
    }
  }
  if (n) places.push(knots[closed ? 0 : n - 1]!.at);
  return places;
}
