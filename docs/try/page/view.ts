/** Draws shapes by WebGL; they are turned by dragging, the wheel and the arrow keys. */

import { listen, matrices, type Eye } from "./camera";
import { attributes, fit, pixelOf, program, SEGMENT_CORNERS, SEGMENT_NORMAL, SEGMENT_VERTEX } from "./gl";
import type { Shapes } from "./shapes";

const FRONT: Eye = { yaw: 0, pitch: 0, zoom: 1 };
const ASIDE: Eye = { yaw: 0.5, pitch: 0.12, zoom: 1 };

const SHADE = `
vec3 shade(vec3 color, vec3 normal) {
  float sun = max(dot(normal, normalize(vec3(-0.5, 0.6, 0.6))), 0.0);
  return color * (0.75 + 0.14 * normal.y + 0.3 * sun) + 0.05 * sun;
}`;

const SEGMENT_FRAGMENT = `#version 300 es
precision highp float;
in vec3 paint;
out vec4 shown;
${SEGMENT_NORMAL}
${SHADE}
void main() {
  shown = vec4(shade(paint, segment_normal()), 1);
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

/** Null where the browser has no WebGL 2. */
export function viewOn(canvas: HTMLCanvasElement): View | null {
  const gl = canvas.getContext("webgl2", { antialias: true });
  if (!gl) return null;
  const segments = program(gl, SEGMENT_VERTEX, SEGMENT_FRAGMENT), triangles = program(gl, CORNER_VERTEX, CORNER_FRAGMENT);
  const segmentArray = gl.createVertexArray(), cornerArray = gl.createVertexArray();
  gl.bindVertexArray(segmentArray);
  attributes(gl, 2, [[0, 2, 0]], 0);
  gl.bufferData(gl.ARRAY_BUFFER, SEGMENT_CORNERS, gl.STATIC_DRAW);
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
    const { view, projection } = matrices(shapes, eye, fit(gl, canvas));
    for (const [used, array] of [[segments, segmentArray], [triangles, cornerArray]] as const) {
      gl.useProgram(used);
      gl.uniformMatrix4fv(gl.getUniformLocation(used, "view"), false, view);
      gl.uniformMatrix4fv(gl.getUniformLocation(used, "projection"), false, projection);
      gl.bindVertexArray(array);
      if (used === triangles) {
        gl.drawArrays(gl.TRIANGLES, 0, shapes.corners.length / 6);
      } else {
        gl.uniform1f(gl.getUniformLocation(used, "pixel"), pixelOf(canvas));
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
