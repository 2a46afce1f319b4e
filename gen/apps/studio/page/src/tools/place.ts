/** Plantings with the mouse: moved, turned, scaled, added, taken away, and scattered by a brush. */

import { Plane, Raycaster, Vector3, type PerspectiveCamera } from "three";
import { el } from "../dom";
import { getAt, isObject, type Path } from "../pointer";
import { round } from "../rounding";
import type { Store } from "../store";
import type { Drag, Tool } from "../view/tool";
import type { View } from "../view/view";
import { Marks, touches } from "../view/marks";
import { toolButton } from "./button";

const COLORS = { foot: 0xffffff, chosen: 0xffa63d, turn: 0x6aa5ff, size: 0x59c36a };
const SNAP = { metres: 0.25, degrees: 15 };
const RING = 70; // pixels, radius of the ring round the one that is chosen

interface Stance {
  turn?: number;
  size?: number;
}
type Spot = [number, number];


export class PlaceTool implements Tool {
  readonly drawn = new Marks();
  readonly options: HTMLElement;
  private pixel = 0.001;
  private eye = new Vector3();
  private chosen = 0;
  private snap = el<HTMLInputElement>("input", { type: "checkbox", "data-testid": "place-snap" });
  private brush = el<HTMLInputElement>("input", { type: "checkbox", "data-testid": "place-brush" });
  private told = el("p", { role: "status", "data-testid": "placed" });

  constructor(
    private store: Store,
    private view: View,
  ) {
    const button = (name: string, label: string, tip: string, click: () => void): HTMLElement => toolButton(`place:${name}`, label, tip, click);
    this.options = el(
      "div.tool-options", { "data-testid": "placing" }, this.told,
      el("div.cluster", {},
        button("before", "◂", "The one before", () => this.choose(this.chosen - 1)),
        button("after", "▸", "The one after", () => this.choose(this.chosen + 1)),
        button("copy", "One more", "Another beside it (Ctrl+D)", () => this.copy()),
        button("remove", "Remove", "Takes it away (Delete)", () => this.remove())),
      el("div.cluster", {}, el("label", {}, this.snap, " snap to 25 cm and 15°"), el("label", {}, this.brush, " scatter by dragging")),
    );
  }

  // What the preset says

  private get entry(): number | null {
    const { selected, preset } = this.store;
    return typeof selected === "number" && preset.organisms[selected] && !isObject(preset.organism(selected).sown) ? selected : null;
  }
  private path(name: "at" | "each"): Path {
    return ["organisms", this.entry!, "place", name];
  }
  private list(name: "at" | "each"): unknown[] {
    const list = this.entry === null ? null : getAt(this.store.preset.organism(this.entry), ["place", name]);
    return Array.isArray(list) ? (list as unknown[]) : [];
  }
  private get spots(): Spot[] {
    return this.list("at").filter((v): v is Spot => Array.isArray(v) && typeof v[0] === "number" && typeof v[1] === "number");
  }
  private stance(index: number): Stance {
    const one = this.list("each")[index];
    return isObject(one) ? (one as Stance) : {};
  }
  private foot(index: number): Vector3 {
    const [x, z] = this.spots[index]!;
    const shown = this.view.head?.specimens.find((s) => s.entry === this.entry && s.placed === index);
    return new Vector3(x, shown?.foot[1] ?? this.view.heightAt(x, z), z);
  }

  // The tool

  refresh(): void {
    this.chosen = Math.min(this.chosen, Math.max(0, this.spots.length - 1));
    this.show();
  }

  click(ray: Raycaster): void {
    const index = this.spots.findIndex((_, i) => touches(ray.ray, this.foot(i), this.pixel));
    if (index >= 0) return this.choose(index);
    const at = this.entry === null ? null : this.view.groundUnder(ray, 0);
    if (at) this.add([this.spotOf(at)]);
  }

  drag(ray: Raycaster): Drag | null {
    if (this.entry === null) return null;
    if (this.brush.checked) return this.scatter();
    const { spots, chosen } = this;
    if (spots.length) {
      const [turn, size] = this.handles();
      if (touches(ray.ray, turn, this.pixel)) return this.turnDrag();
      if (touches(ray.ray, size, this.pixel)) return this.sizeDrag(ray);
    }
    const index = [chosen, ...spots.keys()].find((i) => i < spots.length && touches(ray.ray, this.foot(i), this.pixel));
    if (index === undefined) return null;
    this.choose(index);
    return this.moveDrag(ray, index);
  }

