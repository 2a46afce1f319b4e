import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, RawShaderMaterial, Vector3 } from "three";
import { COLOR } from "./glsl";
import type { Shared } from "./shared";

/** The gradients of povinc/: frond_water.inc, frond_meadow.inc; a plain wall. They change with height alone, so the
 *  corners of a dome are enough. */
const VERTEX = /* glsl */ `${COLOR}
uniform mat4 viewMatrix, projectionMatrix;
in vec3 position;
uniform vec3 zenith, horizon;
uniform vec4 haze;
uniform int sky_kind;
out vec3 color;
vec3 ramp(float y, vec3 a, vec3 b, vec3 c, vec3 d, vec3 e, vec4 stops) {
  vec3 v = mix(a, b, clamp(y / stops.x, 0.0, 1.0));
  v = mix(v, c, clamp((y - stops.x) / (stops.y - stops.x), 0.0, 1.0));
  v = mix(v, d, clamp((y - stops.y) / (stops.z - stops.y), 0.0, 1.0));
  return mix(v, e, clamp((y - stops.z) / (stops.w - stops.z), 0.0, 1.0));
}
void main() {
  float y = position.y;
  vec3 c = horizon * 0.9;
  if (sky_kind == 0) {
    c = ramp(y, haze.rgb, horizon * 1.15, horizon * 1.8, horizon * 2.6, horizon * 3.6 + 0.05, vec4(0.06, 0.14, 0.28, 0.52));
    c = mix(c, horizon * 4.0 + 0.25, clamp((y - 0.52) / 0.48, 0.0, 1.0));
  } else if (sky_kind == 1) {
    c = ramp(y, horizon, mix(horizon * 0.94, zenith, 0.06), mix(horizon, zenith, 0.55), zenith, zenith * 0.85, vec4(0.06, 0.25, 0.6, 1.0));
  }
  color = shown(c);
  gl_Position = (projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0)).xyww;
}
`;

const FRAGMENT = /* glsl */ `
precision mediump float;
in vec3 color;
out vec4 picture;
void main() { picture = vec4(color, 1.0); }
`;

const RINGS = 48;
const AROUND = 24;

function dome(): BufferGeometry {
  const at: number[] = [];
  const index: number[] = [];
  const corner = new Vector3();
  for (let ring = 0; ring <= RINGS; ++ring)
    for (let k = 0; k <= AROUND; ++k) {
      // Closest together at the horizon.
      const s = (2 * ring) / RINGS - 1;
      corner.setFromSphericalCoords(1, (Math.PI / 2) * (1 - s * Math.abs(s)), (2 * Math.PI * k) / AROUND);
      at.push(...corner.toArray());
      if (ring === RINGS || k === AROUND) continue;
      const i = ring * (AROUND + 1) + k;
      index.push(i, i + 1, i + AROUND + 1, i + AROUND + 1, i + 1, i + AROUND + 2);
    }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(at), 3));
  geometry.setIndex(index);
  return geometry;
}

/** What is behind everything; drawn last, where nothing else is. */
export class Sky extends Mesh<BufferGeometry, RawShaderMaterial> {
  constructor(shared: Shared) {
    const { zenith, horizon, haze, sky_kind } = shared;
    super(
      dome(),
      new RawShaderMaterial({
        vertexShader: VERTEX,
        fragmentShader: FRAGMENT,
        uniforms: { zenith, horizon, haze, sky_kind },
        glslVersion: GLSL3,
        depthWrite: false,
        side: DoubleSide,
      }),
    );
    this.frustumCulled = false;
    this.matrixAutoUpdate = false;
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
