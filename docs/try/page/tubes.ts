/** Branches as meshes: segments that follow each other become one tube. */

import type { Vec } from "./shapes";

/** Triangles by indices; numbers of all vertices one after another. */
export interface Mesh {
  places: Float32Array;
  normals: Float32Array;
  /** sRGB, three numbers each. */
  colors: Float32Array;
  corners: Uint32Array;
  /** Of each vertex the segment that it is of. */
  from: Uint32Array;
}

const FEWEST = 3, MOST = 12; // sides of a tube

/** Numbers as they come, in an array that grows. */
class Numbers {
  private all: Float32Array = new Float32Array(1 << 14);
  size = 0;
  add(...numbers: number[]): void {
    if (this.size + numbers.length > this.all.length) {
      const larger = new Float32Array(2 * this.all.length);
      larger.set(this.all);
      this.all = larger;
    }
    this.all.set(numbers, this.size);
    this.size += numbers.length;
  }
  get taken(): Float32Array {
    return this.all.slice(0, this.size);
  }
}

const sub = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
function unit(v: Vec, otherwise: Vec): Vec {
  const size = Math.hypot(...v);
  return size > 1e-12 ? [v[0] / size, v[1] / size, v[2] / size] : otherwise;
}

/** Segments of `stride` numbers each, that begin with x, y, z and radius of both ends and the colour. */
export function tubesOf(segments: Float32Array, stride: number): Mesh {
  const places = new Numbers(), normals = new Numbers(), colors = new Numbers(), corners: number[] = [], from: number[] = [];
  const count = segments.length / stride;
  const foot = (i: number): Vec => [segments[i * stride]!, segments[i * stride + 1]!, segments[i * stride + 2]!];
  const tip = (i: number): Vec => [segments[i * stride + 4]!, segments[i * stride + 5]!, segments[i * stride + 6]!];
  const follows = (i: number): boolean => i > 0 && foot(i).every((x, k) => x === tip(i - 1)[k]);
  const way = (i: number): Vec => unit(sub(tip(i), foot(i)), [0, 1, 0]);
  let thickest = 0;
  for (let i = 0; i < count; ++i) thickest = Math.max(thickest, segments[i * stride + 3]!);

  const vertex = (at: Vec, normal: Vec, i: number): number => {
    places.add(...at);
    normals.add(...normal);
    colors.add(segments[i * stride + 8]!, segments[i * stride + 9]!, segments[i * stride + 10]!);
    return from.push(i) - 1;
  };
  /** A ring across `axis`, and which way its first side faces, kept from ring to ring. */
  const ring = (at: Vec, axis: Vec, side: Vec, radius: number, sides: number, i: number): { first: number; side: Vec } => {
    const x = unit(sub(side, axis.map((a) => a * dot(side, axis)) as Vec), unit(cross(axis, [0.31, 0.2, 0.93]), [1, 0, 0]));
    const y = cross(axis, x);
    const first = from.length;
    for (let k = 0; k < sides; ++k) {
      const [c, s] = [Math.cos((2 * Math.PI * k) / sides), Math.sin((2 * Math.PI * k) / sides)];
      const out: Vec = [x[0] * c + y[0] * s, x[1] * c + y[1] * s, x[2] * c + y[2] * s];
      vertex([at[0] + out[0] * radius, at[1] + out[1] * radius, at[2] + out[2] * radius], out, i);
    }
    return { first, side: x };
  };
  const join = (a: number, b: number, sides: number): void => {
    for (let k = 0; k < sides; ++k) {
      const next = (k + 1) % sides;
      corners.push(a + k, a + next, b + k, a + next, b + next, b + k);
    }
  };
  const cap = (at: Vec, normal: Vec, first: number, sides: number, i: number): void => {
    const top = vertex(at, normal, i);
    for (let k = 0; k < sides; ++k) corners.push(first + k, first + ((k + 1) % sides), top);
  };
  const ball = (i: number): void => {
    const middle = foot(i), radius = segments[i * stride + 3]!, sides = 10, rows = 6;
    let last = -1;
    for (let row = 0; row <= rows; ++row) {
      const up = (Math.PI * row) / rows - Math.PI / 2, first = from.length;
      for (let k = 0; k < sides; ++k) {
        const out: Vec = [Math.cos(up) * Math.cos((2 * Math.PI * k) / sides), Math.sin(up), -Math.cos(up) * Math.sin((2 * Math.PI * k) / sides)];
        vertex([middle[0] + radius * out[0], middle[1] + radius * out[1], middle[2] + radius * out[2]], out, i);
      }
      if (last >= 0) join(last, first, sides);
      last = first;
    }
  };

  let sides = FEWEST, last = -1, side: Vec = [1, 0, 0];
  for (let i = 0; i < count; ++i) {
    const [a, b] = [segments[i * stride + 3]!, segments[i * stride + 7]!];
    if (Math.hypot(...sub(tip(i), foot(i))) < 1e-9) {
      ball(i);
      last = -1;
      continue;
    }
    const along = way(i);
    if (last < 0 || !follows(i)) {
      sides = Math.round(FEWEST + (MOST - FEWEST) * Math.sqrt(a / (thickest || 1)));
      ({ first: last, side } = ring(foot(i), along, side, a, sides, i));
    }
    const goesOn = i + 1 < count && follows(i + 1);
    const next = goesOn ? way(i + 1) : along;
    const axis = unit([along[0] + next[0], along[1] + next[1], along[2] + next[2]], along);
    const ended = ring(tip(i), axis, side, b, sides, i);
    join(last, ended.first, sides);
    ({ first: last, side } = ended);
    if (goesOn) continue;
    // Rounded: a narrower ring and a point.
    const at = tip(i), near = [at[0] + along[0] * 0.7 * b, at[1] + along[1] * 0.7 * b, at[2] + along[2] * 0.7 * b] as Vec;
    const narrow = ring(near, along, side, 0.7 * b, sides, i);
    join(last, narrow.first, sides);
    cap([at[0] + along[0] * b, at[1] + along[1] * b, at[2] + along[2] * b], along, narrow.first, sides, i);
    last = -1;
  }
  return { places: places.taken, normals: normals.taken, colors: colors.taken, corners: new Uint32Array(corners), from: new Uint32Array(from) };
}

/** Loose triangles, six numbers a corner: place and colour. */
export function trianglesOf(loose: Float32Array): Mesh {
  const count = loose.length / 6;
  const places = new Float32Array(3 * count), colors = new Float32Array(3 * count), normals = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) {
    places.set(loose.subarray(6 * i, 6 * i + 3), 3 * i);
    colors.set(loose.subarray(6 * i + 3, 6 * i + 6), 3 * i);
  }
  const at = (i: number): Vec => [places[3 * i]!, places[3 * i + 1]!, places[3 * i + 2]!];
  for (let i = 0; i + 2 < count; i += 3) {
    const normal = unit(cross(sub(at(i + 1), at(i)), sub(at(i + 2), at(i))), [0, 0, 1]);
    for (let k = 0; k < 3; ++k) normals.set(normal, 3 * (i + k));
  }
  const corners = Uint32Array.from({ length: count }, (_, i) => i);
  return { places, normals, colors, corners, from: corners };
}
