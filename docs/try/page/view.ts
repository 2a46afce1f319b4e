/** Draws shapes by WebGL; they are turned by dragging, the wheel and the arrow keys. */

import type { Shapes } from "./shapes";

/** Radians, and a factor. */
interface Eye {
  yaw: number;
  pitch: number;
  zoom: number;
}

const FIELD = 0.5; // radians, of the view from bottom to top
const MARGIN = 1.2;
const FRONT: Eye = { yaw: 0, pitch: 0, zoom: 1 };
const ASIDE: Eye = { yaw: 0.5, pitch: 0.12, zoom: 1 };

const SHADE = `
vec3 shade(vec3 color, vec3 normal) {
  float sun = max(dot(normal, normalize(vec3(-0.5, 0.6, 0.6))), 0.0);
  return color * (0.75 + 0.14 * normal.y + 0.3 * sun) + 0.05 * sun;
}`;

/** A segment is a rectangle that faces the camera, shaded as the cone that it stands for; its ends are half balls. */
const SEGMENT_VERTEX = `#version 300 es
uniform mat4 view, projection;
uniform float pixel, scale;  // size of a pixel at the distance 1; of radii
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 from;
layout(location = 2) in vec4 to;
layout(location = 3) in vec3 color;
out vec3 paint, across, axis, toward;
out vec4 place;  // across, in radii; along; length as it is seen; radius
void main() {
  vec3 a = (view * vec4(from.xyz, 1)).xyz, b = (view * vec4(to.xyz, 1)).xyz;
  vec2 radius = max(scale * vec2(from.w, to.w), 0.6 * pixel * -vec2(a.z, b.z));
  vec3 facing = -normalize(a + b), way = b - a;
  vec3 seen = way - facing * dot(way, facing);
  float size = length(seen);
  axis = size > 1e-4 * radius.x ? seen / size : normalize(vec3(0, 1, 0) - facing * facing.y);
  across = cross(axis, facing);
  toward = size > 1e-4 * radius.x ? normalize(cross(across, way)) : facing;
  bool first = corner.y < 0.5;
  float own = first ? radius.x : radius.y, beyond = first ? -own : own;
  paint = color;
  place = vec4(corner.x, (first ? 0.0 : size) + beyond, size, own);
  gl_Position = projection * vec4((first ? a : b) + across * corner.x * own + axis * beyond, 1);
}`;
const SEGMENT_FRAGMENT = `#version 300 es
precision highp float;
in vec3 paint, across, axis, toward;
in vec4 place;
out vec4 shown;
${SHADE}
void main() {
  float beyond = (place.y - clamp(place.y, 0.0, place.z)) / place.w;
  float inside = 1.0 - place.x * place.x - beyond * beyond;
  if (inside < 0.0) discard;
  // Where segments meet, their ends look as one; a segment without length is a ball.
  vec3 ahead = place.z > 1e-4 * place.w ? toward * (sqrt(1.0 - place.x * place.x) - sqrt(inside)) : axis * beyond;
  shown = vec4(shade(paint, normalize(across * place.x + ahead + toward * sqrt(inside))), 1);
}`;

const CORNER_VERTEX = `#version 300 es
uniform mat4 view, projection;
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 color;
out vec3 paint, seen;
void main() {
  vec4 at = view * vec4(place, 1);
  paint = color;
  seen = at.xyz;
  gl_Position = projection * at;
}`;
const CORNER_FRAGMENT = `#version 300 es
precision highp float;
in vec3 paint, seen;
out vec4 shown;
${SHADE}
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  shown = vec4(shade(paint, normal), 1);
}`;

export interface View {
  show(shapes: Shapes): void;
  /** The picture as it is, as PNG without a background. */
  picture(): Promise<Blob | null>;
}

function program(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const made = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made) ?? "a shader does not link");
  return made;
}

/** Numbers in a buffer of `stride` floats each, as attributes: location, count, offset. */
function attributes(gl: WebGL2RenderingContext, stride: number, parts: [number, number, number][], divisor: number): WebGLBuffer {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  for (const [location, count, offset] of parts) {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, count, gl.FLOAT, false, 4 * stride, 4 * offset);
    gl.vertexAttribDivisor(location, divisor);
  }
  return buffer;
}

/** The matrices of a camera that has all of the shapes in view. Their unit is the radius of the shapes. */
function matrices({ middle, radius, half }: Shapes, eye: Eye, aspect: number): { view: number[]; projection: number[] } {
  const f = 1 / Math.tan(FIELD / 2);
  const aside = Math.max(half[0], half[2]) / radius;
  const distance = (MARGIN * f * Math.max(half[1] / radius, aside / aspect) + half[2] / radius) / eye.zoom;
  const near = Math.max(0.01, distance - 1.1), far = distance + 1.1;
  const projection = [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (near + far) / (near - far), -1, 0, 0, (2 * near * far) / (near - far), 0];
  const [cy, sy, cp, sp] = [Math.cos(eye.yaw), Math.sin(eye.yaw), Math.cos(eye.pitch), Math.sin(eye.pitch)];
  const rows = [[cy, 0, -sy], [-sp * sy, cp, -sp * cy], [cp * sy, sp, cp * cy]];
  const view = [0, 1, 2].flatMap((k) => [...rows.map((row) => row[k]! / radius), 0]);
  view.push(...rows.map((row, i) => -(row[0]! * middle[0] + row[1]! * middle[1] + row[2]! * middle[2]) / radius - (i === 2 ? distance : 0)), 1);
  return { view, projection };
}

