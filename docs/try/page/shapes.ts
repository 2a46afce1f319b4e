/** A figure as what is drawn: rounded segments and triangles, with their colours. */

import type { Figure } from "./engine";

/** Colours by index, as in the SVG files of `frond turtle`. */
export const COLORS = [0x4a6b35, 0x6f9a3e, 0x8fbf4d, 0xc9b458, 0xb3763c, 0xa8455a, 0x7a5a9e, 0x3f7d9a];

export type Vec = [number, number, number];

export interface Shapes {
  /** Eleven numbers each: x, y, z and radius of both ends, colour. */
  segments: Float32Array;
  /** Six numbers a corner: place, colour. */
  corners: Float32Array;
  middle: Vec;
  /** Half the size of the box around everything, with what is thick at its sides. */
  half: Vec;
  /** Of the ball around the middle that holds everything, > 0. */
  radius: number;
  /** Whether everything lies in a plane of constant z. */
  flat: boolean;
}

function colorOf(index: number): Vec {
  const rgb = COLORS[((index % 8) + 8) % 8]!;
  return [(rgb >> 16) / 255, ((rgb >> 8) & 255) / 255, (rgb & 255) / 255];
}

const add = (a: Vec, b: Vec, times: number): Vec => [a[0] + b[0] * times, a[1] + b[1] * times, a[2] + b[2] * times];
const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** Half the outline of a leaf one unit long: along it and to the side. */
const LEAF: [number, number][] = [[0, 0], [0.1, 0.03], [0.25, 0.15], [0.45, 0.21], [0.7, 0.15], [1, 0]];
const FOLD = 0.35; // height of the rim, as a share of its distance from the midrib

/** The corners of a leaf, a fan on each side of its midrib, or of a disc across the heading. */
function organ(name: string, at: Vec, heading: Vec, left: Vec, scale: Vec): Vec[] {
  const up = cross(heading, left);
  const place = (along: number, side: number, height: number): Vec =>
    add(add(add(at, heading, along * scale[1]), left, side * scale[0]), up, height * scale[2]);
  if (name === "@o") {
    const rim = (i: number): Vec => add(add(at, left, (Math.cos(i * 0.3927) * scale[0]) / 2), up, (Math.sin(i * 0.3927) * scale[0]) / 2);
    return Array.from({ length: 16 }, (_, i) => [at, rim(i), rim(i + 1)]).flat();
  }
  return [1, -1].flatMap((side) =>
    LEAF.slice(1).flatMap(([along, wide], i) => {
      const [before, narrow] = LEAF[i]!;
      const a = place(before, 0, 0), b = place(along, 0, 0);
      const c = place(along, side * wide, FOLD * wide), d = place(before, side * narrow, FOLD * narrow);
      return [a, b, c, a, c, d];
    }));
}

/** Middle and extent of places. */
function measure(segments: number[], corners: number[]): Pick<Shapes, "middle" | "half" | "radius" | "flat"> {
  const low: Vec = [Infinity, Infinity, Infinity], high: Vec = [-Infinity, -Infinity, -Infinity];
  let thickest = 0;
  const reach = (from: number[], i: number): void => {
    for (let k = 0; k < 3; ++k) {
      low[k] = Math.min(low[k]!, from[i + k]!);
      high[k] = Math.max(high[k]!, from[i + k]!);
    }
  };
  for (let i = 0; i < segments.length; i += 11) {
    reach(segments, i);
    reach(segments, i + 4);
    thickest = Math.max(thickest, segments[i + 3]!, segments[i + 7]!);
  }
  for (let i = 0; i < corners.length; i += 6) reach(corners, i);
  if (low[0] > high[0]) return { middle: [0, 0, 0], half: [1, 1, 0], radius: 2, flat: true };
  const middle: Vec = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
  const half = low.map((least, k) => (high[k]! - least) / 2 + thickest) as Vec;
  return { middle, half, radius: Math.hypot(...half) || 1, flat: high[2] - low[2] < 1e-3 * Math.hypot(...half) };
}

export function shapesOf(figure: Omit<Figure, "errors" | "notes">): Shapes {
  const segments: number[] = [], corners: number[] = [];
  figure.segmentColors.forEach((color, i) => segments.push(...figure.segments.subarray(8 * i, 8 * i + 8), ...colorOf(color)));
  const corner = (at: ArrayLike<number>, color: Vec): number => corners.push(at[0]!, at[1]!, at[2]!, ...color);
  figure.triangleColors.forEach((index, i) => {
    const color = colorOf(index);
    for (let k = 0; k < 3; ++k) corner(figure.triangles.subarray(9 * i + 3 * k, 9 * i + 3 * k + 3), color);
  });
  figure.siteNames.forEach((name, i) => {
    const [at, heading, left, scale] = [0, 3, 6, 9].map((k) => [...figure.sites.subarray(12 * i + k, 12 * i + k + 3)] as Vec) as [Vec, Vec, Vec, Vec];
    const index = figure.siteColors[i]!;
    if (name === "@O") segments.push(...at, scale[0] / 2, ...at, scale[0] / 2, ...colorOf(index));
    else organ(name, at, heading, left, scale).forEach((place) => corner(place, colorOf(index + (name === "@o" ? 0 : 1))));
  });
  return { segments: new Float32Array(segments), corners: new Float32Array(corners), ...measure(segments, corners) };
}
