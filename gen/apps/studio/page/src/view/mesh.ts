import { BufferAttribute, BufferGeometry, InstancedBufferGeometry, Color, type DataTexture, type IUniform } from "three";
import type { Material, MeshPart, Surface } from "./header";
import { distanceToBox, Drawn, type Level, type Studio } from "./drawn";
import { MESH_FLAT, MESH_LOOK, MESH_VERTEX } from "./mesh.glsl";
import { bytes, floats, signedBytes, words, type Packet } from "./packet";
import { tiled } from "./pictures";
import { PER_ROW, paintsTexture, placesTexture } from "./texels";

/** Corners in a bundle of small meshes; bundles are drawn as instances. */
const BUNDLE_CORNERS = 4096;

export const SHADERS = { vertex: MESH_VERTEX, look: MESH_LOOK, flat: MESH_FLAT };

type Numbers = Float32Array | Int8Array | Uint8Array | Uint32Array;

/** The arrays of a mesh. */
export interface Shape {
  position: Float32Array;
  normal: Int8Array;
  index: Uint32Array;
  uv?: Float32Array;
  colors?: Uint8Array;
  /** From the origin to the farthest corner. */
  reach: number;
}

export function shapeOf(packet: Packet, from: Partial<Surface>): Shape | null {
  if (!from.position || !from.normal || !from.index || !from.index.n) return null;
  const position = floats(packet, from.position);
  let reach = 0;
  for (let i = 0; i < position.length; i += 3) reach = Math.max(reach, position[i]! ** 2 + position[i + 1]! ** 2 + position[i + 2]! ** 2);
  return {
    position,
    normal: signedBytes(packet, from.normal),
    index: words(packet, from.index),
    uv: from.uv && floats(packet, from.uv),
    colors: from.colors && bytes(packet, from.colors),
    reach: Math.sqrt(reach),
  };
}

/** Copies behind each other; index numbers are moved on by `step` a copy. */
function repeated<T extends Numbers>(data: T, times: number, step = 0): T {
  if (times === 1) return data;
  const all = new (data.constructor as new (length: number) => T)(data.length * times);
  for (let i = 0; i < times; ++i) all.set(data, i * data.length);
  if (step) for (let i = data.length; i < all.length; ++i) all[i]! += Math.floor(i / data.length) * step;
  return all;
}

function fill(geometry: BufferGeometry, shape: Shape, times: number): void {
  const attribute = (name: string, data: Numbers | undefined, size: number, normalized: boolean): void => {
    if (data) geometry.setAttribute(name, new BufferAttribute(repeated(data, times), size, normalized));
  };
  attribute("position", shape.position, 3, false);
  attribute("normal", shape.normal, 4, true);
  attribute("uv", shape.uv, 2, false);
  attribute("colors", shape.colors, 4, true);
  geometry.setIndex(new BufferAttribute(repeated(shape.index, times, shape.position.length / 3), 1));
}

function describe(shape: Shape, material: Material, studio: Studio): { defines: Record<string, number>; own: Record<string, IUniform> } {
  const picture = material.picture && shape.uv ? studio.pictures.leaf(material.picture) : null;
  const tile = material.tile && (shape.uv || !material.tile.unrolled) ? material.tile : null;
  if (!picture && !tile?.unrolled) delete shape.uv;
  const defines: Record<string, number> = { PER_ROW };
  if (picture) defines.WITH_UV = 1;
  if (tile) defines.TILED = 1;
  if (tile?.unrolled) defines.UNROLLED = 1;
  if (tile?.varied) defines.VARIED = 1;
  const moss = tile && !tile.unrolled ? material.moss : undefined;
  if (moss) defines.MOSSY = 1;
  if (shape.colors) defines.WITH_COLORS = 1;
  return {
    defines,
    own: {
      plain: { value: new Color().fromArray(material.color) },
      gloss: { value: material.gloss },
      through: { value: material.light_through ?? 0 },
      opacity: { value: material.opacity ?? 1 },
      rough: { value: 0 },
      paint_shown: { value: 0 },
      ...(picture ? { leaf: { value: picture } } : {}),
      ...(tile ? tiled(tile, studio.pictures) : {}),
      ...(moss ? { moss: { value: moss.share }, moss_scale: { value: moss.scale } } : {}),
    },
  };
}

/** A mesh that stands where it is. */
export function still(shape: Shape, material: Material, studio: Studio): Drawn {
  const { defines, own } = describe(shape, material, studio);
  const geometry = new BufferGeometry();
  fill(geometry, shape, 1);
  return new Drawn([{ size: 0, geometry, bundle: 1, defines, uniforms: {}, bothSides: material.both_sides }], SHADERS, own, studio);
}

/** Where copies of a mesh are, and how they are coloured. */
export interface Places {
  count: number;
  texture: DataTexture;
  paints: DataTexture | null;
  /** Whether `paints` multiply (128 for 1) or replace. */
  tint: boolean;
}

export const placesOf = (data: Float32Array, paints: Uint8Array | null, tint: boolean): Places => ({
  count: data.length / 10,
  texture: placesTexture(data),
  paints: paints && paintsTexture(paints),
  tint,
});

/** Copies of a mesh, and the coarser meshes that serve for it; with `order` only those that are listed in it. */
export function placed(shapes: { shape: Shape; size: number }[], material: Material, places: Places, studio: Studio, order?: DataTexture): Drawn {
  const shared: Record<string, number> = { INSTANCED: 1 };
  if (places.paints) shared.INSTANCE_COLORS = 1;
  if (order) Object.assign(shared, { ORDERED: 1, ORDER_ROW: PER_ROW });
  let own: Record<string, IUniform> = {};
  const levels = shapes.map(({ shape, size }): Level => {
    const described = describe(shape, material, studio);
    own = { ...described.own, ...own };
    const corners = shape.position.length / 3;
    const bundle = Math.max(1, Math.min(Math.floor(BUNDLE_CORNERS / corners), places.count));
    const geometry = new InstancedBufferGeometry();
    fill(geometry, shape, bundle);
    const uniforms = { corners: { value: corners }, reach: { value: shape.reach } };
    return { size, geometry, bundle, defines: { ...described.defines, ...shared, BUNDLE: bundle }, uniforms, bothSides: material.both_sides };
  });
  Object.assign(own, {
    places: { value: places.texture },
    paints: { value: places.paints },
    tint: { value: places.tint ? 1 : 0 },
    ...(order ? { order: { value: order } } : {}),
  });
  return new Drawn(levels, SHADERS, own, studio, places.count, "every");
}

/** What stands, with its instances where it has any. */
export function mesh(packet: Packet, part: MeshPart, studio: Studio): Drawn | null {
  const shape = shapeOf(packet, part);
  if (!shape || !part.material) return null;
  if (!part.instances) return still(shape, part.material, studio);
  const paints = part.instance_colors ? bytes(packet, part.instance_colors) : null;
  const at = floats(packet, part.instances);
  const shapes = [{ shape, size: 0 }];
  for (const coarse of part.coarse ?? []) {
    const shape = shapeOf(packet, coarse);
    if (shape) shapes.push({ shape, size: coarse.size });
  }
  const made = placed(shapes, part.material, placesOf(at, paints, false), studio);
  made.distance = distanceToBox(at, 10);
  return made;
}
