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
  return smooth ? slope(knots, i, closed).multiplyScalar(way === "out" ? 1 : -1) : null;
}

/** A third of the slope from the point before to the one after (Catmull and Rom 1974). */
export function slope(knots: readonly Knot[], i: number, closed: boolean): Vector3 {
  const n = knots.length;
  const near = (k: number): Vector3 => knots[closed ? (k + n) % n : Math.min(n - 1, Math.max(0, k))]!.at;
  return near(i + 1).clone().sub(near(i - 1)).divideScalar(6);
}

/** Places along a line, as gen/core/spline.h has them. */
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
