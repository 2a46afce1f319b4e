import { BufferAttribute, InstancedBufferGeometry } from "three";
import type { TubesPart } from "./header";
import { Drawn, type Studio } from "./drawn";
import { bytes, type Packet } from "./packet";
import { PER_ROW, segmentsTexture } from "./texels";
import { TUBES_FLAT, TUBES_LOOK, TUBES_VERTEX } from "./tubes.glsl";

const SEGMENT_BYTES = 48;
/** Tubes in one bundle; bundles are drawn as instances. */
const BUNDLE = 512;

/** How many corners a ring has where there are so many segments; 2: ribbons that face the eye. */
function columnsFor(segments: number, slow: boolean): { fine: number; quick: number } {
  if (slow) return { fine: segments <= 100_000 ? 8 : segments <= 250_000 ? 4 : 2, quick: segments <= 3000 ? 6 : 2 };
  return { fine: segments <= 100_000 ? 8 : 6, quick: segments <= 60_000 ? 8 : segments <= 200_000 ? 6 : 2 };
}

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

function geometryOf(count: number, columns: number): InstancedBufferGeometry {
  const index = bundle(columns);
  const geometry = new InstancedBufferGeometry();
  geometry.setIndex(index);
  geometry.instanceCount = Math.ceil(count / BUNDLE);
  if (count < BUNDLE) geometry.setDrawRange(0, (count * index.count) / BUNDLE);
  return geometry;
}

function definesOf(columns: number): Record<string, number> {
  return { COLUMNS: columns, BUNDLE, PER_ROW, ...(columns === 2 ? { RIBBON: 1 } : {}) };
}

/** The branches of an organism. `all`: segments in the whole picture. */
export function tubes(packet: Packet, part: TubesPart, studio: Studio, all: number): Drawn | null {
  if (!part.segments || part.segments.n < SEGMENT_BYTES) return null;
  const data = bytes(packet, part.segments);
  const count = data.length / SEGMENT_BYTES;
  const { fine, quick } = columnsFor(all, studio.slow);
  const made = new Drawn(
    geometryOf(count, fine),
    { vertex: TUBES_VERTEX, look: TUBES_LOOK, flat: TUBES_FLAT },
    definesOf(fine),
    {
      segments: { value: segmentsTexture(new Uint32Array(data.buffer, data.byteOffset, data.length / 4)) },
      count: { value: count },
      gloss: { value: part.gloss },
    },
    studio,
    fine === 2,
  );
  if (quick !== fine) made.quickly(geometryOf(count, quick), definesOf(quick), quick === 2);
  made.triangles = count * (quick === 2 ? 2 : 2 * quick);
  return made;
}
