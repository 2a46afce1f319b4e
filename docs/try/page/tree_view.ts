/** Draws a tree by WebGL as it stands in the light that it leaves itself. */

import { matrices, walkRound, type Eye, type Frame } from "./camera";
import type { Tree } from "./engine";
import { attributes, fit, grid, pixelOf, program, SEGMENT_CORNERS, SEGMENT_NORMAL, SEGMENT_VERTEX } from "./gl";

const ASIDE: Eye = { yaw: 0.5, pitch: 0.1, zoom: 1 };
const STRIDE = 13; // numbers of a segment and of an organ
const THIN = 0.45; // of the least width of a branch as it is seen: twigs are many
const FAR = 5; // of what is seen, in radii of the frame
const LEAST = 2.4; // metres: the height of the frame of a seedling

/** A person of 1.75 m as segments, for scale: x and y of both ends with their radii. */
const PERSON = [[0, 1.63, 0.105, 0, 1.66, 0.1], [0, 1.32, 0.17, 0, 1.02, 0.15], [-0.08, 0.98, 0.1, -0.11, 0.06, 0.06],
  [0.08, 0.98, 0.1, 0.11, 0.06, 0.06], [-0.23, 1.38, 0.06, -0.27, 0.85, 0.045], [0.23, 1.38, 0.06, 0.27, 0.85, 0.045]];

/** Linear light of a sunny day on a surface, then as sRGB. `normal` and `sun` in the same axes, `up` how far it faces the sky. */
const LIGHT = `
uniform vec3 sun;  // toward it, as seen
vec3 daylight(vec3 color, vec3 normal, float up, vec2 lit, float through) {
  vec3 albedo = pow(color, vec3(2.2));
  float facing = dot(normal, sun);
  vec3 direct = vec3(2.9, 2.65, 2.2) * lit.x * (max(facing, 0.0) + through * max(-facing, 0.0));
  vec3 sky = vec3(0.62, 0.74, 0.92) * (0.3 + 0.7 * lit.y) * (0.75 + 0.25 * up);
  vec3 light = albedo * (direct + sky + vec3(0.10, 0.11, 0.06));
  return pow(1.0 - exp(-1.25 * light), vec3(1.0 / 2.2));
}`;

const BRANCH_FRAGMENT = `#version 300 es
precision highp float;
uniform mat4 view;
in vec3 paint;
in vec2 lit;
out vec4 shown;
${SEGMENT_NORMAL}
${LIGHT}
void main() {
  vec3 normal = segment_normal();
  shown = vec4(daylight(paint, normal, (transpose(mat3(view)) * normal).y / length(view[0].xyz), lit, 0.0), 1);
}`;

const ORGAN_VERTEX = `#version 300 es
uniform mat4 view, projection;
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 upright;
layout(location = 2) in vec3 at;
layout(location = 3) in vec4 turn;
layout(location = 4) in float size;
layout(location = 5) in vec3 color;
layout(location = 6) in vec2 light;
out vec3 paint, normal, seen;
out vec2 lit;
vec3 turned(vec3 v) { return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v); }
void main() {
  vec4 place = view * vec4(at + size * turned(corner), 1);
  paint = color;
  lit = light;
  normal = mat3(view) * turned(upright);
  seen = place.xyz;
  gl_Position = projection * place;
}`;
const ORGAN_FRAGMENT = `#version 300 es
precision highp float;
uniform mat4 view;
in vec3 paint, normal, seen;
in vec2 lit;
out vec4 shown;
${LIGHT}
void main() {
  vec3 near = normalize(normal);
  if (dot(near, seen) > 0.0) near = -near;
  shown = vec4(daylight(paint, near, (transpose(mat3(view)) * near).y / length(view[0].xyz), lit, 0.75), 1);
}`;

/** The ground fades out, so that there is no horizon to draw. */
const GROUND_VERTEX = `#version 300 es
uniform mat4 view, projection;
uniform float size;
layout(location = 0) in vec2 corner;  // -1..1
layout(location = 1) in vec2 light;
out vec2 place, lit;
void main() {
  place = corner;
  lit = light;
  gl_Position = projection * view * vec4(size * corner.x, 0, size * corner.y, 1);
}`;
const GROUND_FRAGMENT = `#version 300 es
precision highp float;
in vec2 place, lit;
out vec4 shown;
${LIGHT}
void main() {
  float alpha = 1.0 - smoothstep(0.35, 1.0, length(place));
  shown = vec4(daylight(vec3(0.44, 0.48, 0.33), sun, 1.0, lit, 0.0) * alpha, alpha);
}`;

export interface TreeView {
  show(tree: Tree): void;
  /** The picture as it is, as PNG without a background. */
  picture(): Promise<Blob | null>;
}

/** The tree from its foot to its top, and the person beside it. */
function frameOf({ segments, height }: Tree): Frame {
  let aside = 0;
  for (let i = 0; i < segments.length; i += STRIDE) aside = Math.max(aside, Math.hypot(segments[i + 4]!, segments[i + 6]!));
  const tall = Math.max(height * 1.04, LEAST), half = Math.max(aside, 1.3);
  return { middle: [0, tall / 2, 0], half: [half, tall / 2, 0.3 * half], radius: Math.hypot(half, tall / 2, half) };
}

