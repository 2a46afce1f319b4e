import { BufferGeometry, Color, DoubleSide, FrontSide, GLSL3, Mesh, RawShaderMaterial, Vector4, type IUniform } from "three";
import type { LeafPictures } from "./leaf_pictures";
import type { Shared } from "./shared";

export interface Shaders {
  vertex: string;
  look: string;
  flat: string;
}

/** What making a part needs from the view. */
export interface Studio {
  /** Whether there is no graphics card. */
  slow: boolean;
  shared: Shared;
  leaves: LeafPictures;
}

/** Materials over one set of uniforms: as it looks, and flat, for shadows, picking and masks. */
interface Dress {
  geometry: BufferGeometry;
  look: RawShaderMaterial;
  flat: RawShaderMaterial;
}

type Defines = Record<string, number>;
type Uniforms = Record<string, IUniform>;

/** One thing that the view draws: finely, or quickly while something moves. */
export class Drawn extends Mesh<BufferGeometry, RawShaderMaterial> {
  private fine: Dress;
  private quick: Dress | null = null;
  readonly uniforms: Uniforms;
  /** Whether it throws a shadow. */
  casts = true;
  isGround = false;
  /** About how many triangles it costs where it is drawn quickly. */
  triangles = 0;

  constructor(
    geometry: BufferGeometry,
    private shaders: Shaders,
    readonly defines: Defines,
    own: Uniforms,
    studio: Studio,
    bothSides: boolean,
  ) {
    const uniforms = { ...studio.shared, highlight: { value: new Color(0, 0, 0) }, number: { value: new Vector4() }, organism: { value: 0 }, ...own };
    const fine = dress(geometry, shaders, defines, uniforms, bothSides);
    super(geometry, fine.look);
    this.fine = fine;
    this.uniforms = uniforms;
    if (studio.slow) this.quickly(geometry, defines, bothSides);
    this.frustumCulled = false;
    this.matrixAutoUpdate = false;
  }

  /** Another geometry for when it has to be quick. */
  quickly(geometry: BufferGeometry, defines: Defines, bothSides: boolean): void {
    this.quick = dress(geometry, this.shaders, { ...defines, QUICK: 1 }, this.uniforms, bothSides);
  }

  wear(flat: boolean, quickly: boolean): void {
    const worn = (quickly && this.quick) || this.fine;
    this.geometry = worn.geometry;
    this.material = flat ? worn.flat : worn.look;
  }

  /** What is read where a person clicks: `number`, from 1; white in a mask where it is an organism. */
  identify(number: number, organism: boolean): void {
    const byte = (shift: number): number => ((number >> shift) & 255) / 255;
    (this.uniforms.number!.value as Vector4).set(byte(0), byte(8), byte(16), 1);
    this.uniforms.organism!.value = organism ? 1 : 0;
  }

  highlight(strength: number): void {
    (this.uniforms.highlight!.value as Color).setRGB(0.25, 0.45, 1).multiplyScalar(strength);
  }

  dispose(): void {
    for (const uniform of Object.values(this.uniforms)) if (ownTextures.has(uniform.value as object)) (uniform.value as { dispose(): void }).dispose();
    for (const { geometry, look, flat } of this.quick ? [this.fine, this.quick] : [this.fine]) {
      geometry.setIndex(null); // bundles share theirs
      geometry.dispose();
      look.dispose();
      flat.dispose();
    }
  }
}

function dress(geometry: BufferGeometry, shaders: Shaders, defines: Defines, uniforms: Uniforms, bothSides: boolean): Dress {
  const made = (fragmentShader: string): RawShaderMaterial =>
    new RawShaderMaterial({
      vertexShader: shaders.vertex,
      fragmentShader,
      defines,
      uniforms,
      glslVersion: GLSL3,
      side: bothSides ? DoubleSide : FrontSide,
    });
  return { geometry, look: made(shaders.look), flat: made(shaders.flat) };
}

const ownTextures = new WeakSet<object>();

/** Marks a texture as one drawn thing's own: it goes with it. */
export function owned<T extends object>(texture: T): T {
  ownTextures.add(texture);
  return texture;
}
