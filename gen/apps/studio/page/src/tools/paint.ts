/** A brush: how much of something there is, where, as a small picture beside the preset. */

import { CanvasTexture, Plane, Vector3, type PerspectiveCamera, type Raycaster } from "three";
import * as api from "../api";
import { el, pngOf } from "../dom";
import { beside } from "../preset";
import { round } from "../rounding";
import type { Store } from "../store";
import type { Drag, Tool } from "../view/tool";
import type { View } from "../view/view";
import { copied } from "./copied";
import { Marks } from "../view/marks";
import { maskables, newProjection, onPicture, pictureMatrix, projectionOf, written, type Maskable, type Projection } from "./masks";

const PIXELS = 512; // of the longer side of a picture
const RAYS = 200; // of a stroke, of which it is asked where they meet what is painted
const DOT = 0.01; // pixels: a line without a length has no ends that are drawn
const STEP = 1.25; // by which a key makes the brush larger

type Point = [number, number];

export class Paint implements Tool {
  readonly drawn = new Marks();
  readonly options: HTMLElement;
  private canvas = el<HTMLCanvasElement>("canvas", { width: PIXELS, height: PIXELS });
  /** The picture before the stroke that is being made. */
  private before = el<HTMLCanvasElement>("canvas", { width: PIXELS, height: PIXELS });
  private texture = new CanvasTexture(this.canvas);
  private masks: Maskable[] = [];
  private lies: Projection | null = null;
  /** What the canvas shows: the property and the file; null: nothing was read yet. */
  private shown: string | null = null;
  private told = el("p", { role: "status", "data-testid": "painted" });
  private what = el<HTMLSelectElement>("select", { "aria-label": "What is painted", "data-testid": "paint-what", change: () => this.show() });
  private size = el<HTMLInputElement>("input.slider", { type: "range", min: "-2", max: "1.3", step: "any", value: "0.5", "aria-label": "Radius of the brush in metres", "data-testid": "brush-size", input: () => this.tellSize() });
  private radius = el("output", {});
  private grey = el<HTMLInputElement>("input.slider", { type: "range", min: "0", max: "1", step: "0.05", value: "1", "aria-label": "How much of it there is then", "data-testid": "brush-value" });
  private strength = el<HTMLInputElement>("input.slider", { type: "range", min: "0.05", max: "1", step: "0.05", value: "1", "aria-label": "How strongly the brush paints", "data-testid": "brush-strength" });
  private erases = el<HTMLInputElement>("input", { type: "checkbox", "data-testid": "brush-erase" });

  constructor(
    private store: Store,
    private view: View,
  ) {
    this.texture.flipY = false;
    const fill = (name: string, label: string, tip: string, grey: number): HTMLElement =>
      el("button.small", { type: "button", "data-testid": `paint:${name}`, "data-tip": tip, click: () => void this.fill(grey) }, label);
    this.options = el(
      "div.tool-options", { "data-testid": "paint" }, el("div.cluster", {}, this.what), this.told,
      el("label", {}, "Radius ", this.size, this.radius), el("label", {}, "Amount ", this.grey), el("label", {}, "Strength ", this.strength),
      el("div.cluster", {}, el("label", {}, this.erases, " erase (X)"), fill("all", "All", "It is everywhere; begins anew, the way you look", 1), fill("none", "Nothing", "It is nowhere, until it is painted; begins anew, the way you look", 0)),
    );
    this.tellSize();
  }

  private get mask(): Maskable | undefined {
    return this.masks.find((m) => m.value === this.what.value);
  }
  private get metres(): number {
    return 10 ** Number(this.size.value);
  }
  private tellSize(): void {
    this.radius.textContent = ` ${this.metres.toPrecision(2)} m`;
  }

  refresh(): void {
    const was = this.mask;
    this.masks = maskables(this.store, this.view);
    this.what.replaceChildren(...this.masks.map((m) => el("option", { value: m.value }, m.label)));
    const { selected } = this.store;
    const own = this.masks.find((m) => m.path[0] === "organisms" && m.path[1] === selected) ?? this.masks[0];
    const stays = was && this.masks.some((m) => m.value === was.value) && (was.path[0] === "scene" || was.path[1] === selected);
    this.what.value = stays ? was.value : (own?.value ?? "");
    this.show();
  }