  scaleTo(camera: PerspectiveCamera, pixel: number): void {
    const moved = this.pixel !== pixel || this.eye.distanceToSquared(camera.position) > 0;
    this.pixel = pixel;
    this.eye.copy(camera.position);
    if (moved) this.mark();
    this.drawn.scaleTo(camera, pixel);
  }

  key(event: KeyboardEvent): boolean {
    if (event.key === "Delete") this.remove();
    else if (event.key === "d" && (event.ctrlKey || event.metaKey)) this.copy();
    else if (event.key === "Enter") this.click(this.view.middle());
    else return false;
    return true;
  }

  // Drags

  private moveDrag(ray: Raycaster, index: number): Drag {
    const foot = this.foot(index);
    const plane = new Plane(new Vector3(0, 1, 0), -foot.y);
    const grip = ray.ray.intersectPlane(plane, new Vector3()) ?? foot.clone();
    const drag = this.changing(() => [...this.path("at"), index], (now) => {
      const hit = this.view.groundUnder(now, foot.y);
      return hit && this.spotOf(new Vector3(foot.x + hit.x - grip.x, 0, foot.z + hit.z - grip.z));
    });
    return drag;
  }

  private turnDrag(): Drag {
    const foot = this.foot(this.chosen);
    const plane = new Plane(new Vector3(0, 1, 0), -foot.y);
    return this.stanceDrag((now) => {
      const hit = now.ray.intersectPlane(plane, new Vector3());
      if (!hit) return null;
      const turn = (Math.atan2(hit.x - foot.x, hit.z - foot.z) * 180) / Math.PI;
      return { turn: this.snap.checked ? SNAP.degrees * Math.round(turn / SNAP.degrees) : round(turn, 1) };
    });
  }

  private sizeDrag(ray: Raycaster): Drag {
    const foot = this.foot(this.chosen);
    const plane = new Plane().setFromNormalAndCoplanarPoint(ray.ray.direction, foot);
    const far = (r: Raycaster): number => r.ray.intersectPlane(plane, new Vector3())?.distanceTo(foot) ?? 0;
    const [was, before] = [far(ray), this.stance(this.chosen).size ?? 1];
    return this.stanceDrag((now) => ({ size: round(Math.min(100, Math.max(0.01, (before * far(now)) / Math.max(was, 1e-6))), 2) }));
  }

  private stanceDrag(change: (ray: Raycaster) => Stance | null): Drag {
    return this.changing(() => this.path("each"), (ray) => {
      const one = change(ray);
      return one && this.stances(this.chosen, one);
    });
  }

  /** The list of stances with another one; those before it are as they were. */
  private stances(index: number, change: Stance): Stance[] {
    return Array.from({ length: Math.max(index + 1, this.list("each").length) }, (_, i) => (i === index ? { ...this.stance(i), ...change } : this.stance(i)));
  }

  private changing(path: () => Path, value: (ray: Raycaster) => unknown): Drag {
    const gesture = `place ${this.chosen} ${path().join("/")}`;
    return {
      move: (ray) => {
        const now = value(ray);
        if (now) this.store.set(path(), now, gesture);
        this.show();
      },
      end: () => this.store.endGesture(),
    };
  }

  /** One where there is room for it, as far from the others as `spacing` says. */
  private scatter(): Drag {
    const made: Spot[] = [];
    const spacing = Number(getAt(this.store.preset.organism(this.entry!), ["place", "spacing"]) ?? 0.35);
    const free = ([x, z]: Spot): boolean => [...this.spots, ...made].every(([a, b]) => Math.hypot(x - a, z - b) >= 2 * spacing);
    return {
      move: (ray) => {
        const at = this.view.groundUnder(ray, 0);
        if (!at) return;
        // Not in a row: each by a step of its own to the side of the pointer's way.
        const n = this.spots.length + made.length;
        const spot: Spot = [round(at.x + spacing * Math.cos(2.4 * n), 2), round(at.z + spacing * Math.sin(2.4 * n), 2)];
        if (!free(spot)) return;
        made.push(spot);
        this.show(made);
      },
      end: () => this.add(made),
    };
  }