/** Calls `turn` with radians and a factor as the pointer, the wheel and keys ask for it, and `reset` on a double click. */
function listen(canvas: HTMLCanvasElement, turn: (yaw: number, pitch: number, zoom: number) => void, reset: () => void): void {
  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (canvas.hasPointerCapture(event.pointerId)) turn(-event.movementX * 0.008, event.movementY * 0.008, 1);
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    turn(0, 0, Math.exp(-event.deltaY * 0.0012));
  }, { passive: false });
  canvas.addEventListener("dblclick", reset);
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [0.1, 0, 1], ArrowRight: [-0.1, 0, 1], ArrowUp: [0, -0.1, 1], ArrowDown: [0, 0.1, 1], "+": [0, 0, 1.1], "-": [0, 0, 1 / 1.1] }[event.key];
    if (!step) return;
    event.preventDefault();
    turn(step[0]!, step[1]!, step[2]!);
  });
}

/** Null where the browser has no WebGL 2. */
export function viewOn(canvas: HTMLCanvasElement): View | null {
  const gl = canvas.getContext("webgl2", { antialias: true });
  if (!gl) return null;
  const segments = program(gl, SEGMENT_VERTEX, SEGMENT_FRAGMENT), triangles = program(gl, CORNER_VERTEX, CORNER_FRAGMENT);
  const segmentArray = gl.createVertexArray(), cornerArray = gl.createVertexArray();
  gl.bindVertexArray(segmentArray);
  attributes(gl, 2, [[0, 2, 0]], 0);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, 0, 1, 0, -1, 1, 1, 1]), gl.STATIC_DRAW);
  const segmentBuffer = attributes(gl, 11, [[1, 4, 0], [2, 4, 4], [3, 3, 8]], 1);
  gl.bindVertexArray(cornerArray);
  const cornerBuffer = attributes(gl, 6, [[0, 3, 0], [1, 3, 3]], 0);
  gl.enable(gl.DEPTH_TEST);

  let shapes: Shapes | null = null;
  let eye = { ...FRONT };
  let turned = false;
  let waiting = 0;

  function paint(): void {
    waiting = 0;
    if (!gl || !shapes) return;
    const ratio = devicePixelRatio;
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    gl.viewport(0, 0, width, height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const { view, projection } = matrices(shapes, eye, width / height);
    for (const [used, array] of [[segments, segmentArray], [triangles, cornerArray]] as const) {
      gl.useProgram(used);
      gl.uniformMatrix4fv(gl.getUniformLocation(used, "view"), false, view);
      gl.uniformMatrix4fv(gl.getUniformLocation(used, "projection"), false, projection);
      gl.bindVertexArray(array);
      if (used === triangles) {
        gl.drawArrays(gl.TRIANGLES, 0, shapes.corners.length / 6);
      } else {
        gl.uniform1f(gl.getUniformLocation(used, "pixel"), (2 * Math.tan(FIELD / 2) * ratio) / height);
        gl.uniform1f(gl.getUniformLocation(used, "scale"), 1 / shapes.radius);
        gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, shapes.segments.length / 11);
      }
    }
  }
  const repaint = (): void => {
    waiting ||= requestAnimationFrame(paint);
  };
  const turn = (yaw: number, pitch: number, zoom: number): void => {
    turned = true;
    eye = { yaw: eye.yaw + yaw, pitch: Math.max(-1.5, Math.min(1.5, eye.pitch + pitch)), zoom: Math.max(0.3, Math.min(20, eye.zoom * zoom)) };
    repaint();
  };

  listen(canvas, turn, () => {
    turned = false;
    if (shapes) show(shapes);
  });
  new ResizeObserver(repaint).observe(canvas);

  function show(next: Shapes): void {
    shapes = next;
    if (!turned) eye = { ...(next.flat ? FRONT : ASIDE) };
    gl!.bindBuffer(gl!.ARRAY_BUFFER, segmentBuffer);
    gl!.bufferData(gl!.ARRAY_BUFFER, next.segments, gl!.DYNAMIC_DRAW);
    gl!.bindBuffer(gl!.ARRAY_BUFFER, cornerBuffer);
    gl!.bufferData(gl!.ARRAY_BUFFER, next.corners, gl!.DYNAMIC_DRAW);
    repaint();
  }
  return {
    show,
    picture: () => {
      paint();
      return new Promise((done) => canvas.toBlob(done));
    },
  };
}
