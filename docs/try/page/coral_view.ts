/** Draws a coral by WebGL as it stands on sand under water. */

import { matrices, walkRound, type Eye, type Frame } from "./camera";
import { BODY_FRAGMENT, BODY_VERTEX, SAND_FRAGMENT, SAND_VERTEX, SHADOW_FRAGMENT, SHADOW_VERTEX } from "./coral_shaders";
import type { Coral } from "./engine";
import { attributes, fit, grid, program } from "./gl";
import { tubesOf, type Mesh } from "./tubes";

const ASIDE: Eye = { yaw: 0.5, pitch: 0.42, zoom: 1 };
const FAR = 6; // of what is seen, in radii of the frame
const SHADOW = 2048; // pixels, the side of the picture that the sun sees
const SUN: [number, number, number] = [-0.42, 0.84, 0.34];
export const SEGMENT = 13; // numbers of a segment

/** Corals as meshes: their bodies, and their branches as tubes. */
export interface CoralMesh extends Mesh {
  /** Ridge, youth and openness, three numbers each. */
  skin: Float32Array;
}

export function meshOf(coral: Coral): CoralMesh {
  const { segments, places, normals, skin, corners, color } = coral;
  if (!segments.length) {
    const colors = new Float32Array(places.length);
    for (let i = 0; i < colors.length; ++i) colors[i] = color[i % 3]!;
    return { places, normals, skin, corners, colors, from: corners };
  }
  const tubes = tubesOf(segments, SEGMENT);
  const own = new Float32Array(tubes.places.length);
  tubes.from.forEach((segment, i) => own.set([1, 0, segments[segment * SEGMENT + 12]!], 3 * i));
  return { ...tubes, skin: own };
}

export interface CoralView {
  show(coral: Coral): void;
  /** The picture as it is, as PNG without a background. */
  picture(): Promise<Blob | null>;
}

/** All of it when it has grown, so that the view stays while it grows; seen from above its foot reaches down. */
function frameOf({ size: [wide, high, deep] }: Coral): Frame {
  const half = Math.max(wide, deep) / 2;
  return { middle: [0, 0.46 * high - 0.2 * half, 0], half: [half * 1.05, (high / 2) * 1.1 + 0.1 * half, half * 0.6], radius: Math.hypot(half, high / 2, half) };
}

type Three = [number, number, number];
const unit = (v: Three): Three => v.map((x) => x / Math.hypot(...v)) as Three;
const cross = (a: Three, b: Three): Three => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** From the world to what the sun sees of a ball round the middle of the frame. */
function sunView({ middle, radius }: Frame): number[] {
  const z = unit(SUN), x = unit(cross([0, 1, 0], z)), y = cross(z, x), half = 1.6 * radius;
  const rows = [x, y, z.map((v) => -v) as Three];
  const matrix = [0, 1, 2].flatMap((k) => [...rows.map((row) => row[k]! / half), 0]);
  return [...matrix, ...rows.map((row) => -(row[0] * middle[0] + row[1] * middle[1] + row[2] * middle[2]) / half), 1];
}

/** Where the camera is, of its matrix: turned, scaled and moved. */
function eyeOf(view: number[], radius: number): Three {
  const at = [view[12]!, view[13]!, view[14]!];
  return [0, 1, 2].map((k) => -radius * radius * (view[4 * k]! * at[0]! + view[4 * k + 1]! * at[1]! + view[4 * k + 2]! * at[2]!)) as Three;
}