  private show(): void {
    const { mask } = this;
    this.lies = mask ? (projectionOf(this.store, this.view, mask) ?? newProjection(this.view, mask)) : null;
    if (!mask || !this.lies) {
      this.told.textContent = "Nothing here can be painted: select an organism that is sown, ivy, a rock, or a scene with grass, moss or snow.";
      return this.view.showPaint(null);
    }
    this.told.textContent = `Paint ${mask.label}, along ${this.lies.along}: black is none, white is all.`;
    void this.read(mask);
  }

  /** Taken out of the view. */
  leave(): void {
    this.view.showPaint(null);
  }

  click(ray: Raycaster): void {
    const drag = this.drag(ray);
    drag?.end();
  }

  drag(ray: Raycaster): Drag | null {
    const { mask, lies } = this;
    if (!mask || !lies) return null;
    const rays = [copied(ray)];
    this.context(this.before).drawImage(this.canvas, 0, 0);
    const guess = (): void => this.stroke(rays.map((r) => this.guessed(mask, lies, r)));
    guess();
    return {
      move: (now) => {
        rays.push(copied(now));
        guess();
      },
      end: () => void this.finish(mask, lies, rays),
    };
  }

  scaleTo(camera: PerspectiveCamera, pixel: number): void {
    this.drawn.scaleTo(camera, pixel);
  }

  key(event: KeyboardEvent): boolean {
    if (event.key === "Enter") this.click(this.view.middle());
    else if (event.key === "x" || event.key === "X") this.erases.checked = !this.erases.checked;
    else if (event.key === "[" || event.key === "]") {
      this.size.value = String(Number(this.size.value) + (event.key === "]" ? 1 : -1) * Math.log10(STEP));
      this.tellSize();
    } else return false;
    return true;
  }

  /** What the preset names; all white where it names nothing. */
  private async read(mask: Maskable): Promise<void> {
    const named = written(this.store, mask).file;
    const file = typeof named === "string" && named && projectionOf(this.store, this.view, mask) ? beside(this.store.file, named) : "";
    this.showPaint(mask);
    const shown = `${mask.value} ${file}`;
    if (shown === this.shown) return;
    this.shown = shown;
    this.shape();
    this.flood(1);
    if (!file) return;
    const picture = new Image();
    picture.src = api.paintedAddress(file);
    try {
      await picture.decode();
      if (this.shown === shown) this.context().drawImage(picture, 0, 0, this.canvas.width, this.canvas.height);
    } catch {
      this.told.textContent = `${String(named)} cannot be read.`;
    }
    this.changed();
  }

  private showPaint(mask: Maskable): void {
    if (this.lies) this.view.showPaint({ texture: this.texture, matrix: pictureMatrix(this.lies), on: mask.on });
  }

  /** The canvas as long and wide as what it covers. */
  private shape(): void {
    const { low, high } = this.lies!;
    const [wide, tall] = [high[0] - low[0], high[1] - low[1]];
    const pixels = PIXELS / Math.max(wide, tall, 1e-6);
    for (const canvas of [this.canvas, this.before]) [canvas.width, canvas.height] = [Math.max(1, Math.round(wide * pixels)), Math.max(1, Math.round(tall * pixels))];
    this.texture.dispose();
  }

  private context(of = this.canvas): CanvasRenderingContext2D {
    return of.getContext("2d")!;
  }
  private flood(grey: number): void {
    this.context().fillStyle = greyOf(grey);
    this.context().fillRect(0, 0, this.canvas.width, this.canvas.height);
    this.changed();
  }
  private changed(): void {
    this.texture.needsUpdate = true;
    this.view.redraw();
  }

