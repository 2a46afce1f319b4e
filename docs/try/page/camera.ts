/** Where what is shown is looked at from; turned by dragging, the wheel and the arrow keys. */

import type { Vec } from "./shapes";

/** Radians, and a factor. */
export interface Eye {
  yaw: number;
  pitch: number;
  zoom: number;
}

export const FIELD = 0.5; // radians, of the view from bottom to top
const MARGIN = 1.2;

/** What is to be in view: a box, and the radius of a ball round it. */
export interface Frame {
  middle: Vec;
  half: Vec;
  radius: number;
}

/** The matrices of a camera that has all of the frame in view, and sees as far as `reach` from its middle. Their unit is its radius. */
export function matrices({ middle, radius, half }: Frame, eye: Eye, aspect: number, reach = 1.1): { view: number[]; projection: number[] } {
  const f = 1 / Math.tan(FIELD / 2);
  const aside = Math.max(half[0], half[2]) / radius;
  const distance = (MARGIN * f * Math.max(half[1] / radius, aside / aspect) + half[2] / radius) / eye.zoom;
  const near = Math.max(0.01, distance - reach), far = distance + reach;
  const projection = [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (near + far) / (near - far), -1, 0, 0, (2 * near * far) / (near - far), 0];
  const [cy, sy, cp, sp] = [Math.cos(eye.yaw), Math.sin(eye.yaw), Math.cos(eye.pitch), Math.sin(eye.pitch)];
  const rows = [[cy, 0, -sy], [-sp * sy, cp, -sp * cy], [cp * sy, sp, cp * cy]];
  const view = [0, 1, 2].flatMap((k) => [...rows.map((row) => row[k]! / radius), 0]);
  view.push(...rows.map((row, i) => -(row[0]! * middle[0] + row[1]! * middle[1] + row[2]! * middle[2]) / radius - (i === 2 ? distance : 0)), 1);
  return { view, projection };
}

/** Calls `turn` with radians and a factor as the pointer, the wheel and keys ask for it, and `reset` on a double click. */
export function listen(canvas: HTMLCanvasElement, turn: (yaw: number, pitch: number, zoom: number) => void, reset: () => void): void {
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

/** Lets `eye` go round what stands on the ground, and back to `start` on a double click; `moved` is called each time. */
export function walkRound(canvas: HTMLCanvasElement, eye: Eye, start: Eye, moved: () => void): void {
  listen(canvas, (yaw, pitch, zoom) => {
    eye.yaw += yaw;
    eye.pitch = Math.max(0, Math.min(1.5, eye.pitch + pitch));
    eye.zoom = Math.max(0.5, Math.min(20, eye.zoom * zoom));
    moved();
  }, () => {
    Object.assign(eye, start);
    moved();
  });
}
