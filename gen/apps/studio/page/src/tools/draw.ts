/** Strokes: what is drawn in the view becomes a line of points in the preset, whose points are then dragged. */

import { Plane, Raycaster, Vector3, type PerspectiveCamera } from "three";
import * as api from "../api";
import { reckon } from "../controls/reckon";
import { el } from "../dom";
import { handleAt, shapeOf, wayOf, type Key } from "../keyframes";
import { toPointer } from "../pointer";
import { round } from "../rounding";
import type { Store } from "../store";
import type { Drag, Tool } from "../view/tool";
import type { View } from "../view/view";
import { copied } from "./copied";
import { Marks, touches } from "../view/marks";
import { thinned } from "./thinned";
import { handleOf, slope, splinePlaces } from "./spline";
import { strokesFor, type Stroke, type StrokeLine, type StrokePoint } from "./strokes";
import { toolButton } from "./button";

const COLORS = { drawn: 0xffa63d, line: 0x6aa5ff, handle: 0x6aa5ff, chosen: 0xffffff, tangent: 0x59c36a };
/** How far ahead of the eye a stroke is shown whose depth is not known yet. */
const AHEAD = 1;
const PIECES = 16; // of a way from key to key
/** By how many metres keys move the chosen point, with Alt. */
const NUDGES: Record<string, Vector3> = {
  ArrowLeft: new Vector3(-0.1, 0, 0), ArrowRight: new Vector3(0.1, 0, 0), ArrowUp: new Vector3(0, 0, -0.1), ArrowDown: new Vector3(0, 0, 0.1),
  PageUp: new Vector3(0, 0.1, 0), PageDown: new Vector3(0, -0.1, 0),
};
const SMOOTH = 0.012; // of its length, that a stroke loses of its trembling

/** The end of a tangent. */
interface Handle {
  point: StrokePoint;
  way: "in" | "out";
  at: Vector3;
}

export class Draw implements Tool {
  readonly drawn = new Marks();
  readonly options: HTMLElement;
  private pixel = 0.001;
  private strokes: Stroke[] = [];
  private clicked: Raycaster[] = [];
  /** Where the point stands whose handles are shown. */
  private chosen = "";
  private what = el<HTMLSelectElement>("select", { "aria-label": "What is drawn", "data-testid": "draw-what", change: () => this.begin() });
  private width = el<HTMLInputElement>("input.number", { type: "text", size: 6, "aria-label": "Width", "data-testid": "draw-width" });
  private wide = el("label", {}, "Width ", this.width);
  private told = el("p", { role: "status", "data-testid": "draw-told" });
  private pull = el<HTMLInputElement>("input.number", { type: "text", size: 6, "aria-label": "Pull", "data-testid": "draw-pull" });
  private pulls = el("label", { "data-tip": "How strongly what follows it is led along it, 0 to 1" }, "Pull ", this.pull);
  private finish = el("button.small", { type: "button", disabled: true, "data-testid": "draw-finish", click: () => void this.done() }, "Finish");

  constructor(
    private store: Store,
    private view: View,
  ) {
    const button = (name: string, label: string, tip: string, click: () => void): HTMLElement => toolButton(`draw:${name}`, label, tip, click);
    this.options = el("div.tool-options", { "data-testid": "draw" }, el("div.cluster", {}, this.what, this.wide, this.pulls, this.finish),
      el("div.cluster", {},
        button("before", "◂", "The point before", () => this.chooseNext(-1)),
        button("after", "▸", "The point after", () => this.chooseNext(1)),
        button("smooth", "Smooth", "Gives the point handles, as a smooth line has them", () => this.smooth()),
        button("straight", "Straight", "Takes its handles away (Delete)", () => this.straighten())),
      this.told);
  }

  /** What can be drawn may be another now. */
  refresh(): void {
    const was = this.what.value;
    this.strokes = strokesFor(this.store, this.view);
    this.what.replaceChildren(...this.strokes.map((s) => el("option", { value: s.value }, s.label)));
    if (this.strokes.some((s) => s.value === was)) this.what.value = was;
    if (this.what.value !== was) this.begin();
    this.show();
  }

  private get stroke(): Stroke | undefined {
    return this.strokes.find((s) => s.value === this.what.value);
  }

  private begin(): void {
    this.clicked = [];
    this.finish.setAttribute("disabled", "");
    const { stroke } = this;
    this.wide.hidden = stroke?.width === undefined;
    this.pulls.hidden = stroke?.pull === undefined;
    if (stroke?.pull !== undefined) this.pull.value = String(stroke.pull);
    if (stroke?.width !== undefined) this.width.value = `${stroke.width} m`;
    this.told.textContent = stroke ? "Draw it with the mouse held down, or click its points and finish. Points are dragged, and so are the handles of the one that was touched last." : "Nothing can be drawn here.";
    this.show();
  }

