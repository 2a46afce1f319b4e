import { AddEquation, BufferAttribute, BufferGeometry, CustomBlending, DepthTexture, GLSL3, HalfFloatType, Mesh, OneFactor, PerspectiveCamera, RawShaderMaterial, Scene, UnsignedIntType, Vector2, WebGLRenderTarget, type WebGLRenderer } from "three";
import { COLOR } from "./glsl";

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }
`;
const ADD = /* glsl */ `${COLOR}
uniform sampler2D one;
out vec4 picture;
void main() { picture = vec4(linear(texelFetch(one, ivec2(gl_FragCoord.xy), 0).rgb), 1.0); }
`;
const SHOW = /* glsl */ `${COLOR}
uniform sampler2D one;
out vec4 picture;
void main() {
  vec4 sum = texelFetch(one, ivec2(gl_FragCoord.xy), 0);
  picture = vec4(shown(sum.rgb / sum.a), 1.0);
}
`;

const ENLARGE = /* glsl */ `
precision mediump float;
uniform sampler2D one;
uniform vec2 whole;
out vec4 picture;
void main() { picture = vec4(texture(one, gl_FragCoord.xy / whole).rgb, 1.0); }
`;

/** Pictures that are shown by way of others: one of fewer pixels, enlarged, for machines that are slow; and, at rest, the
 *  mean of some. When nothing moves the picture is drawn a few times more, each a part of a pixel beside the others, and what is seen
 *  is their mean: edges, thin branches and the rims of shadows become smooth on any machine. */
export class Settle {
  private one: WebGLRenderTarget;
  private small: WebGLRenderTarget;
  private whole = new Vector2();
  private enlarge: RawShaderMaterial;
  private sum: WebGLRenderTarget;
  private quad: Mesh<BufferGeometry, RawShaderMaterial>;
  private scene = new Scene();
  private camera = new PerspectiveCamera();
  private add: RawShaderMaterial;
  private show: RawShaderMaterial;
  /** Pictures so far. */
  count = 0;
  /** A small picture has so many times fewer pixels each way. */
  private smaller = 2;

  constructor(private renderer: WebGLRenderer) {
    this.one = new WebGLRenderTarget(1, 1, { generateMipmaps: false });
    this.one.depthTexture = new DepthTexture(1, 1, UnsignedIntType);
    this.small = new WebGLRenderTarget(1, 1, { generateMipmaps: false });
    this.sum = new WebGLRenderTarget(1, 1, { type: HalfFloatType, depthBuffer: false, generateMipmaps: false });
    const made = (fragmentShader: string, from: WebGLRenderTarget): RawShaderMaterial =>
      new RawShaderMaterial({ vertexShader: VERTEX, fragmentShader, uniforms: { one: { value: from.texture } }, glslVersion: GLSL3, depthTest: false, depthWrite: false });
    this.add = made(ADD, this.one);
    this.add.blending = CustomBlending;
    this.add.blendEquation = AddEquation;
    this.add.blendSrc = this.add.blendDst = OneFactor;
    this.show = made(SHOW, this.sum);
    this.enlarge = made(ENLARGE, this.small);
    this.enlarge.uniforms.whole = { value: this.whole };
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    this.quad = new Mesh(geometry, this.add);
    this.quad.frustumCulled = false;
    this.scene.add(this.quad);
  }

  resize(width: number, height: number): void {
    this.one.setSize(width, height);
    this.sum.setSize(width, height);
    this.whole.set(width, height);
    this.sizeSmall();
    this.count = 0;
  }

  private sizeSmall(): void {
    this.small.setSize(Math.ceil(this.whole.x / this.smaller), Math.ceil(this.whole.y / this.smaller));
  }

  /** Where picture `k` lies in a pixel, -0.5..0.5: the R2 sequence (Roberts 2018). */
  static shift(k: number): [number, number] {
    return [((0.5 + 0.7548776662 * k) % 1) - 0.5, ((0.5 + 0.5698402910 * k) % 1) - 0.5];
  }

  /** Shows what `draw` draws with so many times fewer pixels each way. */
  roughly(smaller: number, draw: () => void): void {
    if (smaller !== this.smaller) {
      this.smaller = smaller;
      this.sizeSmall();
    }
    this.renderer.setRenderTarget(this.small);
    draw();
    this.paint(null, this.enlarge);
  }

  /** Adds what `draw` draws and shows the mean of all. */
  step(draw: () => void): void {
    const { renderer } = this;
    renderer.setRenderTarget(this.one);
    draw();
    renderer.setRenderTarget(this.sum);
    if (this.count === 0) renderer.clear();
    this.paint(this.sum, this.add);
    this.paint(null, this.show);
    ++this.count;
  }

  private paint(target: WebGLRenderTarget | null, material: RawShaderMaterial): void {
    this.renderer.setRenderTarget(target);
    this.quad.material = material;
    this.renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.small.dispose();
    this.enlarge.dispose();
    this.one.depthTexture?.dispose();
    this.one.dispose();
    this.sum.dispose();
    this.add.dispose();
    this.show.dispose();
    this.quad.geometry.dispose();
  }
}
