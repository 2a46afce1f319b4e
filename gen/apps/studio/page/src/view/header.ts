/** What stands at the head of each picture of the model that the server sends: see decode.ts for the bytes. */

export type Vec3 = [number, number, number];

/** `n` elements of type `t`, `at` so many bytes after the end of the header. */
export interface BlobRef {
  at: number;
  n: number;
  t: "f32" | "u32" | "i8" | "u8";
}

/** Pictures of a material that repeat every `wide` and `high` metres, laid on meshes from three sides and on branches along
 *  them, or, `unrolled`, where `uv` says. `light` is a linear factor of their colours; `varied`: these are factors of what is
 *  there without them. */
export interface Tile {
  colors: string;
  normals?: string;
  wide: number;
  high: number;
  light: Vec3;
  varied?: boolean;
  unrolled?: boolean;
}

/** Colours of materials are sRGB, 0..1. */
export interface Material {
  color: Vec3;
  gloss: number;
  both_sides: boolean;
  picture?: string;
  tile?: Tile;
  /** On stone that wears a tile: how much of it is overgrown, 0..1, and metres, the scale of its patterns. */
  moss?: { share: number; scale: number };
  light_through?: number;
  /** Of panes; absent: 1. */
  opacity?: number;
}

/** The corners of a mesh; `colors` (sRGB bytes) stand in place of the material's. */
export interface Surface {
  position: BlobRef;
  normal: BlobRef;
  uv?: BlobRef;
  index: BlobRef;
  material: Material;
  colors?: BlobRef;
}

interface PartBase {
  /** Stands for the content. A part that the page said it has comes without blobs. */
  id: string;
  /** The organism it belongs to, -1: none. */
  entry: number;
  specimen: number;
}

export interface TubesPart extends PartBase {
  kind: "tubes";
  segments?: BlobRef;
  gloss: number;
  tile?: Tile;
}

export interface MeshPart extends PartBase, Partial<Surface> {
  kind: "mesh" | "ground";
  instances?: BlobRef;
  instance_colors?: BlobRef;
  /** Meshes that serve in its place where `size` metres are a few pixels. */
  coarse?: (Omit<Surface, "material"> & { size: number })[];
}

export interface CopiesPart extends PartBase {
  kind: "copies";
  model: number;
  levels?: { grain: number; parts: Surface[] }[];
  instances?: BlobRef;
  tints?: BlobRef;
}

export type Part = TubesPart | MeshPart | CopiesPart;

/** Colours of light are linear. `sun` points towards it; `sunlight` is what it gives to what faces it; `fill` is for all
 *  that the view does not trace. `backdrop` rises: `height` is the sine of the angle above the horizon. */
export interface Light {
  sun: Vec3;
  sunlight: Vec3;
  fill: { above: Vec3; aside: Vec3; below: Vec3; eye: Vec3 };
  backdrop: { height: number; light: Vec3 }[];
  fog: { color: Vec3; distance: number };
}

export interface Header {
  time: number;
  film: { frames: number; fps: number; size: [number, number]; seconds: number };
  nodes: number;
  copies: number;
  seconds: { grow: number; pack: number };
  regrown: number[];
  /** Organisms that were left out, in haste; `coarse`: those that were asked for are rough. */
  missing: number[];
  coarse: boolean;
  notes: string[];
  /** `way`: where it stands at moments over the film; empty where it does not move. */
  camera: { at: Vec3; to: Vec3; angle: number; way: Vec3[] };
  light: Light;
  /** A picture of the sky all around, of its upper half, north in the middle; empty: none. */
  sky: string;
  setting: string;
  /** Metres, side of the square about the middle on which plants are sown. */
  land: number;
  entries: { name: string; kind: string; specimens: number; copies: number; low: Vec3; high: Vec3 }[];
  /** `placed`: which place of the entry's place.at put it there, null: scattered; `turn` (x y z w) and `size`: how what grew
   *  upright at the origin stands there. */
  specimens: { entry: number; foot: Vec3; placed: number | null; turn: [number, number, number, number]; size: number }[];
  food: Vec3[];
  parts: Part[];
}
