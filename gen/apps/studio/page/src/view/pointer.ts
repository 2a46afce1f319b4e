import { Plane, Raycaster, Vector2, Vector3, type PerspectiveCamera } from "three";
import type { Vec3 } from "./header";
import type { Handle } from "./guides";
import type { Drag, Tool } from "./tool";

/** What the pointer may do in the view. */
export interface PointerTarget {
  readonly camera: PerspectiveCamera;
  /** What is worked with in place of selecting, if anything is. */
  readonly tool: Tool | null;
  /** Lets the eye be turned by dragging, or not. */
  holdEye(still: boolean): void;
  handleAt(x: number, y: number): Handle | null;
  cameraAt(x: number, y: number): boolean;
  /** The planting under a pixel that may be moved, with its foot. */
  plantingAt(x: number, y: number): Planting | null;
  groundUnder(ray: Raycaster, height: number): Vector3 | null;
  /** `also`: beside what is selected. */
  click(x: number, y: number, also: boolean): void;
  flyToCamera(): void;
  /** Where the preset's camera is. */
  readonly filmEye: Vector3;
  cameraMoved(at: Vec3, done: boolean): void;
  keyMoved(handle: Handle, at: Vec3, done: boolean): void;
  plantingMoved(planting: Planting, at: Vector3, done: boolean): void;
}

export interface Planting {
  entry: number;
  place: number;
  foot: Vec3;
}

const CLICK = 4; // pixels that a click may wander

/** Clicks pick; handles and plantings are dragged; all else turns the eye. */
export class Pointer {
  private drag: Drag | null = null;
  private down: { x: number; y: number; id: number } | null = null;
  private ray = new Raycaster();
  private stop = new AbortController();

  constructor(
    private canvas: HTMLCanvasElement,
    private target: PointerTarget,
  ) {
    const options = { signal: this.stop.signal };
    // Before the controls of the eye hear of it.
    canvas.addEventListener("pointerdown", (e) => this.begin(e), { ...options, capture: true });
    canvas.addEventListener("pointermove", (e) => this.move(e), options);
    canvas.addEventListener("pointerup", (e) => this.end(e), options);
    canvas.addEventListener("pointercancel", () => this.release(), options);
    canvas.addEventListener("pointerleave", () => this.target.tool?.hover?.(null), options);
  }

  dispose(): void {
    this.stop.abort();
  }

  private place(event: PointerEvent): [number, number] {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
  private aim(x: number, y: number): Raycaster {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.target.camera);
    return this.ray;
  }

  private begin(event: PointerEvent): void {
    if (event.button !== 0 || !event.isPrimary) return;
    const [x, y] = this.place(event);
    this.down = { x, y, id: event.pointerId };
    this.canvas.focus({ preventScroll: true });
    this.drag = this.dragAt(x, y);
    this.target.holdEye(this.drag !== null);
    if (this.drag) this.canvas.setPointerCapture(event.pointerId);
  }

  private dragAt(x: number, y: number): Drag | null {
    const { tool } = this.target;
    if (tool) return tool.drag(this.aim(x, y));
    const handle = this.target.handleAt(x, y);
    if (handle) return this.planeDrag(handle.at, x, y, (at, done) => this.target.keyMoved(handle, at, done));
    if (this.target.cameraAt(x, y)) return this.planeDrag(this.target.filmEye, x, y, (at, done) => this.target.cameraMoved(at, done));
    const planting = this.target.plantingAt(x, y);
    return planting && this.plantingDrag(planting, x, y);
  }

  /** In the plane that faces the eye; with Shift up and down alone. */
  private planeDrag(from: Vector3, x: number, y: number, told: (at: Vec3, done: boolean) => void): Drag {
    const begin = from.clone();
    const facing = this.target.camera.getWorldDirection(new Vector3());
    const plane = new Plane().setFromNormalAndCoplanarPoint(facing, begin);
    const grip = this.aim(x, y).ray.intersectPlane(plane, new Vector3()) ?? begin.clone();
    const at = begin.clone();
    const tell = (done: boolean): void => told(at.toArray(), done);
    return {
      move: (ray, shift) => {
        const hit = ray.ray.intersectPlane(plane, new Vector3());
        if (!hit) return;
        at.copy(begin).add(hit.sub(grip));
        if (shift) at.set(begin.x, at.y, begin.z);
        tell(false);
      },
      end: () => tell(true),
    };
  }

  private plantingDrag(planting: Planting, x: number, y: number): Drag {
    const foot = new Vector3(...planting.foot);
    const grip = this.target.groundUnder(this.aim(x, y), foot.y);
    const at = foot.clone();
    let moved = false;
    return {
      move: (ray) => {
        const hit = this.target.groundUnder(ray, foot.y);
        if (!hit || !grip) return;
        moved = true;
        at.set(foot.x + hit.x - grip.x, hit.y, foot.z + hit.z - grip.z);
        this.target.plantingMoved(planting, at, false);
      },
      end: () => moved && this.target.plantingMoved(planting, at, true),
    };
  }

  private wandered(x: number, y: number): boolean {
    return !this.down || Math.hypot(x - this.down.x, y - this.down.y) > CLICK;
  }

  private dragging = false;
  private move(event: PointerEvent): void {
    const [x, y] = this.place(event);
    if (!this.down && event.pointerType !== "touch") this.target.tool?.hover?.(this.aim(x, y));
    if (!this.drag || event.pointerId !== this.down?.id) return;
    this.dragging ||= this.wandered(x, y);
    if (this.dragging) this.drag.move(this.aim(x, y), event.shiftKey);
  }

  private end(event: PointerEvent): void {
    if (event.pointerId !== this.down?.id) return;
    const [x, y] = this.place(event);
    if (this.dragging) this.drag?.end();
    else if (!this.wandered(x, y)) {
      if (this.target.tool) this.target.tool.click(this.aim(x, y));
      else if (this.target.cameraAt(x, y)) this.target.flyToCamera();
      else if (!this.drag || !this.target.handleAt(x, y)) this.target.click(x, y, event.ctrlKey || event.metaKey || event.shiftKey);
    }
    this.release();
  }

  private release(): void {
    this.drag = null;
    this.dragging = false;
    this.down = null;
    this.target.holdEye(false);
  }
}