  /** Where a ray meets what is painted, about: the ground, or the side of the organisms' box that faces the eye. */
  private guessed(mask: Maskable, lies: Projection, ray: Raycaster): Point | null {
    const { origin } = ray.ray;
    if (mask.on === "ground") return place(lies, this.view.groundUnder(ray, 0));
    const axis = { x: 0, y: 1, z: 2 }[lies.along];
    const boxes = mask.on.flatMap((i) => this.view.head?.entries[i] ?? []);
    const [low, high] = [Math.min(...boxes.map((b) => b.low[axis]!)), Math.max(...boxes.map((b) => b.high[axis]!))];
    const side = origin.getComponent(axis) > (low + high) / 2 ? high : low;
    return place(lies, ray.ray.intersectPlane(new Plane(new Vector3().setComponent(axis, 1), -side), new Vector3()));
  }

  /** One stroke over the picture as it was before; null where it is interrupted. */
  private stroke(points: (Point | null)[]): void {
    const { width, height } = this.canvas;
    const { low, high } = this.lies!;
    const context = this.context();
    context.drawImage(this.before, 0, 0);
    context.save();
    context.globalAlpha = Number(this.strength.value);
    context.strokeStyle = greyOf(this.erases.checked ? 0 : Number(this.grey.value));
    context.lineCap = context.lineJoin = "round";
    context.lineWidth = Math.max(1, (2 * this.metres * width) / Math.max(high[0] - low[0], 1e-6));
    context.beginPath();
    points.forEach((at, i) => {
      if (!at) return;
      const [x, y] = [at[0] * width, at[1] * height];
      if (!points[i - 1]) context.moveTo(x, y);
      context.lineTo(x + DOT, y);
    });
    context.stroke();
    context.restore();
    this.changed();
  }

  /** The stroke where its rays meet what is painted, into the preset. */
  private async finish(mask: Maskable, lies: Projection, rays: Raycaster[]): Promise<void> {
    try {
      const points = await this.met(mask, lies, rays);
      this.stroke(points);
      if (points.some((p) => p)) await this.save(mask, lies);
      else this.told.textContent = "Nothing is there to paint on.";
    } catch (error) {
      this.told.textContent = (error as Error).message;
    }
  }

  private async met(mask: Maskable, lies: Projection, rays: Raycaster[]): Promise<(Point | null)[]> {
    if (mask.on === "ground") return rays.map((r) => this.guessed(mask, lies, r));
    const step = Math.ceil(rays.length / RAYS);
    const some = rays.filter((_, i) => i % step === 0 || i === rays.length - 1);
    const sent = some.map((r) => [...r.ray.origin.toArray(), ...r.ray.direction.toArray()]);
    const hits = await api.trace(this.store.doc, this.store.time, sent, mask.on);
    return hits.map((hit) => hit && place(lies, new Vector3(...hit.at)));
  }

  /** All of one grey, the way one looks now. */
  private async fill(grey: number): Promise<void> {
    const { mask } = this;
    const lies = mask && newProjection(this.view, mask);
    if (!mask || !lies) return;
    this.lies = lies;
    this.shape();
    this.flood(grey);
    this.showPaint(mask);
    try {
      await this.save(mask, lies);
    } catch (error) {
      this.told.textContent = (error as Error).message;
    }
  }

  private async save(mask: Maskable, lies: Projection): Promise<void> {
    const name = `${mask.label.replace(/^(where|the) | (grows|creeps)$/g, "").replace(/\W+/g, "-")}-map.png`;
    const file = this.store.nameOfWritten(await api.painted(name, await pngOf(this.canvas), this.store.file));
    this.shown = `${mask.value} ${beside(this.store.file, file)}`;
    const land = (this.view.head?.land ?? 0) / 2;
    const whole = mask.on === "ground" && lies.along === "y" && lies.high[0] === land && lies.high[1] === land && lies.low[0] === -land;
    const { along: _, area: __, ...others } = written(this.store, mask);
    const value = { ...mask.beside, ...others, file };
    const corners = [lies.low, lies.high].map((c) => c.map((x) => round(x)));
    const laid = whole ? value : { ...value, ...(mask.on === "ground" && lies.along === "y" ? {} : { along: lies.along }), area: corners };
    this.store.set(mask.path, Object.keys(laid).length === 1 ? file : laid);
  }
}

const place = (lies: Projection, at: Vector3 | null): Point | null => at && onPicture(lies, at);
const greyOf = (share: number): string => `rgb(${[0, 0, 0].map(() => Math.round(255 * share)).join(" ")})`;