/** The person stands beside the stem. */
function person({ height }: Tree): number[] {
  const x = Math.max(0.9, 0.11 * height);
  return PERSON.flatMap(([ax, ay, ar, bx, by, br]) => [x + ax!, ay!, 0, ar!, x + bx!, by!, 0, br!, 0.36, 0.4, 0.47, 1, 1]);
}

/** Something to draw, with the program that draws it. */
interface Drawn {
  program: WebGLProgram;
  array: WebGLVertexArrayObject;
  draw(): void;
}

interface Programs {
  ground: WebGLProgram;
  branches: WebGLProgram;
  organs: WebGLProgram;
}

/** All that is drawn of a tree, in this order, and its buffers, which are to be deleted with it. */
function drawnOf(gl: WebGL2RenderingContext, { ground, branches, organs }: Programs, tree: Tree): { drawn: Drawn[]; buffers: WebGLBuffer[] } {
  const buffers: WebGLBuffer[] = [];
  const begin = (): WebGLVertexArrayObject => {
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    return array;
  };
  const fill = (numbers: Float32Array, stride: number, parts: [number, number, number][], divisor: number): void => {
    buffers.push(attributes(gl, stride, parts, divisor));
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
  };
  function groundOf(light: Float32Array): Drawn {
    const array = begin(), { places, triangles } = grid(Math.sqrt(light.length / 2));
    fill(places, 2, [[0, 2, 0]], 0);
    fill(light, 2, [[1, 2, 0]], 0);
    buffers.push(gl.createBuffer());
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers.at(-1)!);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    return { program: ground, array, draw: () => gl.drawElements(gl.TRIANGLES, triangles.length, gl.UNSIGNED_INT, 0) };
  }
  function branchesOf(segments: Float32Array): Drawn {
    const array = begin(), count = segments.length / STRIDE;
    fill(SEGMENT_CORNERS, 2, [[0, 2, 0]], 0);
    fill(segments, STRIDE, [[1, 4, 0], [2, 4, 4], [3, 3, 8], [4, 2, 11]], 1);
    return { program: branches, array, draw: () => gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count) };
  }
  function organsOf(shape: Float32Array, placed: Float32Array): Drawn {
    const array = begin(), count = placed.length / STRIDE;
    fill(shape, 6, [[0, 3, 0], [1, 3, 3]], 0);
    fill(placed, STRIDE, [[2, 3, 0], [3, 4, 3], [4, 1, 7], [5, 3, 8], [6, 2, 11]], 1);
    return { program: organs, array, draw: () => gl.drawArraysInstanced(gl.TRIANGLES, 0, shape.length / 6, count) };
  }
  const drawn = [groundOf(tree.ground), branchesOf(tree.segments), branchesOf(new Float32Array(person(tree))),
    ...tree.shapes.map((shape, i) => organsOf(shape, tree.organs[i]!))];
  return { drawn, buffers };
}

/** Null where the browser has no WebGL 2. */
export function treeViewOn(canvas: HTMLCanvasElement): TreeView | null {
  const context = canvas.getContext("webgl2", { antialias: true });
  if (!context) return null;
  const gl: WebGL2RenderingContext = context;
  const programs: Programs = {
    ground: program(gl, GROUND_VERTEX, GROUND_FRAGMENT),
    branches: program(gl, SEGMENT_VERTEX, BRANCH_FRAGMENT),
    organs: program(gl, ORGAN_VERTEX, ORGAN_FRAGMENT),
  };
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);

  let tree: Tree | null = null, frame: Frame | null = null;
  let { drawn, buffers }: ReturnType<typeof drawnOf> = { drawn: [], buffers: [] };
  const eye = { ...ASIDE };
  let waiting = 0;

  function paint(): void {
    waiting = 0;
    if (!tree || !frame) return;
    const { view, projection } = matrices(frame, eye, fit(gl, canvas), FAR);
    const scale = 1 / frame.radius;
    const sun = [0, 1, 2].map((row) => tree!.sun.reduce((sum, value, k) => sum + (view[4 * k + row]! / scale) * value, 0));
    for (const { program: used, array, draw } of drawn) {
      gl.useProgram(used);
      const place = (name: string): WebGLUniformLocation | null => gl.getUniformLocation(used, name);
      gl.uniformMatrix4fv(place("view"), false, view);
      gl.uniformMatrix4fv(place("projection"), false, projection);
      gl.uniform3fv(place("sun"), sun);
      gl.uniform1f(place("pixel"), THIN * pixelOf(canvas));
      gl.uniform1f(place("scale"), scale);
      gl.uniform1f(place("size"), tree.groundHalf);
      gl.bindVertexArray(array);
      // What is seen through the ground is not hidden by it.
      for (const ability of [gl.BLEND, gl.DEPTH_TEST]) gl[(ability === gl.BLEND) === (used === programs.ground) ? "enable" : "disable"](ability);
      draw();
    }
  }
  const repaint = (): void => {
    waiting ||= requestAnimationFrame(paint);
  };
  walkRound(canvas, eye, ASIDE, repaint);
  new ResizeObserver(repaint).observe(canvas);

  return {
    show: (next) => {
      for (const { array } of drawn) gl.deleteVertexArray(array);
      for (const buffer of buffers) gl.deleteBuffer(buffer);
      tree = next;
      frame = frameOf(next);
      ({ drawn, buffers } = drawnOf(gl, programs, next));
      repaint();
    },
    picture: () => {
      paint();
      return new Promise((done) => canvas.toBlob(done));
    },
  };
}