/** Null where the browser has no WebGL 2. */
export function coralViewOn(canvas: HTMLCanvasElement): CoralView | null {
  const context = canvas.getContext("webgl2", { antialias: true });
  if (!context) return null;
  const gl: WebGL2RenderingContext = context;
  const body = program(gl, BODY_VERTEX, BODY_FRAGMENT), sand = program(gl, SAND_VERTEX, SAND_FRAGMENT), depth = program(gl, SHADOW_VERTEX, SHADOW_FRAGMENT);
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);

  const picture = gl.createTexture(), target = gl.createFramebuffer();
  gl.bindTexture(gl.TEXTURE_2D, picture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, SHADOW, SHADOW);
  for (const [what, how] of [[gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE], [gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]] as const)
    gl.texParameteri(gl.TEXTURE_2D, what, how);
  gl.bindFramebuffer(gl.FRAMEBUFFER, target);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, picture, 0);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);

  const bodyArray = gl.createVertexArray(), sandArray = gl.createVertexArray();
  gl.bindVertexArray(bodyArray);
  const buffers = [0, 1, 2, 3].map((location) => attributes(gl, 3, [[location, 3, 0]], 0));
  const corners = gl.createBuffer();
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, corners);
  const { places, triangles } = grid(65);
  gl.bindVertexArray(sandArray);
  attributes(gl, 2, [[0, 2, 0]], 0);
  gl.bufferData(gl.ARRAY_BUFFER, places, gl.STATIC_DRAW);
  const groundLight = attributes(gl, 2, [[1, 2, 0]], 0);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);

  let coral: Coral | null = null, frame: Frame | null = null, count = 0;
  const eye = { ...ASIDE };
  let waiting = 0, stale = true;

  function paintShadow(view: number[]): void {
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.viewport(0, 0, SHADOW, SHADOW);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.useProgram(depth);
    gl.uniformMatrix4fv(gl.getUniformLocation(depth, "shadow_view"), false, view);
    gl.bindVertexArray(bodyArray);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    stale = false;
  }

  function paint(): void {
    waiting = 0;
    if (!coral || !frame) return;
    const toSun = sunView(frame);
    if (stale) paintShadow(toSun);
    const { view, projection } = matrices(frame, eye, fit(gl, canvas), FAR);
    const at = eyeOf(view, frame.radius);
    gl.bindTexture(gl.TEXTURE_2D, picture);
    for (const [used, array] of [[sand, sandArray], [body, bodyArray]] as const) {
      gl.useProgram(used);
      const place = (name: string): WebGLUniformLocation | null => gl.getUniformLocation(used, name);
      gl.uniformMatrix4fv(place("view"), false, view);
      gl.uniformMatrix4fv(place("projection"), false, projection);
      gl.uniformMatrix4fv(place("shadow_view"), false, toSun);
      gl.uniform3fv(place("sun"), unit(SUN));
      gl.uniform3fv(place("eye"), at);
      gl.uniform3fv(place("second"), coral.second);
      gl.uniform1f(place("cup"), coral.cup);
      gl.uniform1f(place("relief"), coral.relief);
      gl.uniform1f(place("size"), 2 * frame.radius);
      gl.uniform1f(place("half_side"), coral.groundHalf);
      gl.uniform1i(place("matter"), ["cups", "valleys", "sponge"].indexOf(coral.matter));
      gl.bindVertexArray(array);
      // What is seen through the sand is not hidden by it.
      gl[used === sand ? "enable" : "disable"](gl.BLEND);
      gl[used === sand ? "disable" : "enable"](gl.DEPTH_TEST);
      gl.drawElements(gl.TRIANGLES, used === sand ? triangles.length : count, gl.UNSIGNED_INT, 0);
    }
  }
  const repaint = (): void => {
    waiting ||= requestAnimationFrame(paint);
  };
  walkRound(canvas, eye, ASIDE, repaint);
  new ResizeObserver(repaint).observe(canvas);

  return {
    show: (next) => {
      coral = next;
      frame = frameOf(next);
      const mesh = meshOf(next);
      const fill = (buffer: WebGLBuffer, numbers: Float32Array): void => {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
      };
      [mesh.places, mesh.normals, mesh.skin, mesh.colors].forEach((numbers, i) => fill(buffers[i]!, numbers));
      fill(groundLight, next.ground);
      gl.bindVertexArray(bodyArray);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.corners, gl.DYNAMIC_DRAW);
      count = mesh.corners.length;
      stale = true;
      repaint();
    },
    picture: () => {
      paint();
      return new Promise((done) => canvas.toBlob(done));
    },
  };
}
