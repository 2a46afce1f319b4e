/** What the views share of WebGL: programs, buffers, and branches as cones. */

import { FIELD } from "./camera";

export function program(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
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
export function attributes(gl: WebGL2RenderingContext, stride: number, parts: [number, number, number][], divisor: number): WebGLBuffer {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  for (const [location, count, offset] of parts) {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, count, gl.FLOAT, false, 4 * stride, 4 * offset);
    gl.vertexAttribDivisor(location, divisor);
  }
  return buffer;
}

/** A segment is a rectangle that faces the camera, shaded as the cone that it stands for; its ends are half balls. */
export const SEGMENT_VERTEX = `#version 300 es
uniform mat4 view, projection;
uniform float pixel, scale;  // size of a pixel at the distance 1; of radii
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 from;
layout(location = 2) in vec4 to;
layout(location = 3) in vec3 color;
layout(location = 4) in vec2 light;  // of sun and sky, where that is known
out vec2 lit;
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
  lit = light;
  place = vec4(corner.x, (first ? 0.0 : size) + beyond, size, own);
  gl_Position = projection * vec4((first ? a : b) + across * corner.x * own + axis * beyond, 1);
}`;

/** The normal of a segment's fragment, as seen; discards what lies beside it. */
export const SEGMENT_NORMAL = `
in vec3 across, axis, toward;
in vec4 place;
vec3 segment_normal() {
  float beyond = (place.y - clamp(place.y, 0.0, place.z)) / place.w;
  float inside = 1.0 - place.x * place.x - beyond * beyond;
  if (inside < 0.0) discard;
  // Where segments meet, their ends look as one; a segment without length is a ball.
  vec3 ahead = place.z > 1e-4 * place.w ? toward * (sqrt(1.0 - place.x * place.x) - sqrt(inside)) : axis * beyond;
  return normalize(across * place.x + ahead + toward * sqrt(inside));
}`;

/** The canvas takes the size at which it is shown; gives its width by its height. */
export function fit(gl: WebGL2RenderingContext, canvas: HTMLCanvasElement): number {
  const width = Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio)), height = Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio));
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  gl.viewport(0, 0, width, height);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  return width / height;
}

/** Size of a pixel at the distance 1. */
export const pixelOf = (canvas: HTMLCanvasElement): number => (2 * Math.tan(FIELD / 2) * devicePixelRatio) / canvas.height;

/** The corners of the rectangle of a segment. */
export const SEGMENT_CORNERS = new Float32Array([-1, 0, 1, 0, -1, 1, 1, 1]);

/** Triangles of a grid of `side` by `side` places. */
export function grid(side: number): { places: Float32Array; triangles: Uint32Array } {
  const places: number[] = [], triangles: number[] = [];
  for (let row = 0; row < side; ++row)
    for (let column = 0; column < side; ++column) {
      places.push((2 * column) / (side - 1) - 1, (2 * row) / (side - 1) - 1);
      const i = row * side + column;
      if (row + 1 < side && column + 1 < side) triangles.push(i, i + 1, i + side, i + 1, i + side + 1, i + side);
    }
  return { places: new Float32Array(places), triangles: new Uint32Array(triangles) };
}
