/** A tree as meshes: its branches as tubes, all leaves where they are. */

import type { Tree } from "./engine";
import type { GlbPart } from "./glb";
import { tubesOf } from "./tubes";

const STRIDE = 13; // numbers of a segment and of an organ

/** The same triangles with each vertex once: six numbers a vertex, place and normal. */
function welded(shape: Float32Array): { vertices: number[]; corners: number[] } {
  const vertices: number[] = [], corners: number[] = [], known = new Map<string, number>();
  for (let i = 0; i < shape.length; i += 6) {
    const vertex = shape.subarray(i, i + 6), key = vertex.join();
    let at = known.get(key);
    if (at === undefined) {
      at = vertices.length / 6;
      known.set(key, at);
      vertices.push(...vertex);
    }
    corners.push(at);
  }
  return { vertices, corners };
}

/** All organs of one shape as one mesh. */
function organPart(name: string, shape: Float32Array, organs: Float32Array): GlbPart {
  const { vertices, corners } = welded(shape), each = vertices.length / 6, count = organs.length / STRIDE;
  const places = new Float32Array(3 * each * count), normals = new Float32Array(places.length), colors = new Float32Array(places.length);
  const all = new Uint32Array(corners.length * count);
  for (let o = 0; o < count; ++o) {
    const at = o * STRIDE, [qx, qy, qz, qw] = [organs[at + 3]!, organs[at + 4]!, organs[at + 5]!, organs[at + 6]!], size = organs[at + 7]!;
    for (let v = 0; v < each; ++v) {
      const to = 3 * (o * each + v);
      for (const [out, from, scale] of [[places, 0, size], [normals, 3, 1]] as const) {
        const [x, y, z] = [vertices[6 * v + from]!, vertices[6 * v + from + 1]!, vertices[6 * v + from + 2]!];
        // v + 2 q × (q × v + w v)
        const a = qy * z - qz * y + qw * x, b = qz * x - qx * z + qw * y, c = qx * y - qy * x + qw * z;
        const turned = [x + 2 * (qy * c - qz * b), y + 2 * (qz * a - qx * c), z + 2 * (qx * b - qy * a)];
        for (let k = 0; k < 3; ++k) out[to + k] = scale * turned[k]! + (from === 0 ? organs[at + k]! : 0);
      }
      // Of length 1, as files want them.
      const long = Math.hypot(normals[to]!, normals[to + 1]!, normals[to + 2]!) || 1;
      for (let k = 0; k < 3; ++k) {
        normals[to + k] = long === 1 && !normals.subarray(to, to + 3).some(Boolean) ? Number(k === 1) : normals[to + k]! / long;
        colors[to + k] = organs[at + 8 + k]!;
      }
    }
    for (let c = 0; c < corners.length; ++c) all[o * corners.length + c] = o * each + corners[c]!;
  }
  return { name, places, normals, colors, corners: all, leaf: true };
}

export const treeParts = (tree: Tree): GlbPart[] => [
  { ...tubesOf(tree.segments, STRIDE), name: "branches" },
  ...tree.shapes.map((shape, i) => organPart(i === 0 ? "leaves" : `organs-${i + 1}`, shape, tree.organs[i]!)),
];
