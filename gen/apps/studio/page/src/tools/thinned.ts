import { Line3, Vector3 } from "three";

/** A line of fewer points that stays within a share of its length of what it was (Ramer 1972; Douglas and Peucker 1973). */
export function thinned(points: readonly Vector3[], share: number): Vector3[] {
  const whole = points.reduce((sum, p, i) => (i ? sum + p.distanceTo(points[i - 1]!) : 0), 0);
  const kept = new Set<number>();
  const split = (from: number, to: number): void => {
    kept.add(from).add(to);
    const chord = new Line3(points[from], points[to]);
    let far = share * whole;
    let at = -1;
    for (let i = from + 1; i < to; ++i) {
      const away = chord.closestPointToPoint(points[i]!, true, new Vector3()).distanceTo(points[i]!);
      if (away > far) [far, at] = [away, i];
    }
    if (at < 0) return;
    split(from, at);
    split(at, to);
  };
  if (points.length > 1) split(0, points.length - 1);
  return points.filter((_, i) => kept.has(i));
}