  click(ray: Raycaster): void {
    const { stroke } = this;
    if (!stroke) return;
    const point = this.pointAt(stroke, ray);
    if (point) return this.choose(point);
    this.clicked.push(copied(ray));
    this.finish.toggleAttribute("disabled", this.clicked.length < 2);
    this.show();
  }

  drag(ray: Raycaster): Drag | null {
    const { stroke } = this;
    if (!stroke) return null;
    const handle = this.handles(stroke).find((h) => touches(ray.ray, h.at, this.pixel));
    if (handle) return this.handleDrag(stroke, handle);
    const point = this.pointAt(stroke, ray);
    if (point) return this.pointDrag(stroke, point);
    const rays = [copied(ray)];
    return {
      move: (now) => {
        rays.push(copied(now));
        this.show(rays);
      },
      end: () => void this.put(stroke, rays, true),
    };
  }

  scaleTo(camera: PerspectiveCamera, pixel: number): void {
    this.pixel = pixel;
    this.drawn.scaleTo(camera, pixel);
  }

  /** Enter puts a point where the middle of the window looks. */
  key(event: KeyboardEvent): boolean {
    if (event.key === "Enter") this.click(this.view.middle());
    else if (event.key === "Backspace") {
      this.clicked.pop();
      this.show();
    } else if (event.key === "Delete" && this.chosen) this.straighten();
    else if (event.altKey && event.key in NUDGES) this.nudge(NUDGES[event.key]!);
    else return false;
    return true;
  }

  private async done(): Promise<void> {
    const { stroke, clicked } = this;
    if (stroke && clicked.length > 1) await this.put(stroke, clicked, false);
    this.begin();
  }

  private pointAt(stroke: Stroke, ray: Raycaster): StrokePoint | undefined {
    return stroke.lines().flatMap((line) => line.points).find((p) => touches(ray.ray, p.at, this.pixel));
  }

  private choose(point: StrokePoint): void {
    this.chosen = toPointer(point.path);
    this.show();
  }

  /** The line of the chosen point, and its number there. */
  private chosenIn(stroke: Stroke): { line: StrokeLine; index: number } | null {
    for (const line of stroke.lines()) {
      const index = line.points.findIndex((p) => toPointer(p.path) === this.chosen);
      if (index >= 0) return { line, index };
    }
    return null;
  }

  /** Those of the chosen point; at a corner, where they would be if it were smooth. */
  private handles(stroke: Stroke): Handle[] {
    const found = this.chosenIn(stroke);
    if (!found) return [];
    const { points, smooth, closed, keys } = found.line;
    const point = points[found.index]!;
    if (keys) return this.keyHandles(keys, point, found.index);
    return (["in", "out"] as const).map((way) => {
      const offset = handleOf(points, found.index, way, smooth, closed) ?? slope(points, found.index, closed, way).multiplyScalar(way === "out" ? 1 : -1);
      return { point, way, at: point.at.clone().add(offset) };
    });
  }

  /** Where the way rests it has no tangent: there they are a third of the way to the next key. */
  private keyHandles(keys: Key[], point: StrokePoint, index: number): Handle[] {
    return (["in", "out"] as const).flatMap((way) => {
      const found = handleAt(keys, index, way);
      if (!found) return [];
      const offset = new Vector3(...(found as [number, number, number]));
      if (offset.length() < 1e-6) offset.fromArray(keys[index + (way === "out" ? 1 : -1)]![1] as number[]).sub(point.at).divideScalar(3);
      return [{ point, way, at: point.at.clone().add(offset) }];
    });
  }

  /** The point after or before the chosen one. */
  private chooseNext(by: number): void {
    const points = this.stroke?.lines().flatMap((line) => line.points) ?? [];
    const at = points.findIndex((p) => toPointer(p.path) === this.chosen);
    const next = points[at < 0 ? 0 : (at + by + points.length) % points.length];
    if (next) this.choose(next);
  }

  private nudge(by: Vector3): void {
    const found = this.stroke && this.chosenIn(this.stroke);
    if (!found || !this.stroke) return;
    const point = found.line.points[found.index]!;
    this.store.set(point.path, this.written(this.stroke, { ...point, at: point.at.clone().add(by) }));
    this.show();
  }

  /** The chosen point has the handles that it would have if the line were smooth there. */
  private smooth(): void {
    const handles = this.stroke ? this.handles(this.stroke) : [];
    const one = handles.at(-1);
    if (!one || !this.stroke) return;
    this.store.set(one.point.path, this.written(this.stroke, { ...one.point, [one.way]: one.at.clone().sub(one.point.at) }));
    this.show();
  }

  /** The chosen point is without handles again. */
  private straighten(): void {
    const found = this.stroke && this.chosenIn(this.stroke);
    if (!found || !this.stroke) return;
    const point = found.line.points[found.index]!;
    this.store.set(point.path, this.written(this.stroke, { ...point, in: undefined, out: undefined }));
    this.show();
  }

