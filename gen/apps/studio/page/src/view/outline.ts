import { BufferAttribute, BufferGeometry, Color, GLSL3, LinearFilter, Mesh, PerspectiveCamera, RawShaderMaterial, Scene, Vector2, WebGLRenderTarget, type WebGLRenderer } from "three";

/** How many pixels wide the line is. */
const WIDE = 2;
const COLOR = 0xff9d2e;

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }
`;
const LINE = /* glsl */ `
precision mediump float;
uniform sampler2D mask;
uniform vec2 step;
uniform vec3 color;
out vec4 picture;
void main() {
  vec2 at = gl_FragCoord.xy * step, d = 0.7071 * WIDE * step;
  if (texture(mask, at).r > 0.5) discard;
  float near = max(max(max(texture(mask, at + d).r, texture(mask, at - d).r), max(texture(mask, at + vec2(d.x, -d.y)).r, texture(mask, at + vec2(-d.x, d.y)).r)),
                   max(max(texture(mask, at + vec2(WIDE * step.x, 0)).r, texture(mask, at - vec2(WIDE * step.x, 0)).r), max(texture(mask, at + vec2(0, WIDE * step.y)).r, texture(mask, at - vec2(0, WIDE * step.y)).r)));
  if (near < 0.25) discard;
  picture = vec4(color, near);
}
`;

/** A line round what is selected, wherever it is seen or hidden. */
export class Outline {
  private mask = new WebGLRenderTarget(1, 1, { generateMipmaps: false, minFilter: LinearFilter, magFilter: LinearFilter });
  private step = new Vector2(1, 1);
  private material: RawShaderMaterial;
  private quad: Mesh<BufferGeometry, RawShaderMaterial>;
  private scene = new Scene();
  private camera = new PerspectiveCamera();

  constructor(private renderer: WebGLRenderer) {
    this.material = new RawShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: LINE,
      defines: { WIDE: WIDE.toFixed(1) },
      uniforms: { mask: { value: this.mask.texture }, step: { value: this.step }, color: { value: new Color().setHex(COLOR, "srgb-linear") } },
      glslVersion: GLSL3,
      depthTest: false,
      depthWrite: false,
      transparent: true,
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    this.quad = new Mesh(geometry, this.material);
    this.quad.frustumCulled = false;
    this.scene.add(this.quad);
  }

  resize(width: number, height: number): void {
    this.mask.setSize(width, height);
    this.step.set(1 / width, 1 / height);
  }

  /** Takes what `draw` draws white on black. */
  take(draw: () => void): void {
    this.renderer.setRenderTarget(this.mask);
    this.renderer.setClearColor(0, 1);
    this.renderer.clear();
    draw();
    this.renderer.setRenderTarget(null);
  }

  /** Draws the line over the picture. */
  paint(): void {
    this.renderer.setRenderTarget(null);
    this.renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.mask.dispose();
    this.material.dispose();
    this.quad.geometry.dispose();
  }
}
