import { BufferAttribute, InstancedBufferGeometry } from "three";
import type { TubesPart } from "./header";
import { distanceToBox, Drawn, type Level, type Studio } from "./drawn";
import { bytes, type Packet } from "./packet";
import { tiled } from "./pictures";
import { PER_ROW, segmentsTexture } from "./texels";
import { TUBES_FLAT, TUBES_LOOK, TUBES_VERTEX } from "./tubes.glsl";

const SEGMENT_BYTES = 48;
/** Tubes in one bundle; bundles are drawn as instances. */
const BUNDLE = 512;

const bundles = new Map<number, BufferAttribute>();

/** Triangles of a bundle of tubes; corner 2j + end. */
function bundle(columns: number): BufferAttribute {
  const known = bundles.get(columns);
  if (known) return known;
  const faces = columns === 2 ? 1 : columns;
  const index = new Uint16Array(BUNDLE * faces * 6);
  let at = 0;
  for (let tube = 0; tube < BUNDLE; ++tube)
    for (let face = 0; face < faces; ++face) {
      const near = 2 * (tube * columns + face);
      const far = 2 * (tube * columns + ((face + 1) % columns));
      for (const corner of [near, near + 1, far, far, near + 1, far + 1]) index[at++] = corner;
    }
  const made = new BufferAttribute(index, 1);
  bundles.set(columns, made);
  return made;
}

/** Corners of a ring, and how many radii of a branch may be a few pixels where so few serve; two: ribbons that face the
 *  eye. */
const RINGS: readonly [columns: number, radii: number][] = [
  [8, 0],
  [4, 1.2],
  [2, 2.5],
];

function level(columns: number, size: number, more: Record<string, number>): Level {
  const geometry = new InstancedBufferGeometry();
  geometry.setIndex(bundle(columns));
  const defines = { COLUMNS: columns, BUNDLE, PER_ROW, ...(columns === 2 ? { RIBBON: 1 } : {}), ...more };
  return { size, geometry, bundle: BUNDLE, defines, uniforms: {}, bothSides: columns === 2 };
}

/** The branches of an organism. */
export function tubes(packet: Packet, part: TubesPart, studio: Studio): Drawn | null {
  if (!part.segments || part.segments.n < SEGMENT_BYTES) return null;
  const data = bytes(packet, part.segments);
  const count = data.length / SEGMENT_BYTES;
  const words = new Uint32Array(data.buffer, data.byteOffset, data.length / 4);
  const numbers = new Float32Array(data.buffer, data.byteOffset, data.length / 4);
  // The largest come first: the radius of one that is large, but not of the largest.
  const typical = numbers[12 * Math.floor(count / 20) + 3]!;
  const tile = part.tile && tiled(part.tile, studio.pictures);
  const own = { segments: { value: segmentsTexture(words) }, gloss: { value: part.gloss }, ...tile };
  const levels = RINGS.map(([columns, radii]) => level(columns, radii * typical, tile ? { TILED: 1 } : {}));
  const made = new Drawn(levels, { vertex: TUBES_VERTEX, look: TUBES_LOOK, flat: TUBES_FLAT }, own, studio, count, "first");
  made.distance = distanceToBox(numbers, 12);
  return made;
}
