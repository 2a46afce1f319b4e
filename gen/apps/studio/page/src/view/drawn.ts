import { Box3, BufferGeometry, DoubleSide, FrontSide, GLSL3, InstancedBufferGeometry, Mesh, RawShaderMaterial, Vector3, Vector4, type IUniform } from "three";
import type { Pictures } from "./pictures";
import type { Shared } from "./shared";
import { enlarged, everyOf, firstOf } from "./thinning";

export interface Shaders {
  vertex: string;
  look: string;
  flat: string;
}

/** What making a part needs from the view. */
export interface Studio {
  shared: Shared;
  pictures: Pictures;
}

type Defines = Record<string, number>;
type Uniforms = Record<string, IUniform>;

/** A shape of a thing. Where it is drawn many times, `geometry` is instanced: `bundle` of it in each. */
export interface Level {
  /** Metres of what it loses: it serves where that is a few pixels. */
  size: number;
  geometry: BufferGeometry;
  bundle: number;
  defines: Defines;
  uniforms: Uniforms;
  bothSides: boolean;
}

/** Materials over one set of uniforms, by what they are for; made when they are first needed. */
class Dress {
  private worn = new Map<string, RawShaderMaterial>();

  constructor(
    readonly level: Level,
    private shaders: Shaders,
    private uniforms: Uniforms,
  ) {}

  material(flat: boolean, quickly: boolean): RawShaderMaterial {
    const name = flat ? "flat" : quickly ? "quick" : "fine";
    const known = this.worn.get(name);
    if (known) return known;
    const made = new RawShaderMaterial({
      vertexShader: this.shaders.vertex,
      fragmentShader: flat ? this.shaders.flat : this.shaders.look,
      defines: name === "quick" ? { ...this.level.defines, QUICK: 1 } : this.level.defines,
      uniforms: this.uniforms,
      glslVersion: GLSL3,
      side: this.level.bothSides ? DoubleSide : FrontSide,
    });
    this.worn.set(name, made);
    return made;
  }

  dispose(): void {
    this.level.geometry.setIndex(null); // bundles share theirs
    this.level.geometry.dispose();
    for (const material of this.worn.values()) material.dispose();
  }
}

/** One thing that the view draws, as finely as it has to be. */
export class Drawn extends Mesh<BufferGeometry, RawShaderMaterial> {
  private dresses: Dress[];
  readonly uniforms: Uniforms;
  /** How many there are, for one that is drawn many times. */
  count: number;
  /** Where the nearest of it is from an eye, in metres. */
  distance: (x: number, y: number, z: number) => number = () => 0;
  /** Whether it throws a shadow. */
  casts = true;
  isGround = false;
  private level = 0;
  private share = 1;

  /** The finest of `levels` comes first. `thinning`: where a share has to stand for all, "first" draws the first of them,
   *  "every" each so manyth and larger. */
  constructor(
    levels: Level[],
    shaders: Shaders,
    own: Uniforms,
    studio: Studio,
    count = 1,
    private thinning: "none" | "first" | "every" = "none",
  ) {
    const uniforms = {
      ...studio.shared,
      number: { value: new Vector4() },
      organism: { value: 0 },
      count: { value: count },
      every: { value: 1 },
      enlarged: { value: 1 },
      ...own,
    };
    const dresses = levels.map((level) => new Dress(level, shaders, { ...uniforms, ...level.uniforms }));
    super(levels[0]!.geometry, dresses[0]!.material(false, false));
    this.dresses = dresses;
    this.uniforms = uniforms;
    this.count = count;
    this.frustumCulled = false;
    this.matrixAutoUpdate = false;
  }

  get instanced(): boolean {
    return this.geometry instanceof InstancedBufferGeometry;
  }

  /** Takes the coarsest level that loses nothing larger than `grain` metres; answers what it costs, in triangles. */
  choose(grain: number): number {
    this.level = this.dresses.length - 1;
    while (this.level > 0 && this.dresses[this.level]!.level.size > grain) --this.level;
    return this.triangles;
  }

  /** Lets a share, 0..1, stand for all where there are many. */
  thin(share: number): void {
    this.share = share;
  }

  /** Whether a share may stand for all. */
  get thinned(): boolean {
    return this.thinning !== "none";
  }

  /** Of the level that was chosen. */
  get triangles(): number {
    const { geometry, bundle } = this.dresses[this.level]!.level;
    return (this.count * geometry.index!.count) / (3 * bundle);
  }

  wear(flat: boolean, quickly: boolean): void {
    const dress = this.dresses[this.level]!;
    this.geometry = dress.level.geometry;
    this.material = dress.material(flat, quickly);
    if (this.thinning === "none") return;
    const every = this.thinning === "every" ? everyOf(this.count, this.share) : 1;
    const drawn = this.thinning === "first" ? firstOf(this.count, this.share) : Math.ceil(this.count / every);
    this.uniforms.every!.value = every;
    this.uniforms.enlarged!.value = enlarged(every);
    this.uniforms.count!.value = this.thinning === "first" ? drawn : this.count;
    const geometry = this.geometry as InstancedBufferGeometry;
    const { bundle } = dress.level;
    geometry.instanceCount = Math.ceil(drawn / bundle);
    geometry.setDrawRange(0, drawn < bundle ? (drawn * geometry.index!.count) / bundle : Infinity);
  }

  /** What is read where a person clicks: `number`, from 1; white in a mask where it is an organism. */
  identify(number: number, organism: boolean): void {
    const byte = (shift: number): number => ((number >> shift) & 255) / 255;
    (this.uniforms.number!.value as Vector4).set(byte(0), byte(8), byte(16), 1);
    this.uniforms.organism!.value = organism ? 1 : 0;
  }

  dispose(): void {
    for (const uniform of Object.values(this.uniforms)) if (ownTextures.has(uniform.value as object)) (uniform.value as { dispose(): void }).dispose();
    for (const dress of this.dresses) dress.dispose();
  }
}

/** How far an eye is from the box of points, of which each `stride` numbers begin with one. */
export function distanceToBox(points: Float32Array, stride: number): Drawn["distance"] {
  const box = new Box3();
  const corner = new Vector3();
  for (let i = 0; i < points.length; i += stride) box.expandByPoint(corner.fromArray(points, i));
  return (x, y, z) => box.distanceToPoint(corner.set(x, y, z));
}

const ownTextures = new WeakSet<object>();

/** Marks a texture as one drawn thing's own: it goes with it. */
export function owned<T extends object>(texture: T): T {
  ownTextures.add(texture);
  return texture;
}
