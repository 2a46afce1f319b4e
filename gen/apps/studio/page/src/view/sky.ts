import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, RawShaderMaterial, Vector3 } from "three";
import { COLOR } from "./glsl";
import { BACKDROP_STOPS, type Shared } from "./shared";

/** What stands behind everything changes with height alone, so the corners of a dome are enough, where there is no picture of it. */
const VERTEX = /* glsl */ `${COLOR}
uniform mat4 viewMatrix, projectionMatrix;
in vec3 position;
uniform vec4 backdrop[${BACKDROP_STOPS}];  // light, and the height from which on it is that
out vec3 color;
out vec3 way;
void main() {
  way = position;
  vec3 c = backdrop[0].rgb;
  for (int i = 1; i < ${BACKDROP_STOPS}; ++i)
    c = mix(c, backdrop[i].rgb, clamp((position.y - backdrop[i - 1].w) / max(backdrop[i].w - backdrop[i - 1].w, 1e-4), 0.0, 1.0));
  color = shown(c);
  gl_Position = (projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0)).xyww;
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 color;
in vec3 way;
uniform sampler2D sky;
uniform float pictured;
out vec4 picture;
void main() {
  vec3 d = normalize(way);
  // The haze of the ground rises as high as the picture does not show it.
  float height = asin(clamp(d.y, 0.0, 1.0)) / 1.57079633;
  vec3 seen = texture(sky, vec2(0.5 + atan(d.x, -d.z) / 6.28318531, max(height, 0.004))).rgb;
  picture = vec4(mix(color, seen, pictured), 1.0);
}
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
    const { backdrop, sky } = shared;
    super(
      dome(),
      new RawShaderMaterial({
        vertexShader: VERTEX,
        fragmentShader: FRAGMENT,
        uniforms: { backdrop, sky, pictured: { value: 0 } },
        glslVersion: GLSL3,
        depthWrite: false,
        side: DoubleSide,
      }),
    );
    this.frustumCulled = false;
    this.matrixAutoUpdate = false;
  }

  override onBeforeRender = (): void => {
    this.material.uniforms.pictured!.value = this.material.uniforms.sky!.value ? 1 : 0;
  };

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