  // Acts

  private choose(index: number): void {
    const n = this.spots.length;
    this.chosen = n ? (index + n) % n : 0;
    this.show();
  }

  private add(spots: Spot[]): void {
    const { entry, store } = this;
    if (entry === null || !spots.length) return;
    const all = [...this.spots, ...spots];
    const path = this.path("at");
    store.batch((text) => {
      let out = text;
      if (this.spots.length) spots.forEach((spot, i) => (out = store.edited(out, [...path, this.spots.length + i], spot)));
      else out = store.edited(out, path, all);
      const count = Number(store.preset.organism(entry).count ?? 1);
      return count < all.length ? store.edited(out, ["organisms", entry, "count"], all.length) : out;
    });
    this.choose(all.length - 1);
  }

  private copy(): void {
    const spot = this.spots[this.chosen];
    if (!spot) return;
    this.add([[round(spot[0] + 0.5), spot[1]]]);
  }

  private remove(): void {
    const { entry, store, chosen } = this;
    if (entry === null || !this.spots.length) return;
    const left = this.spots.filter((_, i) => i !== chosen);
    const each = this.list("each");
    const count = Number(store.preset.organism(entry).count ?? 1);
    store.batch((text) => {
      let out = store.edited(text, this.path("at"), left);
      if (each.length > chosen) out = store.edited(out, this.path("each"), each.filter((_, i) => i !== chosen));
      return count > 1 ? store.edited(out, ["organisms", entry, "count"], count - 1) : out;
    });
    this.choose(Math.max(0, chosen - 1));
  }

  private spotOf(at: Vector3): Spot {
    const near = (x: number): number => (this.snap.checked ? round(SNAP.metres * Math.round(x / SNAP.metres)) : round(x));
    return [near(at.x), near(at.z)];
  }

  // What is drawn

  /** Where the one that is chosen is turned and scaled by. */
  private handles(): [Vector3, Vector3] {
    const foot = this.foot(this.chosen);
    const ring = RING * this.pixel * foot.distanceTo(this.eye);
    const turn = ((this.stance(this.chosen).turn ?? 0) * Math.PI) / 180;
    return [new Vector3(ring * Math.sin(turn), 0, ring * Math.cos(turn)).add(foot), new Vector3(0, ring, 0).add(foot)];
  }

  private mark(more: Spot[] = []): void {
    this.drawn.clear();
    const { spots } = this;
    if (this.entry === null) return;
    spots.forEach((_, i) => this.drawn.handle(this.foot(i), i === this.chosen ? COLORS.chosen : COLORS.foot));
    for (const [x, z] of more) this.drawn.handle(new Vector3(x, this.view.heightAt(x, z), z), COLORS.chosen);
    if (!spots.length) return;
    const foot = this.foot(this.chosen);
    const [turn, size] = this.handles();
    const ring = turn.distanceTo(foot);
    this.drawn.line(Array.from({ length: 3 * 49 }, (_, i) => [foot.x + ring * Math.sin((Math.floor(i / 3) * Math.PI) / 24), foot.y, foot.z + ring * Math.cos((Math.floor(i / 3) * Math.PI) / 24)][i % 3]!), COLORS.turn, 0.6);
    this.drawn.line([...foot.toArray(), ...size.toArray()], COLORS.size, 0.6);
    this.drawn.handle(turn, COLORS.turn);
    this.drawn.handle(size, COLORS.size);
  }

  private show(more: Spot[] = []): void {
    this.mark(more);
    const { entry, spots, chosen } = this;
    if (entry === null) this.told.textContent = "Select an organism that is not sown.";
    else if (!spots.length) this.told.textContent = "Click on the ground to give it a place.";
    else {
      const { turn = 0, size = 1 } = this.stance(chosen);
      const [x, z] = spots[chosen]!;
      this.told.textContent = `${this.store.preset.nameOf(entry)} ${chosen + 1} of ${spots.length}: x ${x} m, z ${z} m, turn ${turn}°, size ${size}`;
    }
    this.view.redraw();
  }
}