  private pointDrag(stroke: Stroke, point: StrokePoint): Drag {
    this.choose(point);
    return this.dragging(stroke, point, point.at, (at) => {
      this.store.set(point.path, this.written(stroke, { ...point, at }), toPointer(point.path));
    });
  }

  /** With Shift the other handle stays, so that there is a corner. */
  private handleDrag(stroke: Stroke, { point, way, at }: Handle): Drag {
    const gesture = `${toPointer(point.path)} ${way}`;
    const other = way === "in" ? "out" : "in";
    return this.dragging(stroke, point, at, (now, shift) => {
      const offset = now.clone().sub(point.at);
      const stays = point[other] ?? (shift && point[way] ? point[way].clone().negate() : undefined);
      this.store.set(point.path, this.written(stroke, { ...point, [way]: offset, [other]: stays }), gesture);
    });
  }

  /** What lies on the ground stays level; all else is dragged in the plane that faces the eye. */
  private dragging(stroke: Stroke, { key }: StrokePoint, from: Vector3, set: (at: Vector3, shift: boolean) => void): Drag {
    const plane = stroke.on === "ground" && !key ? new Plane(new Vector3(0, 1, 0), -from.y) : null;
    return {
      move: (ray, shift) => {
        const facing = plane ?? new Plane().setFromNormalAndCoplanarPoint(ray.ray.direction, from);
        const at = ray.ray.intersectPlane(facing, new Vector3());
        if (!at) return;
        set(at, shift);
        this.show();
      },
      end: () => this.store.endGesture(),
    };
  }

  /** A point as the preset has it: the place alone, or with its handles. */
  private written(stroke: Stroke, { at, in: back, out, rest, key }: StrokePoint): unknown {
    const place = stroke.spelled(at);
    const offset = (by: Vector3): number[] => stroke.spelled(at.clone().add(by)).map((x, k) => round(x - place[k]!));
    const handles = { ...(back ? { in: offset(back) } : {}), ...(out ? { out: offset(out) } : {}) };
    if (key) {
      const { ease } = shapeOf(key);
      const shape = back || out ? { ...(ease ? { ease } : {}), ...handles } : ease;
      return [key[0], place, ...(shape ? [shape] : [])];
    }
    return back || out || Object.keys(rest).length ? { at: place, ...handles, ...rest } : place;
  }

  private async put(stroke: Stroke, rays: Raycaster[], smooth: boolean): Promise<void> {
    try {
      const points = await this.placed(stroke, rays);
      const kept = smooth ? thinned(points, SMOOTH) : points;
      const wide = reckon(this.width.value, "m");
      if (kept.length < 2) this.told.textContent = "Nothing is there to draw on.";
      else stroke.draw(kept, "value" in wide ? wide.value : (stroke.width ?? 0), Math.min(1, Math.max(0, Number(this.pull.value.replace(",", ".")) || 0)));
    } catch (error) {
      this.told.textContent = (error as Error).message;
    }
    this.show();
  }

  /** Where rays meet what is drawn on; those that meet nothing are left out. */
  private async placed(stroke: Stroke, rays: Raycaster[]): Promise<Vector3[]> {
    if (typeof stroke.on === "object" && "plane" in stroke.on) {
      const plane = new Plane().setFromNormalAndCoplanarPoint(rays[0]!.ray.direction, stroke.on.plane);
      return rays.map((r) => r.ray.intersectPlane(plane, new Vector3())).filter((p) => p !== null);
    }
    if (stroke.on === "ground") return rays.map((r) => this.view.groundUnder(r, 0)).filter((p) => p !== null);
    const sent = rays.map((r) => [...r.ray.origin.toArray(), ...r.ray.direction.toArray()]);
    const hits = await api.trace(this.store.doc, this.store.time, sent, stroke.on);
    return hits.flatMap((hit) => (hit ? [new Vector3(...hit.at)] : []));
  }

  private show(rays: Raycaster[] = this.clicked): void {
    this.drawn.clear();
    for (const { points, smooth, closed, keys } of this.stroke?.lines() ?? []) {
      this.drawn.line(keys ? wayOf(keys, PIECES) : splinePlaces(points, smooth, closed).flatMap((p) => p.toArray()), COLORS.line);
      for (const point of points) this.drawn.handle(point.at, toPointer(point.path) === this.chosen ? COLORS.chosen : COLORS.handle);
    }
    for (const { point, at } of this.stroke ? this.handles(this.stroke) : []) {
      this.drawn.line([...point.at.toArray(), ...at.toArray()], COLORS.tangent);
      this.drawn.handle(at, COLORS.tangent);
    }
    const ahead = rays.map((r) => r.ray.at(AHEAD, new Vector3()));
    if (ahead.length) this.drawn.line(ahead.flatMap((p) => p.toArray()), COLORS.drawn);
    if (rays === this.clicked) for (const at of ahead) this.drawn.handle(at, COLORS.drawn);
    this.view.redraw();
  }
}
