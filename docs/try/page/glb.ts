/** What is seen as a GLB file: meshes with colours at their vertices (glTF 2.0). */

import type { Mesh } from "./tubes";

export interface GlbPart extends Omit<Mesh, "from"> {
  name: string;
  /** To be seen from both sides, as leaves are. */
  leaf?: boolean;
  /** 0 matt .. 1 polished. */
  gloss?: number;
}

const FLOAT = 5126, SHORT = 5123, INDEX = 5125;

/** sRGB as linear light, in 16 bits, with opacity. */
function linear(colors: Float32Array): Uint16Array {
  const out = new Uint16Array((colors.length / 3) * 4).fill(65535);
  for (let i = 0; i < colors.length; ++i) {
    const c = Math.min(1, Math.max(0, colors[i]!));
    out[4 * Math.floor(i / 3) + (i % 3)] = Math.round(65535 * (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  }
  return out;
}

function reach(places: Float32Array): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity], max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < places.length; ++i) {
    min[i % 3] = Math.min(min[i % 3]!, places[i]!);
    max[i % 3] = Math.max(max[i % 3]!, places[i]!);
  }
  return { min, max };
}

export function glbOf(title: string, all: GlbPart[]): Blob {
  const parts = all.filter((part) => part.corners.length > 0);
  const bytes: BlobPart[] = [], views: object[] = [], accessors: object[] = [];
  let size = 0;
  const add = (numbers: Float32Array | Uint16Array | Uint32Array, target: number, accessor: object): number => {
    views.push({ buffer: 0, byteOffset: size, byteLength: numbers.byteLength, target });
    bytes.push(numbers as Float32Array<ArrayBuffer>);
    size += numbers.byteLength;  // each is whole words
    return accessors.push({ bufferView: views.length - 1, ...accessor }) - 1;
  };
  const meshes = parts.map((part, material) => {
    const count = part.places.length / 3;
    const attributes = {
      POSITION: add(part.places, 34962, { componentType: FLOAT, count, type: "VEC3", ...reach(part.places) }),
      NORMAL: add(part.normals, 34962, { componentType: FLOAT, count, type: "VEC3" }),
      COLOR_0: add(linear(part.colors), 34962, { componentType: SHORT, normalized: true, count, type: "VEC4" }),
    };
    const indices = add(part.corners, 34963, { componentType: INDEX, count: part.corners.length, type: "SCALAR" });
    return { name: part.name, primitives: [{ attributes, indices, material }] };
  });
  const json = JSON.stringify({
    asset: { version: "2.0", generator: "Frond" },
    scene: 0,
    scenes: [{ name: title, nodes: parts.map((_, i) => i) }],
    nodes: parts.map(({ name }, mesh) => ({ name, mesh })),
    meshes,
    materials: parts.map(({ name, leaf, gloss }) => ({
      name,
      doubleSided: leaf === true,
      pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 1 - 0.6 * (gloss ?? 0) },
    })),
    accessors,
    bufferViews: views,
    buffers: [{ byteLength: size }],
  });
  const text = new TextEncoder().encode(json);
  const padded = new Uint8Array(Math.ceil(text.length / 4) * 4).fill(0x20);
  padded.set(text);
  const word = (...numbers: number[]): BlobPart => new Uint32Array(numbers);
  return new Blob([
    word(0x46546c67, 2, 12 + 8 + padded.length + 8 + size),
    word(padded.length, 0x4e4f534a), padded,
    word(size, 0x004e4942), ...bytes,
  ], { type: "model/gltf-binary" });
}
